// The layer of points around breast height. The stage `stems.slice` as a VTK algorithm: options, ports and method are
// those of the stage.
#ifndef vtkBoleBreastHeightSlice_h
#define vtkBoleBreastHeightSlice_h

#include "vtkBoleStage.h"
#include "vtkBoleStemsModule.h"  // for export macro

class VTKBOLESTEMS_EXPORT vtkBoleBreastHeightSlice : public vtkBoleStage {
 public:
  static vtkBoleBreastHeightSlice* New();
  vtkTypeMacro(vtkBoleBreastHeightSlice, vtkBoleStage)

 protected:
  vtkBoleBreastHeightSlice() { this->SetStageType("stems.slice"); }
};

#endif
