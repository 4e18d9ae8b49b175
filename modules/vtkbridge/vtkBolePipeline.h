// A pipeline document that runs: what `bole run` does, for C++, Python and host programs.
//
//   pipeline = bole.vtkBolePipeline()
//   pipeline.LoadDocument("forest_plot.json")
//   pipeline.SetOption("scan.file", "walk.pcap")
//   pipeline.SetOutputDirectory("out")
//   if not pipeline.Run(): print(pipeline.GetErrorText())
//   stems = pipeline.GetStage("stems").GetOutputDataObject(0)   # a vtkTable
//
// ProgressEvent is invoked while it runs: GetCurrentStage(), GetProgress() and GetProgressText() tell where it is. A
// second Run() after SetOption() runs the stage concerned and those after it. Start() and Wait() do the same in a
// thread of its own, without events: what bole.run() uses, so that Python stays awake for Ctrl-C and progress.
#ifndef vtkBolePipeline_h
#define vtkBolePipeline_h

#include <memory>  // for std::unique_ptr
#include <string>  // for std::string

#include "vtkBoleBridgeModule.h"  // for export macro
#include "vtkObject.h"

class vtkBoleStage;
class vtkDataObject;

class VTKBOLEBRIDGE_EXPORT vtkBolePipeline : public vtkObject {
 public:
  static vtkBolePipeline* New();
  vtkTypeMacro(vtkBolePipeline, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // A document from a file, or from JSON text (relative paths in it are then taken from the working directory). False
  // with an error when it cannot be used.
  bool LoadDocument(const char* path);
  bool ParseDocument(const char* json);
  std::string GetDocumentJSON() const;
  // What keeps the document from running, one problem per line; empty when it can run.
  std::string Validate() const;

  // "stage.option" and the value as on the command line.
  bool SetOption(const char* stage_and_option, const char* value);
  bool SetOption(const char* stage_and_option, double value);

  // A reader takes this data in place of its file: points (vtkPolyData) for io.read_cloud, a vtkTable for
  // io.read_table. They are copied. Null: the file again.
  bool TakeData(const char* stage, vtkDataObject* data);

  // Where sinks and summary.json go. Without one, stages that write files are left out. Results are cached in its
  // folder `cache` unless another is named or caching is off.
  void SetOutputDirectory(const char* folder);
  void SetCacheDirectory(const char* folder);
  void SetUseCache(bool use);
  // As the flags of `bole run`: --threads (0: one per processor), --accept-partial (on unless set), --force.
  void SetNumberOfThreads(int threads);
  void SetAcceptPartial(bool accept);
  void SetReplaceForeign(bool replace);

  // Runs what is not up to date. True when all stages ran well.
  bool Run();
  // The same in a thread of its own. False, with an error, when no document is loaded or one is running. Until Wait()
  // says that it has ended, nothing but progress can be asked for, and no option set.
  bool Start();
  // Waits for the end, at most so many seconds. True when nothing runs any more.
  bool Wait(double seconds);
  // From any thread: stop and throw the running stage's work away; or keep its best result so far and go on.
  void Cancel();
  void Finish();

  int GetExitCode() const;  // 0 ok, 1 failed, 2 bad input, 3 cancelled
  std::string GetErrorText() const;
  std::string GetSummaryJSON() const;
  std::string GetResultsDirectory() const;  // with what the run wrote, whole or not; empty when nothing was kept
  bool GetSurveyKept() const;               // the run failed, and the results before are still in the output folder

  int GetNumberOfStages() const;
  std::string GetStageId(int index) const;  // in document order
  // The stage object, with its outputs as VTK data objects once it ran. Null when there is none of that id, and while a
  // run goes on.
  vtkBoleStage* GetStage(const char* id);

  std::string GetCurrentStage() const;
  double GetProgress() const;
  std::string GetProgressText() const;

  // The declarations of all stages as JSON (`bole stages --json`), and the manual page of one as Markdown.
  static std::string GetStagesJSON();
  static std::string GetStagePage(const char* type);

 protected:
  vtkBolePipeline();
  ~vtkBolePipeline() override;

 private:
  vtkBolePipeline(const vtkBolePipeline&) = delete;
  void operator=(const vtkBolePipeline&) = delete;

  class Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
