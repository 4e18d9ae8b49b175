#include "vtkBoleReadCloud.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleReadCloud)
