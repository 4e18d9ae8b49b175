// Applies what a person decided about stems. The stage `stems.edit` as a VTK algorithm: options, ports and method are
// those of the stage.
#ifndef vtkBoleEditStems_h
#define vtkBoleEditStems_h

#include "vtkBoleStage.h"
#include "vtkBoleStemsModule.h"  // for export macro

class VTKBOLESTEMS_EXPORT vtkBoleEditStems : public vtkBoleStage {
 public:
  static vtkBoleEditStems* New();
  vtkTypeMacro(vtkBoleEditStems, vtkBoleStage)

 protected:
  vtkBoleEditStems() { this->SetStageType("stems.edit"); }
};

#endif
