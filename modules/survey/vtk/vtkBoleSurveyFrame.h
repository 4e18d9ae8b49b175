// Moves map and trajectory into plot axes by the two targets. The stage `survey.frame` as a VTK algorithm: options,
// ports and method are those of the stage.
#ifndef vtkBoleSurveyFrame_h
#define vtkBoleSurveyFrame_h

#include "vtkBoleStage.h"
#include "vtkBoleSurveyModule.h"  // for export macro

class VTKBOLESURVEY_EXPORT vtkBoleSurveyFrame : public vtkBoleStage {
 public:
  static vtkBoleSurveyFrame* New();
  vtkTypeMacro(vtkBoleSurveyFrame, vtkBoleStage)

 protected:
  vtkBoleSurveyFrame() { this->SetStageType("survey.frame"); }
};

#endif
