// Why a stem is doubtful, and how it came to be: the sentences of the column "reasons" of the stem table. They stand in
// one table, so that a window can show each of them in its language.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bole::stems {

enum class StemReason {
  short_arc,
  arc_without_rays,
  wide_interval,
  few_points,
  extrapolated,
  interpolated,
  few_sections,
  points_inside,
  arc_inside,
  low_contrast,
  rough_bark,
  passes_disagree,
  wider_above,
  rays_through,
  leaning,
  forked,
  below_terrain,
  above_unseen_terrain,
  no_ground_near,
  foot_not_seen,
  ends_low,
  added,
  added_and_fitted,
  split,
  not_round,
  odd_taper,
  flares,
};

// A sentence of the table with its numbers. There is no other way to make one.
class Reason {
 public:
  Reason(StemReason why, std::initializer_list<double> numbers = {});
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// All sentences, in the order of StemReason; numbers are placeholders of fmt: "leans {:.0f} deg".
std::span<const std::string_view> stem_reason_formats();

// As the stem table has them: "leans 17 deg; only 4 sections".
std::string joined(const std::vector<Reason>& reasons);

}  // namespace bole::stems
