// Scan frames to a map and a trajectory. The stage `slam.run` as a VTK algorithm: options, ports and method are those
// of the stage.
#ifndef vtkBoleSlam_h
#define vtkBoleSlam_h

#include "vtkBoleSlamFiltersModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLESLAMFILTERS_EXPORT vtkBoleSlam : public vtkBoleStage {
 public:
  static vtkBoleSlam* New();
  vtkTypeMacro(vtkBoleSlam, vtkBoleStage)

 protected:
  vtkBoleSlam() { this->SetStageType("slam.run"); }
};

#endif
