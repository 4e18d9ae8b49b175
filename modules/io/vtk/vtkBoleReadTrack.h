// The track of a receiver. The stage `io.read_track` as a VTK algorithm: options, ports and method are those of the
// stage.
#ifndef vtkBoleReadTrack_h
#define vtkBoleReadTrack_h

#include "vtkBoleIOModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEIO_EXPORT vtkBoleReadTrack : public vtkBoleStage {
 public:
  static vtkBoleReadTrack* New();
  vtkTypeMacro(vtkBoleReadTrack, vtkBoleStage)

 protected:
  vtkBoleReadTrack() { this->SetStageType("io.read_track"); }
};

#endif
