// Both edges of a thin bright or dark strip in a picture, to a small part of a pixel.
//
// The picture across the strip is modelled as what the optics make of it: a background on each side, the strip with its
// shading between two edges, all blurred by a Gaussian point spread and by the pixel. Colours enter linearly and are
// eliminated (variable projection: Golub and Pereyra 1973); edges and spread are found by Gauss and Newton.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace bole::plant {

struct StripPixel {
  double across = 0;              // pixels from the middle of the strip, to the right
  std::array<double, 3> value{};  // red, green, blue, in any linear unit
};

struct StripEdges {
  double left = 0, right = 0;        // pixels
  double sigma = 0;                  // point spread, pixels, without the pixel itself
  double sd_left = 0, sd_right = 0;  // standard errors, pixels
  double residual = 0;               // root mean square of the fit, in the unit of the values
  double contrast = 0;               // of the weaker edge, in the same unit
};

struct StripStart {
  double left = 0, right = 0, sigma = 0.8;
  bool fit_sigma = true;
};

// Nothing where there are too few pixels on the strip and beside it, or the fit runs away.
// `explained` gets the fitted values of the pixels.
std::optional<StripEdges> fit_strip(std::span<const StripPixel> pixels, const StripStart& start,
                                    std::vector<std::array<double, 3>>* explained = nullptr);

// Mean square of what given edges leave unexplained: for a search over places and widths.
double strip_cost(std::span<const StripPixel> pixels, double left, double right, double sigma);

}  // namespace bole::plant
