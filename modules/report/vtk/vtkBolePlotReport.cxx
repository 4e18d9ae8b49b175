#include "vtkBolePlotReport.h"

#include "pipeline/stage.h"
#include "report/make_report.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBolePlotReport)

vtkBolePlotReport::vtkBolePlotReport() {
  RegisterStages();
  this->SetStageType("report.plot");
}

void vtkBolePlotReport::RegisterStages() { bole::report::register_stages(bole::pipeline::StageRegistry::global()); }
