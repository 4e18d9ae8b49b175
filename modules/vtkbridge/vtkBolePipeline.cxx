#include "vtkBolePipeline.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "pipeline/printing.h"
#include "pipeline/register_all_stages.h"
#include "vtkBoleStage.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkbridge/executor.h"

vtkStandardNewMacro(vtkBolePipeline)

class vtkBolePipeline::Internals {
 public:
  std::unique_ptr<bole::vtkbridge::PipelineExecutor> executor;
  bole::vtkbridge::RunSettings settings;
  bole::vtkbridge::RunOutcome outcome;

  ~Internals() {
    cancel();
    if (worker_.joinable()) worker_.join();
  }

  bool guarded(vtkBolePipeline* self, const std::function<void()>& work) {
    try {
      refuse_while_running();
      work();
      return true;
    } catch (const bole::Error& e) {
      outcome.exit_code = e.exit_code(), outcome.error = e.what();
    } catch (const std::exception& e) {
      outcome.exit_code = 1, outcome.error = e.what();
    }
    vtkErrorWithObjectMacro(self, << outcome.error);
    return false;
  }

  bole::vtkbridge::PipelineExecutor& loaded() const {
    if (!executor) throw bole::bad_input("no pipeline is loaded", "LoadDocument() or ParseDocument() first");
    return *executor;
  }

  // `heard`: called after each step of the progress, in the thread that runs.
  void run(const std::function<void(double)>& heard) {
    bole::vtkbridge::RunSettings now = settings;
    now.sinks = !now.output_dir.empty();
    {
      const std::lock_guard lock(mutex_);
      now.cancel = cancel_.get_token();
    }
    now.progress = [this, &heard](const std::string& stage, double fraction, std::string_view what) {
      {
        const std::lock_guard lock(mutex_);
        stage_ = stage;
        text_ = what;
        progress_ = fraction;
      }
      if (heard) heard(fraction);
    };
    outcome = loaded().run(now);
  }

  void start() {
    loaded();
    if (worker_.joinable()) worker_.join();  // of a run that has ended
    renew_cancel();
    outcome = {};
    running_ = true;
    worker_ = std::thread([this] {
      try {
        run({});
      } catch (const std::exception& e) {
        outcome.exit_code = 1, outcome.error = e.what();
      }
      const std::lock_guard lock(mutex_);
      running_ = false;
      ended_.notify_all();
    });
  }

  bool wait(double seconds) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, std::chrono::duration<double>(std::max(0.0, seconds)), [this] { return !running_; });
  }

  bool running() const {
    const std::lock_guard lock(mutex_);
    return running_;
  }

  void renew_cancel() {
    const std::lock_guard lock(mutex_);
    cancel_ = std::stop_source();
  }
  void cancel() {
    const std::lock_guard lock(mutex_);
    cancel_.request_stop();
  }

  std::string current_stage() const {
    const std::lock_guard lock(mutex_);
    return stage_;
  }
  std::string progress_text() const {
    const std::lock_guard lock(mutex_);
    return text_;
  }
  double progress() const {
    const std::lock_guard lock(mutex_);
    return progress_;
  }

 private:
  void refuse_while_running() const {
    if (running()) throw bole::failure("a run goes on", "its end", "Wait(), or Cancel() first");
  }

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable ended_;
  std::stop_source cancel_;
  std::string stage_, text_;
  double progress_ = 0;
  bool running_ = false;

  std::thread worker_;
};

vtkBolePipeline::vtkBolePipeline() : Inner(std::make_unique<Internals>()) {
  bole::pipeline::register_all_stages(bole::pipeline::StageRegistry::global());
}
vtkBolePipeline::~vtkBolePipeline() = default;

bool vtkBolePipeline::LoadDocument(const char* path) {
  return this->Inner->guarded(this, [&] {
    this->Inner->executor = std::make_unique<bole::vtkbridge::PipelineExecutor>(
        bole::pipeline::PipelineDocument::load(path ? path : "", bole::pipeline::StageRegistry::global()));
    this->Modified();
  });
}

bool vtkBolePipeline::ParseDocument(const char* json) {
  return this->Inner->guarded(this, [&] {
    this->Inner->executor = std::make_unique<bole::vtkbridge::PipelineExecutor>(
        bole::pipeline::PipelineDocument::parse(json ? json : "", bole::pipeline::StageRegistry::global()));
    this->Modified();
  });
}

std::string vtkBolePipeline::GetDocumentJSON() const {
  return this->Inner->executor ? this->Inner->executor->document().to_json() : std::string();
}

