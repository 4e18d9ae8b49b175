#include "plant/core/traits/traits.h"

namespace bole::plant {

const OptionTable& option_table(const TraitOptions*) {
  using S = TraitOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, double>{"stem_height",
                        &S::stem_height,
                        Unit::metre,
                        {0.001, 10},
                        Tier::basic,
                        "Height above the soil at which the diameter of the stem is measured."},
      Option<S, StemMethod>{"stem", &S::stem, Tier::basic,
                            "contours: the edges of the stem in the pictures. cloud: the points about its axis, which "
                            "are too wide for thin stems. auto: contours where pictures show them, else cloud."},
      Option<S, double>{"stretch",
                        &S::stretch,
                        Unit::metre,
                        {0.004, 0.5},
                        Tier::advanced,
                        "Length of stem around stem_height that is fitted. A longer one takes more pictures of the "
                        "edges, and more petioles."},
      Option<S, int>{"max_views",
                     &S::max_views,
                     Unit::none,
                     {3, 5000},
                     Tier::advanced,
                     "Most views whose pictures are used for the stem; they are chosen evenly."},
      Option<S, PictureLight>{"light", &S::light, Tier::expert,
                              "How the codes of the pictures become light. srgb undoes the usual curve, linear takes "
                              "the codes as they are, auto takes what explains the edges better."},
      Option<S, double>{"scale_sd",
                        &S::scale_sd,
                        Unit::percent,
                        {0, 20},
                        Tier::advanced,
                        "Standard error of the scale of the poses. It widens all intervals."},
      Option<S, double>{"surface_sd",
                        &S::surface_sd,
                        Unit::metre,
                        {0, 0.05},
                        Tier::expert,
                        "Error of the cloud's outermost surface that its points share, so that they cannot show it. "
                        "It widens the intervals of height and breadth."},
      Option<S, double>{
          "tip_reach",
          &S::tip_reach,
          Unit::metre,
          {0.001, 0.1},
          Tier::expert,
          "How far from the outermost points of the cloud the pictures are searched for the ends of leaves. "
          "A larger value finds tips that the cloud has lost, and more things behind them."},
      Option<S, std::string>{"plant_id",
                             &S::plant_id,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Name of the plant in the table. Empty: the name of the folder of the views."},
  });
  return table;
}

}  // namespace bole::plant
