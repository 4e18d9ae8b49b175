#include "vtkBoleSurveyFrame.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleSurveyFrame)
