// Trunk centres of a frame. The stage `rows.trunks` as a VTK algorithm: options, ports and method are those of the
// stage.
#ifndef vtkBoleFrameTrunks_h
#define vtkBoleFrameTrunks_h

#include "vtkBoleRowsModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEROWS_EXPORT vtkBoleFrameTrunks : public vtkBoleStage {
 public:
  static vtkBoleFrameTrunks* New();
  vtkTypeMacro(vtkBoleFrameTrunks, vtkBoleStage)

 protected:
  vtkBoleFrameTrunks() { this->SetStageType("rows.trunks"); }
};

#endif
