#include "vtkBoleAnalysePasses.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleAnalysePasses)
