#include "vtkbridge/stage_internals.h"

#include <vtkDataObject.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace bole::vtkbridge {

int port_index(const std::vector<pipeline::Port>& ports, const char* name) {
  const auto it = std::ranges::find(ports, std::string(name ? name : ""), &pipeline::Port::name);
  return it == ports.end() ? -1 : static_cast<int>(it - ports.begin());
}

std::string port_name(const std::vector<pipeline::Port>& ports, int index) {
  return index >= 0 && index < static_cast<int>(ports.size()) ? ports[static_cast<std::size_t>(index)].name
                                                              : std::string();
}

std::string port_list(const std::vector<pipeline::Port>& ports) {
  std::string list;
  for (const auto& port : ports) list += (list.empty() ? "" : ", ") + port.name;
  return list.empty() ? "none" : list;
}

void StopRequests::begin() {
  const std::lock_guard lock(mutex_);
  cancel_ = std::stop_source();
  finish_ = std::stop_source();
}

void StopRequests::cancel() {
  const std::lock_guard lock(mutex_);
  cancel_.request_stop();
}

void StopRequests::finish() {
  const std::lock_guard lock(mutex_);
  finish_.request_stop();
}

std::stop_token StopRequests::cancel_token() {
  const std::lock_guard lock(mutex_);
  return cancel_.get_token();
}

std::stop_token StopRequests::finish_token() {
  const std::lock_guard lock(mutex_);
  return finish_.get_token();
}

}  // namespace bole::vtkbridge

using bole::Error;

const bole::OptionSpec& vtkBoleStage::Internals::spec(const char* name) const {
  if (!type)
    throw bole::bad_input(
        wanted_type.empty() ? "no stage type is set" : "this build has no stage '" + wanted_type + "'",
        "a stage that `bole stages` lists");
  return type->options->at(name ? name : "");
}

void vtkBoleStage::Internals::change_option(vtkBoleStage* self, const char* name, const bole::OptionValue& value) {
  const auto before = options->get(name);
  options->set(name, value);
  if (options->get(name) != before) self->Modified();
}

bool vtkBoleStage::Internals::guarded(vtkBoleStage* self, const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const Error& e) {
    fail(self, e);
  } catch (const std::filesystem::filesystem_error& e) {
    fail(self, bole::failure("'" + e.path1().string() + "': " + e.code().message()));
  } catch (const std::exception& e) {
    fail(self, bole::failure(e.what()));
  }
  return false;
}

bool vtkBoleStage::Internals::accepted(vtkBoleStage* self, const std::function<void()>& work) {
  const int code_before = exit_code;
  const bool ok = guarded(self, work);
  exit_code = code_before;
  return ok;
}

void vtkBoleStage::Internals::fail(vtkBoleStage* self, const Error& error) {
  exit_code = error.exit_code();
  error_text = error.what();
  self->SetErrorCode(vtkErrorCode::UserError + static_cast<unsigned long>(exit_code));
  vtkErrorWithObjectMacro(self, << error_text);
}

std::shared_ptr<bole::vtkbridge::LazyData> vtkBoleStage::Internals::input(int port, vtkDataObject* object) {
  const auto& declared = type->inputs[static_cast<std::size_t>(port)];
  const bool gave_nothing = bole::vtkbridge::holds_nothing(object);
  try {
    if (!object) throw bole::bad_input("nothing is connected", declared.help);
    if (auto data = bole::vtkbridge::attached(object)) {
      if (data->kind() == declared.kind) return data;
      if (data->kind() == bole::DataKind::none) {  // a stage that had nothing to give
        if (declared.optional) return nullptr;
        throw bole::bad_input("the stage before gave nothing", declared.help);
      }
    }
    if (gave_nothing && declared.optional) return nullptr;
    return std::make_shared<bole::vtkbridge::LazyData>(bole::vtkbridge::core_from_vtk(object, declared.kind));
  } catch (const Error& e) {
    throw e.at("input '" + declared.name + "'").at(type->name);
  }
}

bole::Run vtkBoleStage::Internals::make_run(vtkBoleStage* self) {
  bole::Run run;
  run.cancel = stop.cancel_token();
  run.finish = stop.finish_token();
  const bool into_draft = type->writes_files && !control.draft_dir.empty();
  run.output_dir = into_draft ? control.draft_dir : control.output_dir;
  run.scratch_dir = control.scratch_dir;
  if (control.record) run.record = control.record();
  run.preview = control.preview;
  run.progress = [this, self](double fraction, std::string_view what) {
    self->SetProgressText(std::string(what).c_str());
    self->UpdateProgress(fraction);
    if (control.progress) control.progress(fraction, what);
    if (self->GetAbortExecute()) stop.cancel();  // set by somebody who knows VTK alone
  };
  return run;
}

bool vtkBoleStage::Internals::is_current(const vtkBoleStage* self, const bole::vtkbridge::PortData& inputs) const {
  return result && result_time_ >= const_cast<vtkBoleStage*>(self)->GetMTime() && inputs == result_inputs_;
}

bole::Piece vtkBoleStage::Internals::piece_wanted(vtkInformation* output) {
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!output || !output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES())) return {};
  return {output->Get(Pipeline::UPDATE_PIECE_NUMBER()), output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())};
}

bool vtkBoleStage::Internals::has_path() const {
  const auto path = std::ranges::find(type->options->specs, bole::TextKind::input_path, &bole::OptionSpec::text_kind);
  return path == type->options->specs.end() || !bole::option_text(path->get(options->raw())).empty();
}

