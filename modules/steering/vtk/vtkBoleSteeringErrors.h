// Errors of a steering log. The stage `steering.errors` as a VTK algorithm: options, ports and method are those of the stage.
#ifndef vtkBoleSteeringErrors_h
#define vtkBoleSteeringErrors_h

#include "vtkBoleStage.h"
#include "vtkBoleSteeringModule.h"  // for export macro

class VTKBOLESTEERING_EXPORT vtkBoleSteeringErrors : public vtkBoleStage {
 public:
  static vtkBoleSteeringErrors* New();
  vtkTypeMacro(vtkBoleSteeringErrors, vtkBoleStage)

 protected:
  vtkBoleSteeringErrors() { this->SetStageType("steering.errors"); }
};

#endif
