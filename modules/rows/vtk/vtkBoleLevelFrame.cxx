#include "vtkBoleLevelFrame.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleLevelFrame)
