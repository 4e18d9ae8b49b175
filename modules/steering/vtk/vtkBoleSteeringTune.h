// The tuning of auto-steering. The stage `steering.tune` as a VTK algorithm: options, ports and method are those of the
// stage.
#ifndef vtkBoleSteeringTune_h
#define vtkBoleSteeringTune_h

#include "vtkBoleStage.h"
#include "vtkBoleSteeringModule.h"  // for export macro

class VTKBOLESTEERING_EXPORT vtkBoleSteeringTune : public vtkBoleStage {
 public:
  static vtkBoleSteeringTune* New();
  vtkTypeMacro(vtkBoleSteeringTune, vtkBoleStage)

 protected:
  vtkBoleSteeringTune() { this->SetStageType("steering.tune"); }
};

#endif
