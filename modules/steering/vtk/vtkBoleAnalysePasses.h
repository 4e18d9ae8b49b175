// The passes of a track and their errors. The stage `steering.analyse` as a VTK algorithm: options, ports and method
// are those of the stage.
#ifndef vtkBoleAnalysePasses_h
#define vtkBoleAnalysePasses_h

#include "vtkBoleStage.h"
#include "vtkBoleSteeringModule.h"  // for export macro

class VTKBOLESTEERING_EXPORT vtkBoleAnalysePasses : public vtkBoleStage {
 public:
  static vtkBoleAnalysePasses* New();
  vtkTypeMacro(vtkBoleAnalysePasses, vtkBoleStage)

 protected:
  vtkBoleAnalysePasses() { this->SetStageType("steering.analyse"); }
};

#endif
