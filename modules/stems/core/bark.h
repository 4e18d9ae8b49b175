// How deep the fissures of the bark are, which rays see into and a tape does not.
#pragma once

#include <string>
#include <vector>

#include "stems/core/stem_options.h"

namespace bole::stems {

struct Bark {
  std::string title;       // "Plates"
  double relief_m = 0;     // mean depth of the bark below the ridges on which a tape lies
  double relief_sd_m = 0;  // how far it may be from that
  std::vector<std::string> species;
};

// The kind of bark that the options name (resources/bark), with the numbers that they give in place of its own.
// Throws Error{bad_input} for a name that is none, with the names that there are, and for a damaged file.
Bark bark_of(const MeasureOptions& options);

// Names of the kinds of bark: file names in resources/bark, sorted.
std::vector<std::string> bark_names();

}  // namespace bole::stems
