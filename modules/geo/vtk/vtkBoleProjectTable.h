// Latitude and longitude of a table to metres of a plane, or back. The stage `geo.project` as a VTK algorithm: options,
// ports and method are those of the stage.
#ifndef vtkBoleProjectTable_h
#define vtkBoleProjectTable_h

#include "vtkBoleGeoModule.h"  // for export macro
#include "vtkBoleStage.h"

class VTKBOLEGEO_EXPORT vtkBoleProjectTable : public vtkBoleStage {
 public:
  static vtkBoleProjectTable* New();
  vtkTypeMacro(vtkBoleProjectTable, vtkBoleStage)

 protected:
  vtkBoleProjectTable() { this->SetStageType("geo.project"); }
};

#endif
