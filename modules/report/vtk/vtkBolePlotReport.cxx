#include "vtkBolePlotReport.h"

#include "pipeline/stage.h"
#include "report/make_report.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBolePlotReport)

vtkBolePlotReport::vtkBolePlotReport() {
  RegisterStages();
  this->SetStageType("report.plot");
}

void vtkBolePlotReport::RegisterStages() { bole::register_report_stages(bole::StageRegistry::global()); }
