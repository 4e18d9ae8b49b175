#include "vtkBoleProjectTable.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleProjectTable)
