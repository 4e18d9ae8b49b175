// Writes what auto-steering stages found. The stage `report.steering` as a VTK algorithm: options, ports
// and method are those of the stage.
#ifndef vtkBoleSteeringReport_h
#define vtkBoleSteeringReport_h

#include "vtkBoleReportModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEREPORT_EXPORT vtkBoleSteeringReport : public vtkBoleStage {
 public:
  static vtkBoleSteeringReport* New();
  vtkTypeMacro(vtkBoleSteeringReport, vtkBoleStage)

 protected:
  vtkBoleSteeringReport();
};

#endif
