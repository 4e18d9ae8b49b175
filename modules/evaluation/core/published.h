// Figures of the paper on forest plots by improved LOAM (docs: SPEC A), to stand beside ours.
#pragma once

#include <string>
#include <string_view>

namespace bole::evaluation {

// The published figure of a measure ("dbh_rmse") for a plot ("1" to "4", "overall"), as text; empty when there is none.
std::string published_figure(std::string_view plot, std::string_view measure);

}  // namespace bole::evaluation
