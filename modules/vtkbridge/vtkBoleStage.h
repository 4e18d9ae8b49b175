// A stage of Bole as a VTK algorithm. SetStageType() names the stage; ports and options follow from its declaration.
//
// Inputs may come from other stages (the core object rides along, nothing is converted) or from any VTK filter. Options
// are set by name; the modification time changes only when a value does. Errors go to ErrorEvent observers (or the
// output window), leave empty outputs, and can be read by GetErrorText() and GetExitCode(). SetAbortExecute(1) cancels,
// from any thread; Finish() asks for the best result so far. With a cache folder, results are kept on disk by the
// content of all that they depend on. A stage whose output is the frames of a scan offers them as VTK time steps.
//
// Several processes: readers that can give pieces of a cloud do; every other stage runs on piece 0, takes its inputs
// whole, and gives nothing as the other pieces. Results do not depend on the number of processes.
#ifndef vtkBoleStage_h
#define vtkBoleStage_h

#include <memory>  // for std::unique_ptr
#include <string>  // for std::string
#include <vector>  // for std::vector

#include "vtkAlgorithm.h"
#include "vtkBoleBridgeModule.h"  // for export macro

#ifndef __VTK_WRAP__  // the parser of VTK's wrappers does not know inline namespaces
namespace bole {
inline namespace base {
class OptionSet;
struct Report;
}  // namespace base
}  // namespace bole
namespace bole::pipeline {
struct StageType;
}
namespace bole::vtkbridge {
struct StageControl;
}
#endif

class VTKBOLEBRIDGE_EXPORT vtkBoleStage : public vtkAlgorithm {
 public:
  static vtkBoleStage* New();
  vtkTypeMacro(vtkBoleStage, vtkAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // The type ("stems.measure"). Options go back to their defaults. False when this build has no such stage.
  bool SetStageType(const char* name);
  std::string GetStageType() const;
  std::string GetTitle() const;

  // Options by name. False, with an error that says what is needed, when there is no such option or the value does not
  // fit.
  bool SetOption(const char* name, const char* value);
  bool SetOption(const char* name, double value);
  bool SetOption(const char* name, int value);
  void ResetOption(const char* name);
  std::string GetOption(const char* name);
  int GetNumberOfOptions() const;
  std::string GetOptionName(int index) const;
  std::string GetOptionHelp(const char* name);
  std::string GetOptionUnit(const char* name);
  bool IsOptionDefault(const char* name);

  // Ports by name; -1 when there is none.
  int FindInputPort(const char* name) const;
  int FindOutputPort(const char* name) const;
  std::string GetInputPortName(int port) const;
  std::string GetOutputPortName(int port) const;
  // Joins an input to the output of another stage; an empty producer disconnects.
  bool ConnectInput(const char* port, vtkBoleStage* producer, const char* producer_port);

  // A reader of clouds or tables takes this data in place of its file (null: the file again). It is copied. False, with
  // an error, for other stages and other data.
  bool TakeData(vtkDataObject* data);

  // Where sinks write, and where results are kept. No cache when empty (the default).
  void SetOutputDirectory(const char* folder);
  void SetCacheDirectory(const char* folder);

  // Whether clouds get a vertex cell, which mappers other than point mappers need to draw them (default: yes).
  void SetGenerateVertices(bool generate);
  bool GetGenerateVertices() const;

  // Whether clouds lie at their coordinates, in double precision, and not as offsets from their origin (default: no).
  // In programs that draw them beside tables and terrain, which have coordinates. Stages behind are not affected.
  void SetPlacePoints(bool place);
  bool GetPlacePoints() const;

  // From any thread, while the stage runs.
  void SetAbortExecute(int abort) override;
  void Finish();

  // How the last execution went.
  std::string GetReportJSON() const;
  std::string GetErrorText() const;
  int GetExitCode() const;    // 0 ok, 1 failed, 2 bad input, 3 cancelled
  bool GetFromCache() const;  // the result was taken from the cache
  int GetExecutionCount() const;

  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  // Asked for at the beginning of every update: the time to tell of extents that the last run has changed.
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs,
                           int port, vtkMTimeType* time) override;

  // For the executor; not seen by the wrappers.
  const bole::pipeline::StageType* GetType() const;
  void SetOptions(const bole::OptionSet& options);
  const bole::OptionSet* GetOptions() const;
  void SetControl(bole::vtkbridge::StageControl control);
  void DetachControl();  // forgets whom to report to and listen to; keeps cache and folders
  const bole::Report& GetReport() const;
  // Files that a sink wrote, and whether they are as it left them.
  std::vector<std::string> GetOutputFiles() const;
  bool OutputFilesPresent() const;

  // Makes VTK objects of outputs that were handed on as core objects alone. False, with an error, when that fails.
  bool FillOutputs();
  // Lets go of results that can be had again from the cache.
  void ReleaseResults();

 protected:
  vtkBoleStage();
  ~vtkBoleStage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

 private:
  vtkBoleStage(const vtkBoleStage&) = delete;
  void operator=(const vtkBoleStage&) = delete;

  bool RequestInformation(vtkInformationVector** inputs, vtkInformationVector* outputs);
  void RequestUpdateExtent(vtkInformationVector** inputs, vtkInformation* output);
  bool RequestData(vtkInformationVector** inputs, vtkInformationVector* outputs, vtkInformation* output);

  class Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
