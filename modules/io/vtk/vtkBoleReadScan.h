// Frames of a raw scan (pcap, KITTI folder) as time steps. The stage `io.read_scan` as a VTK algorithm: options, ports
// and method are those of the stage.
#ifndef vtkBoleReadScan_h
#define vtkBoleReadScan_h

#include "vtkBoleIOModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEIO_EXPORT vtkBoleReadScan : public vtkBoleStage {
 public:
  static vtkBoleReadScan* New();
  vtkTypeMacro(vtkBoleReadScan, vtkBoleStage)

 protected:
  vtkBoleReadScan() { this->SetStageType("io.read_scan"); }
};

#endif
