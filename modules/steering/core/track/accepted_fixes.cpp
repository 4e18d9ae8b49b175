#include "steering/core/track/accepted_fixes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "base/error.h"
#include "cloud/table_columns.h"

namespace bole::steering {
namespace {

// Standard deviation per axis that receivers of each quality usually have in the open, by GGA number.
double usual_sigma_m(std::int64_t quality) {
  switch (quality) {
    case 4:
      return 0.02;
    case 5:
      return 0.3;
    case 2:
    case 3:
    case 9:
      return 0.7;
    case -1:
      return unknown_sigma_m;
    default:
      return 2.5;
  }
}

std::set<std::int64_t> accepted_qualities(const std::string& list) {
  std::set<std::int64_t> accepted;
  std::string words = list;
  std::ranges::replace(words, ',', ' ');
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (word.size() != 1 || word[0] < '0' || word[0] > '9')
      throw bad_input("accept is '" + list + "': '" + word + "' is no fix quality", "digits of GGA sentences, 0 to 9",
                      "Write for instance \"4 5\"");
    accepted.insert(word[0] - '0');
  }
  if (accepted.empty()) throw bad_input("accept is empty", "at least one fix quality", "Write for instance \"4 5\"");
  return accepted;
}

class Fixes {
 public:
  Fixes(const Table& track, const NavigateOptions& options)
      : o_(options),
        time_(track.numbers("time_s")),
        x_(track.numbers("x_m")),
        y_(track.numbers("y_m")),
        quality_(numbers_or_nan(track, "quality")),
        sd_east_(numbers_or_nan(track, "sd_east_m")),
        sd_north_(numbers_or_nan(track, "sd_north_m")),
        run_(track.has("run") ? track.integers("run") : std::vector<std::int64_t>(track.rows(), 1)),
        accepted_(accepted_qualities(options.accept)) {
    // Quality 0 means no fix where a log tells qualities, and nothing where it tells none: RMC sentences alone.
    if (std::ranges::none_of(quality_, [](double q) { return q > 0; })) accepted_.insert(0);
  }

  std::vector<AntennaFix> good(FixesLeftOut& left_out) const {
    std::vector<AntennaFix> fixes;
    for (std::size_t i = 0; i < time_.size(); ++i) {
      AntennaFix fix{i,       time_[i], {x_[i], y_[i]}, 0, std::isfinite(quality_[i]) ? std::llround(quality_[i]) : -1,
                     run_[i], 1};
      if (!fix.antenna_nav.allFinite() || !std::isfinite(fix.time_s)) {
        ++left_out.without_place;
        continue;
      }
      ++left_out.by_quality[fix.quality];
      if (fix.quality != -1 && !accepted_.contains(fix.quality)) {
        ++left_out.poor;
        continue;
      }
      fix.sigma_m = sigma_of(i, fix.quality);
      if (!fixes.empty()) {
        const auto& last = fixes.back();
        const bool same_run = fix.run == last.run;
        if (same_run && !(fix.time_s > last.time_s)) {
          ++left_out.back_in_time;
          continue;
        }
        fix.segment = last.segment + (same_run && fix.time_s - last.time_s <= o_.max_gap ? 0 : 1);
      }
      fixes.push_back(fix);
    }
    return fixes;
  }

 private:
  double sigma_of(std::size_t i, std::int64_t quality) const {
    if (o_.position_sigma) return *o_.position_sigma;
    const double sd = std::sqrt((sd_east_[i] * sd_east_[i] + sd_north_[i] * sd_north_[i]) / 2);
    return sd > 0 ? std::max(sd, 1e-4) : usual_sigma_m(quality);
  }
  const NavigateOptions& o_;
  std::vector<double> time_, x_, y_, quality_, sd_east_, sd_north_;
  std::vector<std::int64_t> run_;
  std::set<std::int64_t> accepted_;
};

}  // namespace

std::string qualities_text(const FixesLeftOut& left_out) {
  std::string text;
  for (const auto& [quality, count] : left_out.by_quality)
    text += (text.empty() ? "" : ", ") + (quality == -1 ? std::string("unknown") : fmt::format("{}", quality)) +
            fmt::format(": {}", count);
  return text;
}

std::vector<AntennaFix> accepted_fixes(const Table& track, const NavigateOptions& options, FixesLeftOut& left_out) {
  return Fixes(track, options).good(left_out);
}

}  // namespace bole::steering
