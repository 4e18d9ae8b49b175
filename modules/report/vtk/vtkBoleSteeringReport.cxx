#include "vtkBoleSteeringReport.h"

#include "pipeline/stage.h"
#include "report/make_report.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleSteeringReport)

vtkBoleSteeringReport::vtkBoleSteeringReport() {
  bole::report::register_stages(bole::pipeline::StageRegistry::global());
  this->SetStageType("report.steering");
}
