#include "vtkBoleReadScan.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleReadScan)
