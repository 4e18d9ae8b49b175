#include "vtkBoleReadTable.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleReadTable)
