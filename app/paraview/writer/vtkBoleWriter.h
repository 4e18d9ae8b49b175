// Writes a cloud, a table or a trajectory as the results of `bole run` are written: LAS, LAZ, COPC or PLY, CSV, TUM.
// The ending of the file decides. With several processes the first one takes the whole data and writes.
#ifndef vtkBoleWriter_h
#define vtkBoleWriter_h

#include <string>  // for std::string

#include "vtkBoleWritersModule.h"  // for export macro
#include "vtkWriter.h"

class VTKBOLEWRITERS_EXPORT vtkBoleWriter : public vtkWriter {
 public:
  static vtkBoleWriter* New();
  vtkTypeMacro(vtkBoleWriter, vtkWriter)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetFileName(const char* path);
  std::string GetFileName() const { return this->FileName; }

 protected:
  vtkBoleWriter() = default;
  ~vtkBoleWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputs,
                             vtkInformationVector* outputs) override;
  void WriteData() override;

 private:
  vtkBoleWriter(const vtkBoleWriter&) = delete;
  void operator=(const vtkBoleWriter&) = delete;

  std::string FileName;
};

#endif
