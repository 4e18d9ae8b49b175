// Says which trees count: boundary and least diameter. The stage `survey.plot` as a VTK algorithm: options, ports and
// method are those of the stage.
#ifndef vtkBoleSurveyPlot_h
#define vtkBoleSurveyPlot_h

#include "vtkBoleStage.h"
#include "vtkBoleSurveyModule.h"  // for export macro

class VTKBOLESURVEY_EXPORT vtkBoleSurveyPlot : public vtkBoleStage {
 public:
  static vtkBoleSurveyPlot* New();
  vtkTypeMacro(vtkBoleSurveyPlot, vtkBoleStage)

 protected:
  vtkBoleSurveyPlot() { this->SetStageType("survey.plot"); }
};

#endif
