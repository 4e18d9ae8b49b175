// A simulated steering test. The stage `steering.simulate` as a VTK algorithm: options, ports and method are those of the stage.
#ifndef vtkBoleSimulateSteering_h
#define vtkBoleSimulateSteering_h

#include "vtkBoleStage.h"
#include "vtkBoleSteeringModule.h"  // for export macro

class VTKBOLESTEERING_EXPORT vtkBoleSimulateSteering : public vtkBoleStage {
 public:
  static vtkBoleSimulateSteering* New();
  vtkTypeMacro(vtkBoleSimulateSteering, vtkBoleStage)

 protected:
  vtkBoleSimulateSteering() { this->SetStageType("steering.simulate"); }
};

#endif
