#include "cloud/breast_height.h"

#include <charconv>

#include "base/error.h"
#include "base/option.h"

namespace bole {
inline namespace cloud {
namespace {

constexpr char breast_height_fact[] = "breast_height_m";
constexpr double min_m = 0.1, max_m = 5;

}  // namespace

double breast_height_m(const Table& stems) {
  const auto it = stems.facts.find(breast_height_fact);
  if (it == stems.facts.end()) return usual_breast_height_m;
  const std::string& text = it->second;
  double height = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), height);
  if (error != std::errc() || end != text.data() + text.size() || !(height >= min_m && height <= max_m))
    throw bad_input("the stem table says \"" + text + "\" for its breast height", "metres from 0.1 to 5",
                    "Measure the stems anew, or take the fact breast_height_m away");
  return height;
}

void set_breast_height_m(Table& stems, double height_m) { stems.facts[breast_height_fact] = number_text(height_m); }

}  // namespace cloud
}  // namespace bole
