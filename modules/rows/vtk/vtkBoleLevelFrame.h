// A levelled frame. The stage `rows.level` as a VTK algorithm: options, ports and method are those of the stage.
#ifndef vtkBoleLevelFrame_h
#define vtkBoleLevelFrame_h

#include "vtkBoleRowsModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEROWS_EXPORT vtkBoleLevelFrame : public vtkBoleStage {
 public:
  static vtkBoleLevelFrame* New();
  vtkTypeMacro(vtkBoleLevelFrame, vtkBoleStage)

 protected:
  vtkBoleLevelFrame() { this->SetStageType("rows.level"); }
};

#endif
