// Compares stems and trajectory with reference data. The stage `evaluation.plot` as a VTK algorithm: options, ports and
// method are those of the stage.
#ifndef vtkBoleEvaluatePlot_h
#define vtkBoleEvaluatePlot_h

#include "vtkBoleEvaluationModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEEVALUATION_EXPORT vtkBoleEvaluatePlot : public vtkBoleStage {
 public:
  static vtkBoleEvaluatePlot* New();
  vtkTypeMacro(vtkBoleEvaluatePlot, vtkBoleStage)

 protected:
  vtkBoleEvaluatePlot() { this->SetStageType("evaluation.plot"); }
};

#endif
