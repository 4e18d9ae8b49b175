// What a running stage is told by the outside, and what it tells back.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "base/report.h"

namespace bole {
inline namespace cloud {
class Preview;  // cloud/preview.h
}
}  // namespace bole

namespace bole {
inline namespace base {

// What ran before in the same pipeline, for the stages that tell about it (report, summary).
struct OptionRecord {
  std::string name, value, unit;
  bool is_default = true;
};
struct StageRecord {
  std::string id, type;
  std::vector<OptionRecord> options;
  Report report;
  bool from_cache = false;
};
struct RunRecord {
  std::string document;  // path or title of the pipeline
  std::vector<StageRecord> stages;
};

// Passed by const reference to every stage. `cancel` throws the work away: a stage polls check_cancel() often enough to
// return within 0.5 s. `finish` keeps the best result so far: an iterative stage stops at the next good place.
// Progress is reported from the thread that called the stage, never from a worker; any thread may poll.
struct Run {
  std::function<void(double fraction, std::string_view what)> progress;  // fraction in [0, 1]
  std::stop_token cancel;
  std::stop_token finish;
  std::filesystem::path scratch_dir;  // for data too large for memory; the system's temporary folder when empty
  std::filesystem::path output_dir;   // where sink stages (report) write; empty: they refuse with a hint

  std::shared_ptr<const RunRecord> record;  // null outside a pipeline
  std::shared_ptr<Preview> preview;         // somebody who watches the work grow; null: nobody does

  void report(double fraction, std::string_view what) const {
    if (progress) progress(fraction, what);
  }
  bool cancelled() const { return cancel.stop_requested(); }
  bool asked_to_finish() const { return finish.stop_requested(); }

  // Throws Error{cancelled} when a cancel was asked for.
  void check_cancel() const;

  // A Run whose progress covers [begin, end] of this one's: for a stage made of parts.
  Run part(double begin, double end) const;
};

}  // namespace base
}  // namespace bole
