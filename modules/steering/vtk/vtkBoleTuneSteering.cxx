#include "vtkBoleTuneSteering.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleTuneSteering)
