#include "evaluation/core/evaluate_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"

namespace bole::evaluation {
namespace {

double row_measure(const RowEvaluation& e, const std::string& name) {
  for (std::size_t i = 0; i < e.summary.rows(); ++i)
    if (e.summary.texts("measure")[i] == name) return e.summary.numbers("value")[i];
  throw std::runtime_error("no measure " + name);
}

Table plants(const std::vector<std::array<double, 3>>& list, const std::vector<std::array<double, 2>>& missing = {}) {
  std::vector<double> x, y;
  std::vector<std::int64_t> row;
  std::vector<std::string> state;
  for (const auto& [r, px, py] : list)
    row.push_back(static_cast<std::int64_t>(r)), x.push_back(px), y.push_back(py), state.emplace_back("present");
  for (const auto& [px, py] : missing)
    row.push_back(0), x.push_back(px), y.push_back(py), state.emplace_back("missing");
  Table t;
  t.set("row_id", row), t.set("x_m", x), t.set("y_m", y), t.set("state", state);
  return t;
}

TEST(EvaluateRows, PlantsTellRowsAssignmentAndMissing) {
  std::vector<std::array<double, 3>> truth, found;
  for (int i = 0; i < 10; ++i) truth.push_back({1, 2.0 * i, 0}), truth.push_back({2, 2.0 * i, 4});
  for (int i = 0; i < 10; ++i)
    found.push_back({7, 2.0 * i + 0.05, 0.1}), found.push_back({i < 8 ? 8.0 : 9.0, 2.0 * i, 4});
  const auto e = evaluate_rows(plants(found, {{3, 1}, {50, 50}}), plants(truth, {{3.1, 1}, {9, 9}}), {});
  EXPECT_NEAR(row_measure(e, "row_recall"), 50, 1e-9);  // row 2 is torn in two
  EXPECT_NEAR(row_measure(e, "row_precision"), 100.0 / 3, 1e-9);
  EXPECT_NEAR(row_measure(e, "plants_in_their_row"), 50, 1e-9);
  EXPECT_NEAR(row_measure(e, "missing_found"), 50, 1e-9);
  EXPECT_NEAR(row_measure(e, "missing_listed_right"), 50, 1e-9);
  EXPECT_NEAR(row_measure(e, "angle_error_max"), 0, 1e-9);
  EXPECT_EQ(e.rows.rows(), 4U);
}

TEST(EvaluateRows, ReferenceLinesReachFromTheFirstPlantToTheLast) {
  // y = 0.5 x + 1 with errors that leave the least-squares line where it is.
  const std::vector<std::array<double, 3>> truth{{1, 0, 1.1}, {1, 2, 1.8}, {1, 4, 3.2}, {1, 6, 3.9}};
  const auto e = evaluate_rows(plants(truth), plants(truth), {});
  ASSERT_EQ(e.reference_lines.rows(), 2U);
  const auto x = e.reference_lines.numbers("x_m"), y = e.reference_lines.numbers("y_m");
  const double slope = (y[1] - y[0]) / (x[1] - x[0]);
  EXPECT_NEAR(std::atan(slope) * 180 / M_PI, e.rows.numbers("ref_angle_deg")[0], 1e-9);
  EXPECT_NEAR(y[0] + slope * (3 - x[0]), 2.5, 1e-9) << "through the mean";
  EXPECT_NEAR(x[0], 0, 0.1);
  EXPECT_NEAR(x[1], 6, 0.1);
}

TEST(EvaluateRows, LinesTellAngles) {
  Table truth, found;
  truth.set("row_id", std::vector<std::int64_t>{1, 2}), truth.set("x0_m", std::vector<double>{0, 0});
  truth.set("y0_m", std::vector<double>{0, 4}), truth.set("x1_m", std::vector<double>{20, 20}),
      truth.set("y1_m", std::vector<double>{0, 4});
  found = truth;
  found.set("row_id", std::vector<std::string>{"a", "b"});
  found.set("y1_m", std::vector<double>{0.2, 4});
  found.set("y0_m", std::vector<double>{-0.1, 4});
  found.set("x0_m", std::vector<double>{20, 0}),
      found.set("x1_m", std::vector<double>{0, 20});  // the way round does not matter
  const auto e = evaluate_rows(found, truth, {});
  EXPECT_NEAR(row_measure(e, "row_recall"), 100, 1e-9);
  EXPECT_NEAR(row_measure(e, "angle_error_max"), std::atan2(0.3, 20) * 180 / M_PI, 1e-9);
  EXPECT_NEAR(row_measure(e, "angle_error_min"), 0, 1e-9);
  EXPECT_THROW(evaluate_rows(found, plants({{1, 0, 0}}), {}), Error);
}

}  // namespace
}  // namespace bole::evaluation
