// Whether the codes of pictures are sRGB codes or light itself, from the shape of their sharp edges.
#pragma once

#include <cstdint>
#include <vector>

#include "camera/image.h"

namespace bole::plant {

// Optics blur light. Across a step from dark to bright the picture in codes of sRGB is then lopsided, and in light it
// is even; where the codes are light themselves it is the other way round. So steps with level sides are collected, and
// fitted with both models.
struct ToneVotes {
  std::size_t edges = 0;                     // steps that were fitted
  std::size_t for_light = 0, for_codes = 0;  // those that one model explains clearly better

  void add(const ToneVotes& other);
};

// Steps of at least 60 codes along the rows of a picture; at most `max_edges` of them, evenly spread.
ToneVotes tone_votes(const ColorImage& image, std::size_t max_edges = 250);

// -1 where the codes are light, 1 where they are sRGB codes, 0 where the steps do not tell.
int tone_of(const ToneVotes& votes);

// sRGB (IEC 61966-2-1): light of a code and code of a light, both 0..1.
double light_of_code(double code);
double code_of_light(double light);

}  // namespace bole::plant
