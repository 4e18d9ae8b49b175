#include "vtkBoleBreastHeightSlice.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleBreastHeightSlice)
