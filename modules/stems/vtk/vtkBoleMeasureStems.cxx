#include "vtkBoleMeasureStems.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleMeasureStems)
