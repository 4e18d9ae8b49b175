// What a fitted stem is worth, in words.
#pragma once

#include <optional>
#include <string>

#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

// Fewer points on the bark of a stem, all sections together, do not make a diameter that may be signed.
inline constexpr int points_for_a_diameter = 40;

// Sets quality (good, fair, poor), reasons and state (auto, check).
void judge(Stem& stem, double breast_height_m);

// Why a fit is no stem; nothing when it is one.
std::optional<std::string> objection(const Stem& stem, const MeasureOptions& options);

}  // namespace bole::stems
