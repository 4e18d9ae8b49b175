// What the scripts of the page need: stems, the walk and a thinned cloud, as JSON.
#pragma once

#include <string>

#include "base/run.h"
#include "report/survey_data.h"

namespace bole::report {

// Points of the 3-D view at most: enough to see stems and branches, few enough to mail.
inline constexpr std::size_t view_points = 120'000;

// A JSON object that can stand inside <script>: `stems` (id, x, y, z, dbh, lo, hi, height, seen, quality, state, why,
// look, inside; lengths in metres, diameters in cm), `shapes` (id, axis as x, y, z in turn, radius), `walk`, `outline`
// and `cloud`: count, lo, size (of the box, metres), top (height above ground of the value 255), positions (base64 of
// 16-bit x, y, z in the box), heights and trees (base64, 8 bit; the tree is its id modulo 255 plus 1, 0 for none).
// All coordinates are relative to `origin`. Without points there is no `cloud`.
std::string view_data_json(const SurveyData& data, const Run& run);

}  // namespace bole::report
