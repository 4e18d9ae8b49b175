#include "vtkBoleGroundModel.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleGroundModel)
