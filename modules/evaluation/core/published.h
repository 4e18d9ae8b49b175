// Figures of the paper on forest plots by improved LOAM (docs: SPEC A), to stand beside ours.
#pragma once

#include <string>
#include <string_view>

#include "evaluation/core/evaluation_options.h"

namespace bole::evaluation {

// The published figure of a measure ("dbh_rmse") for a plot, as text; empty where there is none.
std::string published_figure(PublishedPlot plot, std::string_view measure);

}  // namespace bole::evaluation
