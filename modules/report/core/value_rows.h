// Plot values as a person reads them.
#pragma once

#include <string>
#include <vector>

#include "cloud/table.h"

namespace bole::report {

// The table plot_values of inventory.plot_values, by measure.
class PlotValues {
 public:
  struct Value {
    double value = 0;
    std::string unit;
    double half = 0, sampled_half = 0;  // half widths of the 95 % intervals; NaN where not known
  };

  explicit PlotValues(const Table& plot_values);
  // Throws Error{bad_input} where the table has no such measure.
  const Value& at(const std::string& measure) const;
  double value(const std::string& measure) const { return at(measure).value; }
  // "23.4", with a dash for a value that is not given.
  std::string text(const std::string& measure, int decimals) const;
  std::string count(const std::string& measure) const { return text(measure, 0); }
  bool given(const std::string& measure) const;
  // The same, also for measures that the tables of older versions do not have.
  bool has(const std::string& measure) const;

 private:
  std::vector<std::string> measures_;
  std::vector<Value> values_;
};

// Less than half of the basal area has a seen top: Lorey's height is then printed as "at least".
bool few_heights(const PlotValues& values);

struct ValueRow {
  std::string name, value, unit, how;
};
// `height_curve`: null or without rows where there is none.
std::vector<ValueRow> value_rows(const PlotValues& values, const Table* height_curve);

// "m2/ha" as "m²/ha".
std::string unit_text(const std::string& unit);

}  // namespace bole::report
