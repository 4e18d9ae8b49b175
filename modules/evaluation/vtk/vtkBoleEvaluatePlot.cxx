#include "vtkBoleEvaluatePlot.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleEvaluatePlot)
