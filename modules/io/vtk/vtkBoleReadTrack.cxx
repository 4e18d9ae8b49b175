#include "vtkBoleReadTrack.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleReadTrack)
