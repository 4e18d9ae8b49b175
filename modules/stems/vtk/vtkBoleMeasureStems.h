// Stems with diameter and its interval. The stage `stems.measure` as a VTK algorithm: options, ports and method are
// those of the stage.
#ifndef vtkBoleMeasureStems_h
#define vtkBoleMeasureStems_h

#include "vtkBoleStage.h"
#include "vtkBoleStemsModule.h"  // for export macro

class VTKBOLESTEMS_EXPORT vtkBoleMeasureStems : public vtkBoleStage {
 public:
  static vtkBoleMeasureStems* New();
  vtkTypeMacro(vtkBoleMeasureStems, vtkBoleStage)

 protected:
  vtkBoleMeasureStems() { this->SetStageType("stems.measure"); }
};

#endif
