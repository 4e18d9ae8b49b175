#include "steering/core/tuning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "steering/core/drive.h"

namespace bole::steering {
namespace {

constexpr double try_length_m = 60, judged_share = 0.4;  // of the way, at the end
constexpr double max_p = 1000, max_d = 300, max_i = 30;

class Tuner {
 public:
  Tuner(const TuneOptions& options, const Run& run)
      : o_(options), run_(run), gains_{options.first_preview, options.first_p, 0, 0} {
    o_.white_noise = o_.drift = o_.jumps_per_hour = o_.outages_per_hour = 0;
    o_.heading_noise_deg = o_.tilt_noise_deg = o_.wheel_disturbance_deg = o_.roughness_deg = 0;
    o_.steering_offset_deg = o_.side_slope_deg = 0;
  }

  Tuning result() {
    tune_preview();
    tune_p();
    tune_d();
    tune_i();
    return tables();
  }

 private:
  // Half the range of the offset over the last part of a drive: the swing that does not die away.
  double swing(const char* parameter, double value) {
    run_.check_cancel();
    run_.report(std::min(0.95, 0.01 * static_cast<double>(++tries_)), parameter);
    o_.preview = gains_.preview_m;
    o_.gain_p = gains_.p;
    o_.gain_i = gains_.i;
    o_.gain_d = gains_.d;
    const GuidanceLine line;
    Drive drive(o_, o_.speed_km_h, line, 1);
    drive.place({0, o_.start_offset}, 0);
    double low = 1e9, high = -1e9;
    const auto max_fixes = static_cast<int>(3 * try_length_m / (o_.speed_km_h / 3.6) * o_.rate);
    for (int i = 0; i < max_fixes && line.along_m(drive.truth()) < try_length_m; ++i) {
      drive.steer();
      const double offset = line.offset_m(drive.truth());
      if (line.along_m(drive.truth()) < (1 - judged_share) * try_length_m) continue;
      low = std::min(low, offset);
      high = std::max(high, offset);
    }
    const double found = high < low ? o_.start_offset : (high - low) / 2;
    parameter_.emplace_back(parameter);
    value_.push_back(value);
    swing_.push_back(found);
    return found;
  }
  bool oscillates(const char* parameter, double value) { return swing(parameter, value) > o_.oscillation; }

  void tune_preview() {
    auto& preview = gains_.preview_m;
    for (; preview > 0; preview -= 1)
      if (oscillates("preview", preview)) break;
    preview = std::max(preview, 0.0) + 1;
  }
  void tune_p() {
    while (!oscillates("P", gains_.p) && gains_.p < max_p) gains_.p += 5;
  }
  void tune_d() {
    while (oscillates("D", gains_.d)) {
      if (gains_.d >= max_d)
        throw failure(fmt::format("the loop oscillates at {} km/h with any D up to {}", o_.speed_km_h, max_d),
                      "a gain that calms it", "Lower first_p or the steering's delay and lag");
      gains_.d += 1;
    }
  }
  void tune_i() {
    while (gains_.i < max_i) {
      gains_.i += 1;
      if (!oscillates("I", gains_.i)) continue;
      gains_.i -= 1;
      return;
    }
  }

  Tuning tables() {
    Tuning t;
    t.steps.set("parameter", std::move(parameter_));
    t.steps.set("value", std::move(value_));
    t.steps.set("swing_m", std::move(swing_));
    const auto p = published_gains(o_.speed_km_h);
    const std::pair<const char*, double> columns[] = {{"speed_km_h", o_.speed_km_h},
                                                      {"preview_m", gains_.preview_m},
                                                      {"p", gains_.p},
                                                      {"i", gains_.i},
                                                      {"d", gains_.d},
                                                      {"published_preview_m", p.preview_m},
                                                      {"published_p", p.p},
                                                      {"published_i", p.i},
                                                      {"published_d", p.d}};
    for (const auto& [name, value] : columns) t.parameters.set(name, std::vector<double>{value});
    t.report.counts["tries"] = tries_;
    if (gains_.p >= max_p) t.report.warn(fmt::format("no oscillation up to P = {}, where the search ends", max_p));
    t.report.message = fmt::format("{} km/h: preview {} m, P {}, I {}, D {} (published {}, {}, {}, {})", o_.speed_km_h,
                                   gains_.preview_m, gains_.p, gains_.i, gains_.d, p.preview_m, p.p, p.i, p.d);
    return t;
  }

  TuneOptions o_;
  const Run& run_;
  Gains gains_;
  std::int64_t tries_ = 0;
  std::vector<std::string> parameter_;
  std::vector<double> value_, swing_;
};

}  // namespace

Tuning tune(const TuneOptions& options, const Run& run) { return Tuner(options, run).result(); }

}  // namespace bole::steering
