// Options of the evaluation.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"

namespace bole::evaluation {

// How the stems are moved onto the reference before errors are taken. search: every rotation and shift is tried first.
enum class AlignStems { none, shift, rigid, search };
constexpr std::array<std::string_view, 4> choice_names(AlignStems) { return {"none", "shift", "rigid", "search"}; }

enum class AlignTrajectory { se3, none };
constexpr std::array<std::string_view, 2> choice_names(AlignTrajectory) { return {"se3", "none"}; }

// A plot of the improved-LOAM paper, or all of them together.
enum class PublishedPlot { none, plot1, plot2, plot3, plot4, overall };
constexpr std::array<std::string_view, 6> choice_names(PublishedPlot) {
  return {"none", "1", "2", "3", "4", "overall"};
}

// The two systems that the paper compares.
enum class PaperSystem { improved_loam, loam };
constexpr std::array<std::string_view, 2> choice_names(PaperSystem) { return {"improved_loam", "loam"}; }

struct EvaluationOptions {
  double match_distance_m = 0.5;
  double dbh_gate_cm = 15;
  double class_width_cm = 4, distance_step_m = 5;
  AlignStems align_stems = AlignStems::none;
  std::string columns, rows, reference_columns, reference_rows;
  AlignTrajectory align_trajectory = AlignTrajectory::se3;
  double max_time_gap = 0.5;
  double rpe_step = 1.0;
  double segment_m = 100;
  double loop_radius_m = 3, loop_path_m = 25;
  double loop_shift_m = 0.1, loop_turn_deg = 1;
  double rpe_distance_m = 10;
  PublishedPlot published_plot = PublishedPlot::none;
  std::optional<PaperSystem> published_system;  // open: that of the preset which made the trajectory
};

const OptionTable& option_table(const EvaluationOptions*);

// Of the stage evaluation.rows.
struct RowMatchOptions {
  double match_distance_m = 0.5;
};

const OptionTable& option_table(const RowMatchOptions*);

}  // namespace bole::evaluation
