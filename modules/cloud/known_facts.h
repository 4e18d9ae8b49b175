// The facts that Bole knows: one table of keys, meanings and units for clouds, trajectories, tables and files. Other
// facts travel with the data too, as texts.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cloud/facts.h"

namespace bole {
inline namespace cloud {

// The key of a number ends with its unit, as in the columns of tables. A number outside [min, max] is damaged.
struct FactInfo {
  std::string_view key;
  std::string_view unit;  // empty for texts and choices
  double min = 0, max = 0;
  std::string_view meaning;
};

namespace facts {

inline constexpr FactInfo sensor{"sensor", "", 0, 0, "Name of the sensor model, for instance VLP-32C."};
inline constexpr FactInfo beam_divergence{"beam_divergence_mrad", "mrad", 0, 100,
                                          "Horizontal full angle of the beam (1/e^2)."};
inline constexpr FactInfo beam_aperture{"beam_aperture_m", "m", 0, 1,
                                        "Horizontal width of the beam where it leaves the sensor."};
inline constexpr FactInfo range_noise{"range_noise_m", "m", 0, 10, "Standard deviation of a single range."};
inline constexpr FactInfo clock{"clock", "", 0, 0, "Source of the times: utc, recorder, file or assumed."};
inline constexpr FactInfo poses{"poses", "", 0, 0, "Source of the poses: given or estimated."};
inline constexpr FactInfo level_sigma{"level_sigma_deg", "deg", 0, 90,
                                      "Standard deviation of the vertical, per axis, where gravity gave it."};
inline constexpr FactInfo breast_height{"breast_height_m", "m", 0.1, 5,
                                        "Height above ground at which diameters are measured."};
// Clouds, rasters and trajectories hold these two as members; tables hold them as facts.
inline constexpr FactInfo axes{"axes", "", 0, 0, "Axes of the coordinates: sensor, map, plot or global."};
inline constexpr FactInfo crs{"crs", "", 0, 0, "Coordinate reference system of global axes, as WKT."};

}  // namespace facts

// All of them, in the order above.
std::span<const FactInfo* const> known_facts();

enum class PoseOrigin { given, estimated };
constexpr std::array<std::string_view, 2> choice_names(PoseOrigin) { return {"given", "estimated"}; }

// utc: the sensor follows UTC; recorder: the clock of the recording computer; file: times of a file beside the frames;
// assumed: frames at an even period.
enum class Clock { utc, recorder, file, assumed };
constexpr std::array<std::string_view, 4> choice_names(Clock) { return {"utc", "recorder", "file", "assumed"}; }

// Nothing where the data do not have the fact. Numbers and choices throw Error{bad_input} where the text is none.
std::optional<std::string> fact_text(const Facts& facts, const FactInfo& info);
std::optional<double> fact_number(const Facts& facts, const FactInfo& info);
std::optional<PoseOrigin> pose_origin(const Facts& facts);

void set_fact(Facts& facts, const FactInfo& info, std::string_view text);
void set_fact(Facts& facts, const FactInfo& info, double number);  // to 9 digits
void set_fact(Facts& facts, PoseOrigin origin);
void set_fact(Facts& facts, Clock clock);

// For files: one line of JSON, ASCII only, {"beam_divergence_mrad":"3","sensor":"VLP-32C"}.
std::string facts_to_json(const Facts& facts);

// The facts of such a text. What is damaged (no JSON, no text, a known fact with a value that it cannot have) is left
// out, with a warning for each.
Facts facts_from_json(std::string_view json, std::vector<std::string>& warnings);

}  // namespace cloud
}  // namespace bole
