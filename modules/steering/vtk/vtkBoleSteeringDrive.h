// A simulated test of auto-steering. The stage `steering.drive` as a VTK algorithm: options, ports and method are those
// of the stage.
#ifndef vtkBoleSteeringDrive_h
#define vtkBoleSteeringDrive_h

#include "vtkBoleStage.h"
#include "vtkBoleSteeringModule.h"  // for export macro

class VTKBOLESTEERING_EXPORT vtkBoleSteeringDrive : public vtkBoleStage {
 public:
  static vtkBoleSteeringDrive* New();
  vtkTypeMacro(vtkBoleSteeringDrive, vtkBoleStage)

 protected:
  vtkBoleSteeringDrive() { this->SetStageType("steering.drive"); }
};

#endif
