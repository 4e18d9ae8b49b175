// A pipeline document: the JSON text that says which stages run, how they are joined, and which options differ from
// their defaults. Everything that runs in Bole runs through one.
//
//   { "title": "...", "stages": [ {"id": "slice", "type": "stems.slice", "inputs": {"points": "ground.points"},
//   "options": {"height": 1.37}} ] }
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "pipeline/stage.h"

namespace bole::pipeline {

// One stage of a document. `inputs` joins a port of this stage to "id.port" of another.
struct StageNode {
  std::string id;
  const StageType* type = nullptr;
  std::map<std::string, std::string> inputs;
  OptionSet options;
  std::set<std::string> given;  // options named in the document or by set(); a preset does not touch these
  bool optional =
      false;  // "optional": true - skipped while an input path of it is empty (a reference that is not there)

  bool from_memory = false;  // the program that runs it gives its data (StageType::take): it needs no file

  bool skipped() const;
};

struct SourcePort {
  std::string id, port;
};

class PipelineDocument {
 public:
  // Reads a document. Relative input paths in it are taken from the document's folder. Throws Error{bad_input} naming
  // the file, the place in it and what was needed: not JSON, unknown key, unknown type, wrong option.
  static PipelineDocument load(const std::filesystem::path& path, const StageRegistry& registry);
  static PipelineDocument parse(std::string_view json_text, const StageRegistry& registry,
                                const std::filesystem::path& base_dir = {});

  // "stage.option" = text, as given on the command line; a relative path is taken from the working directory.
  void set(std::string_view stage_and_option, std::string_view text);

  const std::string& title() const { return title_; }
  const std::string& description() const { return description_; }
  const std::string& source() const { return source_; }  // the path it was loaded from, or empty
  const std::vector<StageNode>& stages() const { return stages_; }
  std::vector<StageNode>& stages() { return stages_; }
  const StageNode& at(std::string_view id) const;

  // The stages that run, so that each comes after those it takes from; document order otherwise. Skipped stages are
  // left out. Throws Error{bad_input} on a cycle.
  std::vector<const StageNode*> in_order() const;

  // The joints of a stage that lead to stages that run: its inputs less those from skipped stages.
  std::map<std::string, SourcePort> joints(const StageNode& node) const;

  // The document as JSON, options that differ from their defaults only.
  std::string to_json() const;

 private:
  std::string title_, description_, source_;
  std::vector<StageNode> stages_;
};

// "ground.points" -> {ground, points}. Throws Error{bad_input} when there is no dot.
SourcePort parse_source(std::string_view text);

// "stage.option=value", as given on a command line, one after the other. Throws Error{bad_input}.
void apply_sets(PipelineDocument& document, const std::vector<std::string>& assignments);

// What is wrong with a document as it stands: joints that lead nowhere, kinds that differ, inputs that are missing,
// arrays that no earlier stage makes, input files that are not there, relations between options. Empty when it can run.
struct Problem {
  std::string stage;    // id
  std::string message;  // what was found, what was needed, what to do
};
std::vector<Problem> validate(const PipelineDocument& document);

}  // namespace bole::pipeline
