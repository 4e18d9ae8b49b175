#include "vtkBoleFrameTrunks.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleFrameTrunks)
