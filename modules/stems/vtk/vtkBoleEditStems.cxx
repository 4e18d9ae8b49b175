#include "vtkBoleEditStems.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleEditStems)
