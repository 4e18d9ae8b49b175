#include "vtkBoleRowsReport.h"

#include "pipeline/stage.h"
#include "report/make_report.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleRowsReport)

vtkBoleRowsReport::vtkBoleRowsReport() {
  bole::report::register_stages(bole::pipeline::StageRegistry::global());
  this->SetStageType("report.rows");
}
