#include "vtkBoleFilterTrack.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBoleFilterTrack)
