#ifndef vtkBoleStage_h
#define vtkBoleStage_h

#include "vtkAlgorithm.h"
#include "vtkBoleBridgeModule.h"  // for export macro

class VTKBOLEBRIDGE_EXPORT vtkBoleStage : public vtkAlgorithm {
 public:
  static vtkBoleStage* New();
  vtkTypeMacro(vtkBoleStage, vtkAlgorithm)

  bool SetOption(const char* name, const char* value);

 protected:
  vtkBoleStage() = default;
  ~vtkBoleStage() override = default;

 private:
  vtkBoleStage(const vtkBoleStage&) = delete;
  void operator=(const vtkBoleStage&) = delete;
};

#endif
