// A Kalman filter over a track. The stage `steering.filter` as a VTK algorithm: options, ports and method are those of
// the stage.
#ifndef vtkBoleFilterTrack_h
#define vtkBoleFilterTrack_h

#include "vtkBoleStage.h"
#include "vtkBoleSteeringModule.h"  // for export macro

class VTKBOLESTEERING_EXPORT vtkBoleFilterTrack : public vtkBoleStage {
 public:
  static vtkBoleFilterTrack* New();
  vtkTypeMacro(vtkBoleFilterTrack, vtkBoleStage)

 protected:
  vtkBoleFilterTrack() { this->SetStageType("steering.filter"); }
};

#endif
