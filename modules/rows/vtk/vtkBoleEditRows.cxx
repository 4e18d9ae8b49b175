#include "vtkBoleEditRows.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleEditRows)
