#include "vtkBoleSteeringReport.h"

#include "pipeline/stage.h"
#include "report/make_report.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleSteeringReport)

vtkBoleSteeringReport::vtkBoleSteeringReport() {
  bole::register_report_stages(bole::StageRegistry::global());
  this->SetStageType("report.steering");
}
