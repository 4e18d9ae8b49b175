// A table from a CSV file. The stage `io.read_table` as a VTK algorithm: options, ports and method are those of the
// stage.
#ifndef vtkBoleReadTable_h
#define vtkBoleReadTable_h

#include "vtkBoleIOModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEIO_EXPORT vtkBoleReadTable : public vtkBoleStage {
 public:
  static vtkBoleReadTable* New();
  vtkTypeMacro(vtkBoleReadTable, vtkBoleStage)

 protected:
  vtkBoleReadTable() { this->SetStageType("io.read_table"); }
};

#endif
