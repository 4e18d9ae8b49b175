#include "survey/core/revisit/revisit_options.h"

namespace bole::survey {

const OptionTable& option_table(const RevisitOptions*) {
  using S = RevisitOptions;
  using Number = Option<S, double>;
  static const OptionTable table = make_option_table<S>({
      Option<S, RevisitAxes>{"axes", &S::axes, Tier::basic,
                             "Axes of the two tables. search: not known, the trees bring the maps together; same: they "
                             "lie in the same axes already, and only the rest is fitted."},
      Option<S, std::optional<double>>{"years",
                                       &S::years,
                                       Unit::none,
                                       {0.01, 200},
                                       "auto",
                                       Tier::basic,
                                       "Years between the two surveys. auto: from the fact date or recorded of both "
                                       "tables (2024-05-31); without one growth is given for the whole time only."},
      Number{"match_distance",
             &S::match_distance,
             Unit::metre,
             {0.05, 5},
             Tier::basic,
             "Distance at breast height up to which two stems are the same tree. Larger values match stems that were "
             "measured badly, and neighbours."},
      Number{"max_growth",
             &S::max_growth_cm,
             Unit::centimetre,
             {0.1, 20},
             Tier::basic,
             "Largest growth of a diameter per year. Thicker trees that are new were missed in the first survey, they "
             "did not grow in."},
      Number{"max_loss",
             &S::max_loss_cm,
             Unit::centimetre,
             {0, 50},
             Tier::advanced,
             "How much thinner a tree may seem in the second survey and still be the same."},
      Number{"min_dbh",
             &S::min_dbh_cm,
             Unit::centimetre,
             {0, 200},
             Tier::basic,
             "Diameter from which trees count. A tree that reaches it between the surveys is ingrowth."},
      Number{"shared_bias",
             &S::shared_bias_cm,
             Unit::centimetre,
             {0, 5},
             Tier::advanced,
             "Standard deviation of the error that all diameters of one survey share. It widens the interval of the "
             "mean growth, which more trees do not narrow."},
      Number{"assumed_se",
             &S::assumed_se_cm,
             Unit::centimetre,
             {0.01, 10},
             Tier::advanced,
             "Standard error of diameters without an interval (dbh_lo_cm, dbh_hi_cm)."},
  });
  return table;
}

}  // namespace bole::survey
