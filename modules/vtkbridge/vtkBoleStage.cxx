#include "vtkBoleStage.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pipeline/register_all_stages.h"
#include "pipeline/report_json.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkbridge/stage_internals.h"

vtkStandardNewMacro(vtkBoleStage)

using bole::Error;

vtkBoleStage::vtkBoleStage() : Inner(std::make_unique<Internals>()) {
  bole::pipeline::register_all_stages(bole::pipeline::StageRegistry::global());
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(0);
}

vtkBoleStage::~vtkBoleStage() = default;

// ---- type and options

bool vtkBoleStage::SetStageType(const char* name) {
  const std::string wanted = name ? name : "";
  if (this->Inner->type && this->Inner->type->name == wanted) return true;
  this->Inner->wanted_type = wanted;
  this->Inner->result.reset();
  this->Inner->type = bole::pipeline::StageRegistry::global().find(wanted);
  if (this->Inner->type) {
    this->Inner->options.emplace(*this->Inner->type->options);
    this->SetNumberOfInputPorts(static_cast<int>(this->Inner->type->inputs.size()));
    this->SetNumberOfOutputPorts(static_cast<int>(this->Inner->type->outputs.size()));
  } else {
    this->Inner->options.reset();
    this->SetNumberOfInputPorts(0);
    this->SetNumberOfOutputPorts(0);
  }
  this->Modified();
  return this->Inner->type != nullptr;
}

std::string vtkBoleStage::GetStageType() const { return this->Inner->wanted_type; }
std::string vtkBoleStage::GetTitle() const { return this->Inner->type ? this->Inner->type->title : std::string(); }

bool vtkBoleStage::SetOption(const char* name, const char* value) {
  return this->Inner->accepted(
      this, [&] { this->Inner->change_option(this, name, this->Inner->spec(name).parsed(value ? value : "")); });
}

bool vtkBoleStage::SetOption(const char* name, double value) {
  return this->Inner->accepted(this, [&] {
    const auto& spec = this->Inner->spec(name);
    // A slider of a host program gives whole numbers as doubles.
    const bool whole = spec.kind != bole::ValueKind::number && value == static_cast<double>(static_cast<int>(value));
    if (whole)
      this->SetOption(name, static_cast<int>(value));
    else
      this->Inner->change_option(this, name, value);
  });
}

bool vtkBoleStage::SetOption(const char* name, int value) {
  return this->Inner->accepted(this, [&] {
    const auto& spec = this->Inner->spec(name);
    if (spec.kind == bole::ValueKind::boolean && (value == 0 || value == 1))
      this->Inner->change_option(this, name, value == 1);
    else
      this->Inner->change_option(this, name, std::int64_t{value});
  });
}

void vtkBoleStage::ResetOption(const char* name) {
  this->Inner->accepted(this, [&] { this->Inner->change_option(this, name, this->Inner->spec(name).default_value); });
}

std::string vtkBoleStage::GetOption(const char* name) {
  std::string text;
  this->Inner->accepted(this,
                        [&] { text = bole::option_text(this->Inner->spec(name).get(this->Inner->options->raw())); });
  return text;
}

int vtkBoleStage::GetNumberOfOptions() const {
  return this->Inner->type ? static_cast<int>(this->Inner->type->options->specs.size()) : 0;
}

std::string vtkBoleStage::GetOptionName(int index) const {
  return index >= 0 && index < this->GetNumberOfOptions()
             ? this->Inner->type->options->specs[static_cast<std::size_t>(index)].name
             : std::string();
}

std::string vtkBoleStage::GetOptionHelp(const char* name) {
  std::string text;
  this->Inner->accepted(this, [&] { text = this->Inner->spec(name).help; });
  return text;
}

std::string vtkBoleStage::GetOptionUnit(const char* name) {
  std::string text;
  this->Inner->accepted(this, [&] { text = bole::unit_symbol(this->Inner->spec(name).unit); });
  return text;
}

