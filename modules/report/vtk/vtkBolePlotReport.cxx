#include "vtkBolePlotReport.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBolePlotReport)
