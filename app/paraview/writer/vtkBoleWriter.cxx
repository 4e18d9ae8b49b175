#include "vtkBoleWriter.h"

#include "io/core/clouds/cloud_writer.h"
#include "io/core/tables/table_decimals.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkbridge/core_conversion.h"
#include "vtkbridge/lazy_data.h"

vtkStandardNewMacro(vtkBoleWriter)

namespace {

bool is_first_process() {
  auto* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetLocalProcessId() == 0;
}

bole::Data core_of(vtkDataObject* object) {
  if (const auto known = bole::vtkbridge::attached(object)) return known->get();
  const bool is_table = vtkTable::SafeDownCast(object) != nullptr;
  return bole::vtkbridge::core_from_vtk(object, is_table ? bole::DataKind::table : bole::DataKind::cloud);
}

void write(const std::string& path, const bole::Data& data) {
  switch (bole::data_kind(data)) {
    case bole::DataKind::table:
      return bole::io::write_table(path, *std::get<std::shared_ptr<const bole::Table>>(data),
                                   bole::io::table_decimals());
    case bole::DataKind::cloud:
      return bole::io::write_cloud(path, *std::get<std::shared_ptr<const bole::PointCloud>>(data));
    case bole::DataKind::trajectory:
      return bole::io::write_tum(path, *std::get<std::shared_ptr<const bole::Trajectory>>(data));
    default:
      throw bole::bad_input("a " + std::string(bole::data_kind_name(bole::data_kind(data))) + " is connected",
                            "a cloud, a table or a trajectory");
  }
}

}  // namespace

void vtkBoleWriter::SetFileName(const char* path) {
  if (this->FileName == (path ? path : "")) return;
  this->FileName = path ? path : "";
  this->Modified();
}

int vtkBoleWriter::FillInputPortInformation(int /*port*/, vtkInformation* info) {
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

// The other processes ask for their pieces all the same: filters between may need all of them at work.
vtkTypeBool vtkBoleWriter::ProcessRequest(vtkInformation* request, vtkInformationVector** inputs,
                                          vtkInformationVector* outputs) {
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (request->Has(Pipeline::REQUEST_UPDATE_EXTENT())) {
    auto* controller = vtkMultiProcessController::GetGlobalController();
    const bool first = is_first_process();
    vtkInformation* info = inputs[0]->GetInformationObject(0);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), first ? 0 : controller->GetLocalProcessId());
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), first ? 1 : controller->GetNumberOfProcesses());
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

void vtkBoleWriter::WriteData() {
  if (!is_first_process()) return;
  try {
    if (this->FileName.empty()) throw bole::bad_input("no file is named", "a path", "Set FileName");
    write(this->FileName, core_of(this->GetInput()));
  } catch (const std::exception& e) {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< e.what());
  }
}

void vtkBoleWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
