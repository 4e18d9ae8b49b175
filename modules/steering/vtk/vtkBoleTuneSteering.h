// Gains of the steering by trial. The stage `steering.tune` as a VTK algorithm: options, ports and method are those of the stage.
#ifndef vtkBoleTuneSteering_h
#define vtkBoleTuneSteering_h

#include "vtkBoleStage.h"
#include "vtkBoleSteeringModule.h"  // for export macro

class VTKBOLESTEERING_EXPORT vtkBoleTuneSteering : public vtkBoleStage {
 public:
  static vtkBoleTuneSteering* New();
  vtkTypeMacro(vtkBoleTuneSteering, vtkBoleStage)

 protected:
  vtkBoleTuneSteering() { this->SetStageType("steering.tune"); }
};

#endif
