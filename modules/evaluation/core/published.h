// Tables 2 and 3 of the paper on forest plots by improved LOAM (SPEC A): the published figures of both systems, to
// stand beside ours.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evaluation/core/evaluation_options.h"

namespace bole::evaluation {

// The published figure of a measure ("dbh_rmse") of a system on a plot, as text; empty where there is none.
std::string published_figure(PublishedPlot plot, PaperSystem system, std::string_view measure);

// The system of the paper that a preset of slam.run stands for: loam and loam_paper, forest and forest_paper. Nothing
// for the others, which the paper does not have.
std::optional<PaperSystem> paper_system(std::string_view preset);

// "improved LOAM, plot 2": a heading for such figures; empty without a plot.
std::string published_heading(PublishedPlot plot, PaperSystem system);

// The plot of the paper that a name means: 1, plot1, "plot 1"; none for others.
PublishedPlot published_plot_named(std::string_view name);

}  // namespace bole::evaluation
