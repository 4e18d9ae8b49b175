// A trajectory from a TUM or KITTI pose file. The stage `io.read_trajectory` as a VTK algorithm: options, ports and
// method are those of the stage.
#ifndef vtkBoleReadTrajectory_h
#define vtkBoleReadTrajectory_h

#include "vtkBoleIOModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEIO_EXPORT vtkBoleReadTrajectory : public vtkBoleStage {
 public:
  static vtkBoleReadTrajectory* New();
  vtkTypeMacro(vtkBoleReadTrajectory, vtkBoleStage)

 protected:
  vtkBoleReadTrajectory() { this->SetStageType("io.read_trajectory"); }
};

#endif
