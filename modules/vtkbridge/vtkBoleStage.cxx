#include "vtkBoleStage.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleStage)
bool vtkBoleStage::SetOption(const char*, const char*) { return true; }