bool vtkBoleStage::IsOptionDefault(const char* name) {
  bool is_default = false;
  this->Inner->accepted(this, [&] { is_default = this->Inner->options->is_default(this->Inner->spec(name).name); });
  return is_default;
}

void vtkBoleStage::SetOptions(const bole::OptionSet& options) {
  for (const auto& spec : options.table().specs)
    this->Inner->change_option(this, spec.name.c_str(), options.get(spec.name));
}

const bole::OptionSet* vtkBoleStage::GetOptions() const {
  return this->Inner->options ? &*this->Inner->options : nullptr;
}
const bole::pipeline::StageType* vtkBoleStage::GetType() const { return this->Inner->type; }

// ---- ports

int vtkBoleStage::FindInputPort(const char* name) const {
  return this->Inner->type ? bole::vtkbridge::port_index(this->Inner->type->inputs, name) : -1;
}
int vtkBoleStage::FindOutputPort(const char* name) const {
  return this->Inner->type ? bole::vtkbridge::port_index(this->Inner->type->outputs, name) : -1;
}

std::string vtkBoleStage::GetInputPortName(int port) const {
  return this->Inner->type ? bole::vtkbridge::port_name(this->Inner->type->inputs, port) : std::string();
}
std::string vtkBoleStage::GetOutputPortName(int port) const {
  return this->Inner->type ? bole::vtkbridge::port_name(this->Inner->type->outputs, port) : std::string();
}

bool vtkBoleStage::ConnectInput(const char* port, vtkBoleStage* producer, const char* producer_port) {
  return this->Inner->accepted(this, [&] {
    const int input = this->FindInputPort(port);
    if (input < 0)
      throw bole::bad_input(
          std::string("there is no input '") + (port ? port : "") + "'",
          "one of: " + (this->Inner->type ? bole::vtkbridge::port_list(this->Inner->type->inputs) : ""));
    if (!producer) return this->SetInputConnection(input, nullptr);
    const int output = producer->FindOutputPort(producer_port);
    if (output < 0)
      throw bole::bad_input(
          producer->GetStageType() + " has no output '" + (producer_port ? producer_port : "") + "'",
          "one of: " + (producer->GetType() ? bole::vtkbridge::port_list(producer->GetType()->outputs) : ""));
    this->SetInputConnection(input, producer->GetOutputPort(output));
  });
}

bool vtkBoleStage::TakeData(vtkDataObject* data) {
  return this->Inner->accepted(this, [&] {
    const auto* type = this->Inner->type;
    if (!type || !type->take)
      throw bole::bad_input("the stage " + this->Inner->wanted_type + " takes no data from memory", "a file",
                            "Set its option with the path");
    const auto kind = type->outputs.front().kind;
    auto known = data ? bole::vtkbridge::attached(data) : nullptr;
    if (!known || known->kind() != kind)
      known = data ? std::make_shared<bole::vtkbridge::LazyData>(bole::vtkbridge::core_from_vtk(data, kind)) : nullptr;
    this->Inner->given = std::move(known);
    this->Modified();
  });
}

int vtkBoleStage::FillInputPortInformation(int port, vtkInformation* info) {
  const auto& declared = this->Inner->type->inputs[static_cast<std::size_t>(port)];
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), bole::vtkbridge::vtk_input_class_name(declared.kind));
  if (declared.optional) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkBoleStage::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
            bole::vtkbridge::vtk_class_name(this->Inner->type->outputs[static_cast<std::size_t>(port)].kind));
  return 1;
}

// ---- control and answers

void vtkBoleStage::SetOutputDirectory(const char* folder) {
  const std::filesystem::path path = folder ? folder : "";
  if (this->Inner->control.output_dir == path) return;
  this->Inner->control.output_dir = path;
  if (this->Inner->type && this->Inner->type->writes_files) this->Modified();
}

