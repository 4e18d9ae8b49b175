#include "io/core/runs/plot_file.h"

#include <algorithm>
#include <array>

#include "base/angles.h"
#include "base/error.h"
#include "base/no_number.h"
#include "base/option.h"
#include "io/core/tables/table_file.h"

namespace bole::io {
namespace {

constexpr std::array numbers_of_rule{"centre_x_m", "centre_y_m", "width_m", "length_m", "min_dbh_cm"};

}  // namespace

void write_plot(const std::filesystem::path& path, const CountingRule& rule) {
  const Table plot = to_table(rule);
  Table file;
  const auto outline = rule.area.outline();
  const std::size_t rows = std::max<std::size_t>(1, outline.size());
  file.set("shape", std::vector<std::string>(rows, plot.facts.at("shape")));
  const auto& area = rule.area;
  file.set("centre_x_m", std::vector<double>(rows, area.centre.x()));
  file.set("centre_y_m", std::vector<double>(rows, area.centre.y()));
  file.set("width_m", std::vector<double>(rows, area.width_m));
  file.set("length_m", std::vector<double>(rows, area.length_m));
  file.set("bearing_deg", std::vector<double>(rows, area.bearing_rad * deg_per_rad));
  file.set("min_dbh_cm", std::vector<double>(rows, rule.min_dbh_cm));
  std::vector<double> x(rows, no_number), y(rows, no_number);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    x[i] = outline[i].x();
    y[i] = outline[i].y();
  }
  file.set("x_m", std::move(x));
  file.set("y_m", std::move(y));
  write_table(path, file);
}

CountingRule read_plot(const std::filesystem::path& path) {
  const Table file = read_table(path);
  if (file.rows() == 0) throw bad_input("'" + path.string() + "' has no row", "a file plot.csv of a survey");
  Table plot;
  plot.facts["shape"] = file.text("shape", 0);
  for (const char* name : numbers_of_rule) plot.facts[name] = number_text(file.numbers(name)[0]);
  plot.facts["bearing_rad"] = number_text(file.numbers("bearing_deg")[0] / deg_per_rad);
  const bool bounded = plot.facts.at("shape") != "none";
  plot.set("x_m", bounded ? file.numbers("x_m") : std::vector<double>());
  plot.set("y_m", bounded ? file.numbers("y_m") : std::vector<double>());
  auto rule = counting_rule(plot);
  if (bounded != (rule.area.shape != PlotArea::Shape::none))
    throw bad_input("'" + path.string() + "' has the shape '" + plot.facts.at("shape") + "'",
                    "rectangle, circle, polygon or none");
  if (rule.area.shape == PlotArea::Shape::polygon) rule.area = polygon_area(std::move(rule.area.vertices));
  return rule;
}

}  // namespace bole::io
