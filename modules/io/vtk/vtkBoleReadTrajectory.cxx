#include "vtkBoleReadTrajectory.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleReadTrajectory)
