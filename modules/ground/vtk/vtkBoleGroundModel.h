// Ground points, terrain model and heights above ground. The stage `ground.model` as a VTK algorithm: options, ports
// and method are those of the stage.
#ifndef vtkBoleGroundModel_h
#define vtkBoleGroundModel_h

#include "vtkBoleGroundModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEGROUND_EXPORT vtkBoleGroundModel : public vtkBoleStage {
 public:
  static vtkBoleGroundModel* New();
  vtkTypeMacro(vtkBoleGroundModel, vtkBoleStage)

 protected:
  vtkBoleGroundModel() { this->SetStageType("ground.model"); }
};

#endif
