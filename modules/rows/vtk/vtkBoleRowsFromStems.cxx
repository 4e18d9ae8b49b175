#include "vtkBoleRowsFromStems.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleRowsFromStems)
