#include "vtkBoleSteeringErrors.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleSteeringErrors)
