#include "vtkBoleSlam.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleSlam)
