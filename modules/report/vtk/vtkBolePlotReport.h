// Writes tables, figures and the report of a plot. The stage `report.plot` as a VTK algorithm: options, ports and
// method are those of the stage.
#ifndef vtkBolePlotReport_h
#define vtkBolePlotReport_h

#include "vtkBoleReportModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEREPORT_EXPORT vtkBolePlotReport : public vtkBoleStage {
 public:
  static vtkBolePlotReport* New();
  vtkTypeMacro(vtkBolePlotReport, vtkBoleStage)

  // Adds the stages of the report to those that pipeline documents may name.
  static void RegisterStages();

 protected:
  vtkBolePlotReport();
};

#endif
