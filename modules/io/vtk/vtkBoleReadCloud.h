// A point cloud file (LAS, LAZ, PLY, PCD, XYZ). The stage `io.read_cloud` as a VTK algorithm: options, ports and method
// are those of the stage.
#ifndef vtkBoleReadCloud_h
#define vtkBoleReadCloud_h

#include "vtkBoleIOModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEIO_EXPORT vtkBoleReadCloud : public vtkBoleStage {
 public:
  static vtkBoleReadCloud* New();
  vtkTypeMacro(vtkBoleReadCloud, vtkBoleStage)

 protected:
  vtkBoleReadCloud() { this->SetStageType("io.read_cloud"); }
};

#endif