void vtkBoleStage::SetCacheDirectory(const char* folder) {
  this->Inner->control.cache = folder && *folder ? std::make_shared<bole::vtkbridge::ResultCache>(folder) : nullptr;
}

void vtkBoleStage::SetGenerateVertices(bool generate) {
  if (this->Inner->vertices == generate) return;
  this->Inner->vertices = generate;
  this->Modified();
}
bool vtkBoleStage::GetGenerateVertices() const { return this->Inner->vertices; }

void vtkBoleStage::SetPlacePoints(bool place) {
  if (this->Inner->place_points == place) return;
  this->Inner->place_points = place;
  this->Modified();
}
bool vtkBoleStage::GetPlacePoints() const { return this->Inner->place_points; }

void vtkBoleStage::SetControl(bole::vtkbridge::StageControl control) {
  const bool moved =
      control.output_dir != this->Inner->control.output_dir && this->Inner->type && this->Inner->type->writes_files;
  this->Inner->control = std::move(control);
  if (moved) this->Modified();
}

void vtkBoleStage::DetachControl() {
  auto& control = this->Inner->control;
  control.progress = nullptr, control.record = nullptr, control.preview = nullptr;
  control.cancel = {}, control.finish = {};
  control.draft_dir.clear();
}

void vtkBoleStage::SetAbortExecute(int abort) {
  this->Superclass::SetAbortExecute(abort);
  if (abort) this->Inner->stop.cancel();
}

void vtkBoleStage::Finish() { this->Inner->stop.finish(); }

std::string vtkBoleStage::GetReportJSON() const {
  // Texts of files may be in any encoding.
  return bole::pipeline::report_to_json(this->GetReport())
      .dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}
const bole::Report& vtkBoleStage::GetReport() const {
  static const bole::Report none;
  return this->Inner->result ? this->Inner->result->report : none;
}
std::string vtkBoleStage::GetErrorText() const { return this->Inner->error_text; }
int vtkBoleStage::GetExitCode() const { return this->Inner->exit_code; }
bool vtkBoleStage::GetFromCache() const { return this->Inner->result && this->Inner->result->from_cache; }
int vtkBoleStage::GetExecutionCount() const { return this->Inner->executions; }
std::vector<std::string> vtkBoleStage::GetOutputFiles() const {
  std::vector<std::string> paths;
  if (this->Inner->result)
    for (const auto& file : this->Inner->result->files) paths.push_back(file.path);
  return paths;
}

bool vtkBoleStage::OutputFilesPresent() const {
  return !this->Inner->result || bole::vtkbridge::all_there(this->Inner->result->files);
}

bool vtkBoleStage::FillOutputs() {
  return this->Inner->guarded(this, [&] {
    this->Inner->control.core_only = false;
    for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port) {
      this->Inner->fill(port, this->GetOutputDataObject(port), 0, false);
      this->Inner->tell_times(this->Inner->type->outputs[static_cast<std::size_t>(port)],
                              this->GetOutputInformation(port));
    }
  });
}

void vtkBoleStage::ReleaseResults() {
  if (!this->Inner->result) return;
  for (auto& [port, data] : this->Inner->result->outputs) data->release();
}

void vtkBoleStage::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StageType: " << this->Inner->wanted_type << (this->Inner->type ? "\n" : " (not in this build)\n");
  if (!this->Inner->type) return;
  for (const auto& spec : this->Inner->type->options->specs)
    os << indent << "Option " << spec.name << ": " << bole::option_text(this->Inner->options->get(spec.name)) << "\n";
  if (!this->Inner->error_text.empty()) os << indent << "Error: " << this->Inner->error_text << "\n";
}

// ---- VTK's requests

