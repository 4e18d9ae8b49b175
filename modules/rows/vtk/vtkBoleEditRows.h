// Rows edited by a person. The stage `rows.edit` as a VTK algorithm: options, ports and method are those of the stage.
#ifndef vtkBoleEditRows_h
#define vtkBoleEditRows_h

#include "vtkBoleRowsModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEROWS_EXPORT vtkBoleEditRows : public vtkBoleStage {
 public:
  static vtkBoleEditRows* New();
  vtkTypeMacro(vtkBoleEditRows, vtkBoleStage)

 protected:
  vtkBoleEditRows() { this->SetStageType("rows.edit"); }
};

#endif
