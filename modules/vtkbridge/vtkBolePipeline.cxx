#include "vtkBolePipeline.h"

#include <mutex>
#include <optional>
#include <stop_token>

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
  std::mutex mutex;  // guards `cancel`
  std::stop_source cancel;
  std::string stage, text;
  double progress = 0;

  bool guarded(vtkBolePipeline* self, const std::function<void()>& work) {
    try {
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

void vtkBolePipeline::SetOutputDirectory(const char* folder) {
  this->Inner->settings.output_dir = folder ? folder : "";
}

void vtkBolePipeline::SetCacheDirectory(const char* folder) {
  this->Inner->settings.cache_dir.reset();
  if (folder && *folder) this->Inner->settings.cache_dir = folder;
}

void vtkBolePipeline::SetUseCache(bool use) { this->Inner->settings.use_cache = use; }

bool vtkBolePipeline::Run() {
  return this->Inner->guarded(this, [&] {
    auto& executor = this->Inner->loaded();
    bole::vtkbridge::RunSettings settings = this->Inner->settings;
    {
      const std::lock_guard lock(this->Inner->mutex);
      this->Inner->cancel = std::stop_source();
      settings.cancel = this->Inner->cancel.get_token();
    }
    settings.progress = [this](const std::string& stage, double fraction, std::string_view what) {
      this->Inner->stage = stage, this->Inner->text = what, this->Inner->progress = fraction;
      this->InvokeEvent(vtkCommand::ProgressEvent, &fraction);
    };
    this->Inner->outcome = executor.run(settings);
  }) && this->Inner->outcome.exit_code == 0;
}

void vtkBolePipeline::Cancel() {
  const std::lock_guard lock(this->Inner->mutex);
  this->Inner->cancel.request_stop();
}

void vtkBolePipeline::Finish() {
  if (this->Inner->executor) this->Inner->executor->finish_running_stage();
}

int vtkBolePipeline::GetExitCode() const { return this->Inner->outcome.exit_code; }
std::string vtkBolePipeline::GetErrorText() const { return this->Inner->outcome.error; }
std::string vtkBolePipeline::GetSummaryJSON() const { return this->Inner->outcome.summary_json; }
int vtkBolePipeline::GetNumberOfStages() const {
  return this->Inner->executor ? static_cast<int>(this->Inner->executor->document().stages().size()) : 0;
}
std::string vtkBolePipeline::GetStageId(int index) const {
  return index >= 0 && index < this->GetNumberOfStages()
             ? this->Inner->executor->document().stages()[static_cast<std::size_t>(index)].id
             : std::string();
}

vtkBoleStage* vtkBolePipeline::GetStage(const char* id) {
  auto* stage = this->Inner->executor ? this->Inner->executor->stage(id ? id : "") : nullptr;
  if (stage) stage->FillOutputs();
  return stage;
}

std::string vtkBolePipeline::GetCurrentStage() const { return this->Inner->stage; }
double vtkBolePipeline::GetProgress() const { return this->Inner->progress; }
std::string vtkBolePipeline::GetProgressText() const { return this->Inner->text; }

void vtkBolePipeline::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Stages: " << this->GetNumberOfStages() << "\n"
     << indent << "ExitCode: " << this->GetExitCode() << "\n"
     << indent << "Error: " << this->GetErrorText() << "\n";
}
