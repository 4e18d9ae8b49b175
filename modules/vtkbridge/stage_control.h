// What the executor of a pipeline gives to its stages beyond VTK's own means.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string_view>

#include "base/run.h"

namespace bole::vtkbridge {

class ResultCache;

struct StageControl {
  std::stop_token cancel;
  std::stop_token finish;
  std::function<void(double fraction, std::string_view what)> progress;
  std::function<std::shared_ptr<const RunRecord>()> record;  // what ran before
  std::shared_ptr<Preview> preview;                          // null: nobody watches
  std::shared_ptr<ResultCache> cache;
  std::filesystem::path output_dir;
  // Where sinks write while the run goes on; empty: into output_dir. Their files lie in output_dir at the end.
  std::filesystem::path draft_dir;
  std::filesystem::path scratch_dir;
  // Outputs are handed on as core objects alone; vtkBoleStage::FillOutputs() makes VTK objects of them when somebody
  // looks.
  bool core_only = false;
};

}  // namespace bole::vtkbridge
