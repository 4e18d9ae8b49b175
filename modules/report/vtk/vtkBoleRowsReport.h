// Writes the tables, vector layers and map of plant rows. The stage `report.rows` as a VTK algorithm: options, ports
// and method are those of the stage.
#ifndef vtkBoleRowsReport_h
#define vtkBoleRowsReport_h

#include "vtkBoleReportModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEREPORT_EXPORT vtkBoleRowsReport : public vtkBoleStage {
 public:
  static vtkBoleRowsReport* New();
  vtkTypeMacro(vtkBoleRowsReport, vtkBoleStage)

 protected:
  vtkBoleRowsReport();
};

#endif
