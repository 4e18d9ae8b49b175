#include "vtkBoleSurveyPlot.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleSurveyPlot)