std::string vtkBolePipeline::Validate() const {
  if (!this->Inner->executor) return "no pipeline is loaded";
  std::string text;
  for (const auto& problem : bole::pipeline::validate(this->Inner->executor->document()))
    text +=
        (text.empty() ? "" : "\n") + (problem.stage.empty() ? std::string() : problem.stage + ": ") + problem.message;
  return text;
}

bool vtkBolePipeline::SetOption(const char* stage_and_option, const char* value) {
  return this->Inner->guarded(this, [&] {
    this->Inner->loaded().set(stage_and_option ? stage_and_option : "", value ? value : "");
    this->Modified();
  });
}

bool vtkBolePipeline::SetOption(const char* stage_and_option, double value) {
  return this->SetOption(stage_and_option, bole::number_text(value).c_str());
}

bool vtkBolePipeline::TakeData(const char* stage, vtkDataObject* data) {
  return this->Inner->guarded(this, [&] {
    this->Inner->loaded().take_data(stage ? stage : "", data);
    this->Modified();
  });
}

void vtkBolePipeline::SetOutputDirectory(const char* folder) {
  this->Inner->settings.output_dir = folder ? folder : "";
}

void vtkBolePipeline::SetCacheDirectory(const char* folder) {
  this->Inner->settings.cache_dir.reset();
  if (folder && *folder) this->Inner->settings.cache_dir = folder;
}

void vtkBolePipeline::SetUseCache(bool use) { this->Inner->settings.use_cache = use; }

void vtkBolePipeline::SetNumberOfThreads(int threads) { this->Inner->settings.threads = threads; }
void vtkBolePipeline::SetAcceptPartial(bool accept) { this->Inner->settings.accept_partial = accept; }
void vtkBolePipeline::SetReplaceForeign(bool replace) { this->Inner->settings.replace_foreign = replace; }

bool vtkBolePipeline::Run() {
  return this->Inner->guarded(this, [&] {
    this->Inner->renew_cancel();
    this->Inner->run([this](double fraction) { this->InvokeEvent(vtkCommand::ProgressEvent, &fraction); });
  }) && this->Inner->outcome.exit_code == 0;
}

bool vtkBolePipeline::Start() {
  return this->Inner->guarded(this, [&] { this->Inner->start(); });
}

bool vtkBolePipeline::Wait(double seconds) { return this->Inner->wait(seconds); }
void vtkBolePipeline::Cancel() { this->Inner->cancel(); }

void vtkBolePipeline::Finish() {
  if (this->Inner->executor) this->Inner->executor->finish_running_stage();
}

int vtkBolePipeline::GetExitCode() const { return this->Inner->outcome.exit_code; }
std::string vtkBolePipeline::GetErrorText() const { return this->Inner->outcome.error; }
std::string vtkBolePipeline::GetSummaryJSON() const { return this->Inner->outcome.summary_json; }
std::string vtkBolePipeline::GetResultsDirectory() const { return this->Inner->outcome.results.string(); }
bool vtkBolePipeline::GetSurveyKept() const { return this->Inner->outcome.kept_before; }
int vtkBolePipeline::GetNumberOfStages() const {
  return this->Inner->executor ? static_cast<int>(this->Inner->executor->document().stages().size()) : 0;
}
std::string vtkBolePipeline::GetStageId(int index) const {
  return index >= 0 && index < this->GetNumberOfStages()
             ? this->Inner->executor->document().stages()[static_cast<std::size_t>(index)].id
             : std::string();
}

vtkBoleStage* vtkBolePipeline::GetStage(const char* id) {
  const bool usable = this->Inner->executor && !this->Inner->running();
  auto* stage = usable ? this->Inner->executor->stage(id ? id : "") : nullptr;
  if (stage) stage->FillOutputs();
  return stage;
}

std::string vtkBolePipeline::GetCurrentStage() const { return this->Inner->current_stage(); }
double vtkBolePipeline::GetProgress() const { return this->Inner->progress(); }
std::string vtkBolePipeline::GetProgressText() const { return this->Inner->progress_text(); }

std::string vtkBolePipeline::GetStagesJSON() {
  auto& registry = bole::pipeline::StageRegistry::global();
  bole::pipeline::register_all_stages(registry);
  return bole::pipeline::stages_json(registry);
}

std::string vtkBolePipeline::GetStagePage(const char* type) {
  auto& registry = bole::pipeline::StageRegistry::global();
  bole::pipeline::register_all_stages(registry);
  const auto* found = registry.find(type ? type : "");
  return found ? bole::pipeline::stage_markdown(*found) : std::string();
}

void vtkBolePipeline::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Stages: " << this->GetNumberOfStages() << "\n"
     << indent << "ExitCode: " << this->GetExitCode() << "\n"
     << indent << "Error: " << this->GetErrorText() << "\n";
}
