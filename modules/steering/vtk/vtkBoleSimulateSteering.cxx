#include "vtkBoleSimulateSteering.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleSimulateSteering)
