#include "vtkBoleRowsReport.h"

#include "pipeline/stage.h"
#include "report/make_report.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleRowsReport)

vtkBoleRowsReport::vtkBoleRowsReport() {
  bole::register_report_stages(bole::StageRegistry::global());
  this->SetStageType("report.rows");
}
