// Shading of a picture from its depths alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

class vtkCamera;
class vtkRenderWindow;

namespace bole::render {

struct EyeDomeOptions {
  double radius_px = 3;       // how far a neighbour is looked for
  double full_depth_m = 0.6;  // a neighbour nearer to the eye by this much darkens fully
  double strength = 0.6;      // 0: none, 1: down to black
};

// Eye-dome lighting (C. Boucheny 2009): a pixel whose neighbours are nearer to the eye lies in a hollow and is darkened
// by the mean of eight of them at two radii. Unlike vtkEDLShading the effect is bounded and measured in metres, so that
// a sparse crown, where all pixels lie at different depths, keeps its colours. `depth_m`: distance from the eye,
// infinity where nothing was drawn (which neither darkens nor is darkened). Changes `rgb`, three bytes per pixel, rows
// of `width`.
void shade_eye_dome(std::span<std::uint8_t> rgb, const std::vector<float>& depth_m, int width, int height,
                    const EyeDomeOptions& options);

// The same as black to be laid over the picture: its opacity for each pixel.
std::vector<std::uint8_t> eye_dome_shadow(const std::vector<float>& depth_m, int width, int height,
                                          const EyeDomeOptions& options);

// Distances from the eye's plane of all pixels of a drawn window, rows from below, infinity for the background.
std::vector<float> window_depths_m(vtkRenderWindow* window, vtkCamera* camera);

}  // namespace bole::render
