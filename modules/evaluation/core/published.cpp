#include "evaluation/core/published.h"

#include <algorithm>
#include <array>

namespace bole::evaluation {
namespace {

struct Row {
  std::string_view measure;
  std::array<std::string_view, 5> figures;  // plots 1 to 4, overall
};

// Tables 2 and 3 of the paper, rows "improved LOAM".
constexpr std::array<Row, 12> rows{{
    {"position_mean_x", {"-0.048", "0.002", "0.027", "0.003", "-0.004"}},
    {"position_mean_y", {"-0.069", "0.008", "-0.001", "0.022", "-0.011"}},
    {"position_sigma_x", {"0.073", "0.062", "0.096", "0.062", "0.081"}},
    {"position_sigma_y", {"0.069", "0.059", "0.075", "0.086", "0.082"}},
    {"position_cov_xy", {"-0.001", "0.001", "-0.001", "-0.001", "0.000"}},
    {"position_sigma_max", {"0.077", "0.066", "0.098", "0.089", "0.082"}},
    {"position_rmse_x", {"0.087", "0.060", "0.100", "0.062", "0.081"}},
    {"position_rmse_y", {"0.097", "0.058", "0.075", "0.089", "0.083"}},
    {"dbh_bias", {"0.25", "0.65", "0.28", "-0.08", "0.25"}},
    {"dbh_relative_bias", {"1.22", "2.42", "1.89", "-0.59", "1.18"}},
    {"dbh_rmse", {"0.94", "1.07", "0.84", "1.23", "1.03"}},
    {"dbh_relative_rmse", {"4.87", "4.02", "5.64", "6.84", "5.53"}},
}};

}  // namespace

std::string published_figure(PublishedPlot plot, std::string_view measure) {
  const auto row = std::ranges::find(rows, measure, &Row::measure);
  if (plot == PublishedPlot::none || row == rows.end()) return {};
  return std::string(row->figures[static_cast<std::size_t>(plot) - 1]);
}

}  // namespace bole::evaluation
