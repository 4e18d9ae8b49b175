// A stage: a pure function of (inputs, options) plus a Run, with one declaration that everything else is derived from.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/data.h"
#include "cloud/piece.h"

namespace bole::pipeline {

struct Port {
  std::string name;
  DataKind kind = DataKind::none;
  std::string help;
  bool optional = false;
  // Inputs: arrays the cloud must have. Outputs: arrays the stage adds to the cloud.
  std::vector<ArrayInfo> arrays;
  // Outputs: a table of results, written into summary.json with all its rows.
  bool in_summary = false;
};

struct StageResult {
  DataSet outputs;
  Report report;
};

struct StageType {
  std::string name;  // "stems.fit": module, dot, verb or noun
  // "vtkBoleFitStems": the class that the build writes for this stage, in C++ and Python. Stands right after the name,
  // as a literal: the build reads both from the registration (resources/cmake/BoleStageClasses.cmake).
  std::string vtk_class;
  std::string title;   // "Fit stems"
  std::string help;    // a paragraph: what it does and by which method
  std::string source;  // paper and equation, or "Bole"
  int version = 1;     // raised when the same options give another result: old cache entries no longer match
  std::vector<Port> inputs;
  std::vector<Port> outputs;
  const OptionTable* options = nullptr;
  bool writes_files = false;  // a sink: writes into Run::output_dir
  // Keys of the report by which a run is judged, the most telling first: for headlines and comparisons.
  std::vector<std::string> main_numbers{};
  // The options with everything filled in that a run fills in ("as the preset says"); null: they are complete as given.
  std::function<OptionSet(const OptionSet& options)> in_force;
  std::function<StageResult(const DataSet& inputs, const OptionSet& options, const Run& run)> run;
  // Of a reader: the same with data in memory (of the kind of its first output) in place of its file, which the options
  // then need not name. Null: the stage takes none.
  std::function<StageResult(const Data& given, const OptionSet& options, const Run& run)> take;
  // Of a reader: one piece of what `run` gives. All pieces together hold every point once and have one origin. Null:
  // the stage gives everything at once.
  std::function<StageResult(const Piece& piece, const OptionSet& options, const Run& run)> run_piece;

  const Port* input(std::string_view port) const;
  const Port* output(std::string_view port) const;
};

// Checks inputs against the declared ports (presence, kind, arrays, emptiness is the stage's own affair), checks the
// options, runs, and fills in report.seconds and peak_mib. Errors get the stage's name in front.
StageResult run_stage(const StageType& type, const DataSet& inputs, const OptionSet& options, const Run& run);

// The same by StageType::take. Throws Error{bad_input} for a type that has none, and for data of another kind.
StageResult take_data(const StageType& type, const Data& given, const OptionSet& options, const Run& run);

// The same by StageType::run_piece. Throws Error{bad_input} for a type that has none.
StageResult run_piece(const StageType& type, const Piece& piece, const OptionSet& options, const Run& run);

class StageRegistry {
 public:
  // The registry that documents, programs and VTK objects use.
  static StageRegistry& global();

  // Throws Error{failed} when there is a type of that name already.
  void add(StageType type);
  // True the first time it is asked with this word: a module may be registered from several doors, but once.
  bool first_time(std::string_view module);
  const StageType* find(std::string_view name) const;
  const StageType& at(std::string_view name) const;  // throws Error{bad_input} with the nearest names
  std::vector<const StageType*> all() const;         // by name

 private:
  std::map<std::string, std::unique_ptr<StageType>, std::less<>> types_;
  std::set<std::string, std::less<>> modules_;
};

}  // namespace bole::pipeline