int vtkBoleStage::ProcessRequest(vtkInformation* request, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs) {
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION())) return this->RequestInformation(inputs, outputs);
  const int port = request->Has(vtkExecutive::FROM_OUTPUT_PORT()) ? request->Get(vtkExecutive::FROM_OUTPUT_PORT()) : 0;
  vtkInformation* asked = outputs->GetInformationObject(std::max(port, 0));
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT())) this->RequestUpdateExtent(inputs, asked);
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA())) return this->RequestData(inputs, outputs, asked);
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkBoleStage::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
                                       vtkInformationVector* outputs, int port, vtkMTimeType* time) {
  this->Inner->tell_again(this);
  return this->Superclass::ComputePipelineMTime(request, inputs, outputs, port, time);
}

bool vtkBoleStage::RequestInformation(vtkInformationVector** /*inputs*/, vtkInformationVector* outputs) {
  if (!this->Inner->type) {
    this->Inner->fail(this, bole::bad_input(this->Inner->wanted_type.empty()
                                                ? "no stage type is set"
                                                : "this build has no stage '" + this->Inner->wanted_type + "'",
                                            "a stage that `bole stages` lists"));
    return false;
  }
  const auto& ports = this->Inner->type->outputs;
  // Times of frames and views are known once their reader ran. A source can be run now; after other stages they come
  // with the data.
  const bool has_steps =
      std::ranges::any_of(ports, [](const bole::pipeline::Port& p) { return bole::vtkbridge::has_steps(p.kind); });
  if (has_steps && this->Inner->type->inputs.empty() && this->Inner->has_path() && !this->Inner->update(this, {}))
    return false;
  for (std::size_t p = 0; p < ports.size(); ++p) {
    vtkInformation* info = outputs->GetInformationObject(static_cast<int>(p));
    info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    this->Inner->tell_times(ports[p], info);
    if (ports[p].kind == bole::DataKind::raster)
      this->Inner->tell_extent(this->GetOutputDataObject(static_cast<int>(p)), info);
  }
  return true;
}

void vtkBoleStage::RequestUpdateExtent(vtkInformationVector** inputs, vtkInformation* output) {
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const auto piece = Internals::piece_wanted(output);
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
    for (int c = 0; c < inputs[port]->GetNumberOfInformationObjects(); ++c) {
      vtkInformation* info = inputs[port]->GetInformationObject(c);
      // A stage takes all frames of a scan, whichever of them somebody looks at, and all pieces of a cloud.
      info->Remove(Pipeline::UPDATE_TIME_STEP());
      if (piece.is_whole() || piece.index != 0) continue;
      info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
}

bool vtkBoleStage::RequestData(vtkInformationVector** inputs, vtkInformationVector* outputs, vtkInformation* output) {
  this->Inner->exit_code = 0;
  const auto piece = Internals::piece_wanted(output);
  const bool gives_pieces = this->Inner->type && this->Inner->type->run_piece && !this->Inner->given;
  if (piece.count < 1 || (piece.index > 0 && !gives_pieces)) {
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
      if (auto* object = vtkDataObject::GetData(outputs, port)) object->Initialize();
    return true;
  }
  const bool done = this->Inner->guarded(this, [&] {
    if (!this->Inner->type) throw bole::bad_input("no stage type is set", "a stage that `bole stages` lists");
    bole::vtkbridge::PortData data;
    for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
      if (inputs[port]->GetNumberOfInformationObjects() > 0)
        if (auto core = this->Inner->input(port, vtkDataObject::GetData(inputs[port], 0)))
          data[this->GetInputPortName(port)] = std::move(core);
    if (this->Inner->given) data[bole::vtkbridge::given_port] = this->Inner->given;
    if (!this->Inner->update(this, data, piece)) return;
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port) {
      vtkInformation* info = outputs->GetInformationObject(port);
      this->Inner->fill(port, vtkDataObject::GetData(info), this->Inner->step_wanted(port, info),
                        this->Inner->control.core_only);
    }
    this->Inner->tell_new_extents(outputs);
  });
  if (done && this->Inner->exit_code == 0) return true;
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
    if (auto* object = vtkDataObject::GetData(outputs, port)) object->Initialize();
  return false;
}
