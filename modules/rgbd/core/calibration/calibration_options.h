// Options of calibrating a camera by pictures of a board.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"

namespace bole::rgbd {

enum class BoardKind { charuco, chessboard };
constexpr std::array<std::string_view, 2> choice_names(BoardKind) { return {"charuco", "chessboard"}; }

// Coefficients that are fitted; the others are zero.
enum class DistortionTerms { none, k1, k1_k2, k1_k2_p1_p2, all };
constexpr std::array<std::string_view, 5> choice_names(DistortionTerms) {
  return {"none", "k1", "k1_k2", "k1_k2_p1_p2", "all"};
}

struct CalibrationOptions {
  std::optional<BoardKind> board{};  // open: the board of the views
  int columns = 11, rows = 9;        // squares
  double square = 0.03;              // metres
  double marker = 0.022;             // metres
  std::string dictionary = "DICT_4X4_50";
  std::optional<DistortionTerms> distortion{};  // open: by the Bayesian information criterion
  double bad_view = 2.5;                        // times the median residual
  bool depth = true;
  std::optional<int> width{}, height{};  // pixels; for a table of corners
};
const OptionTable& option_table(const CalibrationOptions*);

}  // namespace bole::rgbd
