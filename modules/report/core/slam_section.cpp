#include "report/core/slam_section.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/option_text.h"
#include "cloud/table_columns.h"
#include "render/draw/axes.h"
#include "report/core/html.h"

namespace bole::report {
namespace {

struct Part {
  const char* metric;
  const char* title;
};

// Those that take their time for each frame, in the order of the work.
constexpr std::array<Part, 9> parts{{{"read_per_frame", "Reading"},
                                     {"features_per_frame", "Features"},
                                     {"guess_per_frame", "Prediction of the motion"},
                                     {"registration_per_frame", "Registration"},
                                     {"observability_per_frame", "Check of what each scan determines"},
                                     {"local_map_per_frame", "Local map"},
                                     {"loops_per_frame", "Loop closures and pose graph"},
                                     {"adjustment_per_frame", "Final adjustment"},
                                     {"map_per_frame", "Dense map"}}};

struct SlamMeasure {
  const char* metric;
  const char* title;
  const char* unit;
  int decimals;
  double factor;  // from the metric's unit to the shown one
};

constexpr std::array<SlamMeasure, 8> measures{
    {{"overlap", "Points of a frame that agree with the map, mean", "%", 1, 1},
     {"registration_rms", "Residual of the registration", "cm", 1, 100},
     {"sigma0", "Residuals of the adjustment by their expected size, mean (1: as expected)", "", 2, 1},
     {"pose_sigma", "Standard deviation of a position in its adjustment", "mm", 1, 1},
     {"weakest_observability", "Direction of motion that the scans determine least", "", 1, 1},
     {"loop_correction_rms", "Correction of the path by the loop closures, RMS", "cm", 1, 100},
     {"adjustment_rms_last", "Residual after the final adjustment", "cm", 1, 100},
     {"level_sigma", "Standard deviation of the vertical, by the inertial unit", "deg", 2, 1}}};

class SlamSection {
 public:
  SlamSection(const StageRecord& stage, const Table* loops, const Table* odometry, Report& told)
      : r_(stage.report), loops_(loops), odometry_(odometry), told_(told) {}

  std::string html() { return frames() + times() + loops(); }

 private:
  std::string count(const char* name) const {
    const auto it = r_.counts.find(name);
    return it == r_.counts.end() ? std::string() : std::to_string(it->second);
  }
  const Metric* metric(const char* name) const {
    const auto it = r_.metrics.find(name);
    return it == r_.metrics.end() ? nullptr : &it->second;
  }

  std::string frames() const {
    HtmlTable table{{{"Frames and loop closures"}, {"This run", true}, {"Unit"}}, {}, false};
    const auto add = [&](const char* title, const std::string& value) {
      if (!value.empty()) table.rows.push_back({title, value, ""});
    };
    add("Frames mapped", count("frames"));
    add("Frames that could not be registered", count("frames_failed"));
    if (const auto it = r_.facts.find("lost_at_frame"); it != r_.facts.end()) add("Track lost at frame", it->second);
    add("Keyframes", count("keyframes"));
    add("Places seen again that were tried as loop closures", count("loop_candidates"));
    add("Loop closures accepted", count("loops"));
    if (count("loops_by_context") != "0") add("Of these found by appearance", count("loops_by_context"));
    if (count("loops") != "0") add("Loop closures that contradict others", count("doubted_loops"));
    for (const auto& m : measures)
      if (const auto* found = metric(m.metric); found != nullptr)
        table.rows.push_back({m.title + limit(m.metric), render::fixed(m.factor * found->value, m.decimals), m.unit});
    return table.html() + failed_frames();
  }

  // " (below 2.3: not determined)": the limit that the stage itself used, where it names it.
  std::string limit(std::string_view name) const {
    const auto* open_below = name == "weakest_observability" ? metric("open_below") : nullptr;
    return open_below == nullptr ? std::string() : " (below " + number_text(open_below->value) + ": not determined)";
  }

  // The frames that did not agree with the map, by their time.
  std::string failed_frames() const {
    if (odometry_ == nullptr || !odometry_->has("ok") || odometry_->rows() == 0) return {};
    const auto ok = odometry_->numbers("ok"), frame = odometry_->numbers("frame"), time = odometry_->numbers("time_s");
    HtmlTable table{{{"Frame", true}, {"Time after the start (s)", true}, {"Overlap", true}}, {}, true};
    const auto overlap = numbers_or_nan(*odometry_, "overlap");
    for (std::size_t i = 0; i < ok.size(); ++i)
      if (ok[i] == 0)
        table.rows.push_back(
            {render::fixed(frame[i], 0), render::fixed(time[i] - time.front(), 1), render::fixed(overlap[i], 2)});
    return folded_and_counted("Failed frames", table);
  }

  std::string times() {
    HtmlTable table{{{"Time per frame"}, {"ms", true}}, {}, false};
    double sum = 0;
    for (const auto& p : parts)
      if (const auto* m = metric(p.metric); m != nullptr) {
        table.rows.push_back({p.title, render::fixed(m->value, 1)});
        sum += m->value;
      }
    if (table.rows.empty()) return {};
    table.rows.push_back({"all", render::fixed(sum, 1)});
    told_.metrics["slam_per_frame"] = {sum, Unit::millisecond};
    return table.html();
  }

  std::string loops() const {
    if (loops_ == nullptr || loops_->rows() == 0) return {};
    HtmlTable table{{{"From (s)", true},
                     {"To (s)", true},
                     {"Distance walked between (m)", true},
                     {"Correction (cm)", true},
                     {"Overlap", true},
                     {"Found by"}},
                    {},
                    true};
    const auto start = odometry_ != nullptr && odometry_->rows() > 0 ? numbers_or_nan(*odometry_, "time_s").front()
                                                                     : numbers_or_nan(*loops_, "from_time_s").front();
    const auto from = numbers_or_nan(*loops_, "from_time_s"), to = numbers_or_nan(*loops_, "to_time_s"),
               way = numbers_or_nan(*loops_, "way_m"), correction = numbers_or_nan(*loops_, "correction_m"),
               overlap = numbers_or_nan(*loops_, "overlap");
    const auto by = texts_or_empty(*loops_, "found_by");
    for (std::size_t i = 0; i < loops_->rows(); ++i)
      table.rows.push_back({render::fixed(from[i] - start, 1), render::fixed(to[i] - start, 1),
                            render::fixed(way[i], 1), render::fixed(100 * correction[i], 1),
                            render::fixed(overlap[i], 2), by[i]});
    return folded_and_counted("Loop closures", table);
  }

  static std::string folded_and_counted(const std::string& title, const HtmlTable& table) {
    return folded(title + " (" + std::to_string(table.rows.size()) + ")", table);
  }

  const Report& r_;
  const Table* loops_;
  const Table* odometry_;
  Report& told_;
};

}  // namespace

std::string slam_html(const StageRecord& stage, const Table* loops, const Table* odometry, Report& told) {
  const bool tracked_frames = stage.report.counts.contains("frames_failed");
  if (!tracked_frames || stage.report.facts.contains("trajectory")) return {};
  return SlamSection(stage, loops, odometry, told).html();
}

}  // namespace bole::report
