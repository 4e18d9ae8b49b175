#include "rgbd/core/poses/pose_options.h"

namespace bole::rgbd {

const OptionTable& option_table(const PoseOptions*) {
  using S = PoseOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, PoseSource>{"source", &S::source, Tier::basic,
                            "slam: poses from features, depth and the board. given: poses that came with the views, "
                            "checked against matches and depth."},
      Option<S, FeatureKind>{"features", &S::features, Tier::advanced,
                             "Kind of features: sift finds more of them again, orb is faster."},
      Option<S, int>{"max_features",
                     &S::max_features,
                     Unit::none,
                     {100, 20000},
                     Tier::advanced,
                     "Largest number of features in a view, spread over the image. More features take longer to match "
                     "and help where texture is poor."},
      Option<S, int>{"max_width",
                     &S::max_width,
                     Unit::pixel,
                     {160, 8192},
                     Tier::expert,
                     "Wider images are reduced to this width for features. A larger width finds finer texture and "
                     "takes longer."},
      Option<S, double>{"max_ratio",
                        &S::max_ratio,
                        Unit::none,
                        {0.3, 1},
                        Tier::expert,
                        "Largest distance to the best descriptor over that to the next best. A larger ratio keeps more "
                        "matches, of which more are wrong."},
      Option<S, bool>{"gms", &S::gms, Tier::expert,
                      "Drops matches that do not move along with their neighbours (grid-based motion statistics)."},
      Option<S, double>{"max_match_error",
                        &S::max_match_error,
                        Unit::pixel,
                        {0.5, 50},
                        Tier::expert,
                        "Largest distance of a match from the rigid motion of its pair, in an image 1280 pixels wide."},
      Option<S, int>{"min_matches",
                     &S::min_matches,
                     Unit::none,
                     {8, 1000},
                     Tier::advanced,
                     "Two views are connected when at least this many matches agree with one rigid motion."},
      Option<S, int>{"neighbours",
                     &S::neighbours,
                     Unit::none,
                     {1, 50},
                     Tier::advanced,
                     "Each view is matched with this many views after it."},
      Option<S, int>{"loops",
                     &S::loops,
                     Unit::none,
                     {0, 100},
                     Tier::advanced,
                     "Largest number of further views that each view is matched with because they show the same place. "
                     "0: no loops are closed."},
      Option<S, std::optional<double>>{"depth_noise",
                                       &S::depth_noise,
                                       Unit::metre,
                                       {1e-5, 0.5},
                                       "auto",
                                       Tier::advanced,
                                       "Standard deviation of a depth of 1 m; it grows with the square of the depth. "
                                       "auto: learnt from the residuals."},
      Option<S, bool>{"use_board", &S::use_board, Tier::basic,
                      "Uses the ChArUco board under the plant for axes, scale and poses, where the views have one."},
      Option<S, Turntable>{"turntable", &S::turntable, Tier::basic,
                           "Whether the camera stands still and the object turns, so that the still background is left "
                           "out. auto: decided from the motions in the images."},
      Option<S, bool>{"refine_focal", &S::refine_focal, Tier::advanced,
                      "Estimates one factor of the focal lengths along with the poses. Needs a board or good depth."},
      Option<S, bool>{"allow_unscaled", &S::allow_unscaled, Tier::advanced,
                      "Also finds poses where there is neither depth nor a board. Lengths are then in units of the "
                      "median distance of the points, not in metres."},
      OnlyIf{"source", {"slam"}, {"use_board", "turntable", "refine_focal", "loops", "allow_unscaled"}},
  });
  return table;
}

}  // namespace bole::rgbd
