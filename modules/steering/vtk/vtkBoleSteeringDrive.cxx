#include "vtkBoleSteeringDrive.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleSteeringDrive)
