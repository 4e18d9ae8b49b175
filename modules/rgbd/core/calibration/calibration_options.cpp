#include "rgbd/core/calibration/calibration_options.h"

#include "base/error.h"

namespace bole::rgbd {

const OptionTable& option_table(const CalibrationOptions*) {
  using S = CalibrationOptions;
  static const OptionTable table = make_option_table<S>(
      {
          Option<S, std::optional<BoardKind>>{"board", &S::board, "auto", Tier::basic,
                                              "Kind of the board. auto takes the board that comes with the views "
                                              "(mat.json)."},
          Option<S, int>{"columns", &S::columns, Unit::none, {3, 100}, Tier::basic, "Squares of the board across."},
          Option<S, int>{"rows", &S::rows, Unit::none, {3, 100}, Tier::basic, "Squares of the board downwards."},
          Option<S, double>{"square", &S::square, Unit::metre, {0.001, 1}, Tier::basic, "Side of a square."},
          Option<S, double>{"marker", &S::marker, Unit::metre, {0.0005, 1}, Tier::basic, "Side of a marker."},
          Option<S, std::string>{"dictionary",
                                 &S::dictionary,
                                 TextKind::plain,
                                 {},
                                 Tier::basic,
                                 "Dictionary of the markers, for instance DICT_4X4_50."},
          Option<S, std::optional<DistortionTerms>>{
              "distortion", &S::distortion, "auto", Tier::advanced,
              "Coefficients of the lens that are fitted. auto takes those that the corners support (Bayesian "
              "information criterion)."},
          Option<S, double>{"bad_view",
                            &S::bad_view,
                            Unit::none,
                            {1.2, 100},
                            Tier::advanced,
                            "Views whose residual is larger than the median by this factor are left out, up to a third "
                            "of all."},
          Option<S, bool>{"depth", &S::depth, Tier::basic,
                          "Compare depth images with the board: the place of the depth camera, and how its depth is "
                          "off."},
          Option<S, std::optional<int>>{"width",
                                        &S::width,
                                        Unit::pixel,
                                        {16, 100000},
                                        "auto",
                                        Tier::advanced,
                                        "Width of the images; needed for a table of corners."},
          Option<S, std::optional<int>>{"height",
                                        &S::height,
                                        Unit::pixel,
                                        {16, 100000},
                                        "auto",
                                        Tier::advanced,
                                        "Height of the images; needed for a table of corners."},
          Unless{"board", {"auto"}, {"columns", "rows", "square"}},
          OnlyIf{"board", {"charuco"}, {"marker", "dictionary"}},
      },
      [](const S& s) {
        if (s.board == BoardKind::charuco && s.marker >= s.square)
          throw bad_input("marker is " + number_text(s.marker) + " m and square " + number_text(s.square) + " m",
                          "markers smaller than the squares");
      });
  return table;
}

}  // namespace bole::rgbd