void vtkBoleStage::Internals::take_up_piece(const bole::Piece& piece) {
  if (piece == piece_) return;
  std::swap(result, spare_.result);
  std::swap(result_time_, spare_.time);
  std::swap(result_inputs_, spare_.inputs);
  std::swap(piece_, spare_.piece);
  if (piece == piece_) return;
  result.reset();
  piece_ = piece;
}

// Pieces are not kept in the cache: which there are depends on the number of processes.
bole::vtkbridge::StageExecution vtkBoleStage::Internals::execute(vtkBoleStage* self,
                                                                 const bole::vtkbridge::PortData& inputs) {
  if (piece_.is_whole())
    return bole::vtkbridge::execute_stage(*type, *options, inputs, make_run(self), control.cache, control.output_dir);
  bole::vtkbridge::StageExecution execution;
  auto done = bole::pipeline::run_piece(*type, piece_, *options, make_run(self));
  for (const auto& [port, data] : done.outputs.all())
    execution.outputs[port] = std::make_shared<bole::vtkbridge::LazyData>(data);
  execution.report = std::move(done.report);
  return execution;
}

bool vtkBoleStage::Internals::update(vtkBoleStage* self, const bole::vtkbridge::PortData& inputs,
                                     const bole::Piece& piece) {
  take_up_piece(type->run_piece && !given && !piece.is_whole() ? piece : bole::Piece());
  if (is_current(self, inputs)) return true;
  result.reset();
  exit_code = 0;
  error_text.clear();
  self->SetErrorCode(vtkErrorCode::NoError);
  stop.begin();
  const std::stop_callback forward_cancel(control.cancel, [this] { stop.cancel(); });
  const std::stop_callback forward_finish(control.finish, [this] { stop.finish(); });
  return guarded(self, [&] {
    result = execute(self, inputs);
    result_inputs_ = inputs;
    result_time_ = self->GetMTime();
    if (!result->from_cache) ++executions;
  });
}

void vtkBoleStage::Internals::fill(int port, vtkDataObject* object, std::size_t step, bool core_only) {
  const auto& declared = type->outputs[static_cast<std::size_t>(port)];
  if (!result || !object) return;
  const auto it = result->outputs.find(declared.name);
  if (it == result->outputs.end()) {
    object->Initialize();
    return bole::vtkbridge::attach(object, std::make_shared<bole::vtkbridge::LazyData>(bole::Data()));
  }
  if (core_only) {
    object->Initialize();
  } else {
    bole::vtkbridge::to_vtk(it->second->get(), object, step);
    if (place_points && declared.kind == bole::DataKind::cloud)
      bole::vtkbridge::place_points(vtkPolyData::SafeDownCast(object));
    const bool drawn_as_points = declared.kind == bole::DataKind::cloud || bole::vtkbridge::has_steps(declared.kind);
    if (vertices && drawn_as_points) bole::vtkbridge::add_vertices(vtkPolyData::SafeDownCast(object));
    if (bole::vtkbridge::has_steps(declared.kind))
      if (const auto times = step_times_s(declared.name); step < times.size())
        object->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), times[step]);
  }
  bole::vtkbridge::attach(object, it->second);
}

std::vector<double> vtkBoleStage::Internals::step_times_s(const std::string& port) {
  return bole::vtkbridge::step_times_s(result->outputs.at(port)->get());
}

void vtkBoleStage::Internals::tell_times(const bole::pipeline::Port& port, vtkInformation* info) {
  info->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  info->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  if (!bole::vtkbridge::has_steps(port.kind) || !result || !result->outputs.contains(port.name) || control.core_only)
    return;
  const auto times = step_times_s(port.name);
  if (times.empty()) return;
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  const double range[]{times.front(), times.back()};
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
}

// VTK wants to know the extent of an image before it is made. Ours shows only once the stage has run: until then it is
// empty.
void vtkBoleStage::Internals::tell_extent(vtkDataObject* object, vtkInformation* info) {
  int extent[6]{0, -1, 0, -1, 0, -1};
  if (auto* image = vtkImageData::SafeDownCast(object); image && result) image->GetExtent(extent);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
}

void vtkBoleStage::Internals::tell_new_extents(vtkInformationVector* outputs) {
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port) {
    if (type->outputs[static_cast<std::size_t>(port)].kind != bole::DataKind::raster) continue;
    vtkInformation* info = outputs->GetInformationObject(port);
    std::array<int, 6> before{}, now{};
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), before.data());
    tell_extent(vtkDataObject::GetData(info), info);
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), now.data());
    new_extents_ = new_extents_ || now != before;
  }
}

// The result stays as it is.
void vtkBoleStage::Internals::tell_again(vtkBoleStage* self) {
  if (!new_extents_) return;
  new_extents_ = false;
  const bool current = result && result_time_ >= self->GetMTime();
  self->Modified();
  if (current) result_time_ = self->GetMTime();
}

std::size_t vtkBoleStage::Internals::step_wanted(int port, vtkInformation* info) {
  const auto& declared = type->outputs[static_cast<std::size_t>(port)];
  if (!bole::vtkbridge::has_steps(declared.kind) || control.core_only ||
      !info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
    return 0;
  const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
  const auto times = step_times_s(declared.name);
  // The last one that starts at or before the time asked for.
  const auto after = std::ranges::upper_bound(times, time);
  return after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
}
