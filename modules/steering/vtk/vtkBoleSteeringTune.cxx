#include "vtkBoleSteeringTune.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleSteeringTune)
