// Plant rows from a table of stems. The stage `rows.from_stems` as a VTK algorithm: options, ports and method are those
// of the stage.
#ifndef vtkBoleRowsFromStems_h
#define vtkBoleRowsFromStems_h

#include "vtkBoleRowsModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEROWS_EXPORT vtkBoleRowsFromStems : public vtkBoleStage {
 public:
  static vtkBoleRowsFromStems* New();
  vtkTypeMacro(vtkBoleRowsFromStems, vtkBoleStage)

 protected:
  vtkBoleRowsFromStems() { this->SetStageType("rows.from_stems"); }
};

#endif
