#include "evaluation/core/compare_options.h"

#include <string>

namespace bole::evaluation {
namespace {

// The options of evaluation.plot that mean something here.
bool is_shared(const std::string& name) {
  for (const char* other : {"class_width", "distance_step", "loop_radius", "loop_path", "loop_shift", "loop_turn",
                            "segment", "published_plot", "published_system"})
    if (name == other) return false;
  return true;
}

}  // namespace

const OptionTable& option_table(const CompareOptions*) {
  using S = CompareOptions;
  static const OptionTable table = [] {
    auto t = make_option_table<S>({Option<S, double>{
        "min_agreement",
        &S::min_agreement_pct,
        Unit::percent,
        {1, 100},
        Tier::advanced,
        "Share of the stems of the shorter list that must agree before two lists count as one plot in the same axes. "
        "A larger value lets less certain ones fall apart."}});
    for (auto spec : option_table(static_cast<const EvaluationOptions*>(nullptr)).specs) {
      if (!is_shared(spec.name)) continue;
      spec.get = [get = spec.get](const void* s) {
        return get(static_cast<const EvaluationOptions*>(static_cast<const S*>(s)));
      };
      spec.assign = [assign = spec.assign](void* s, const OptionValue& v) {
        assign(static_cast<EvaluationOptions*>(static_cast<S*>(s)), v);
      };
      t.specs.push_back(std::move(spec));
    }
    return t;
  }();
  return table;
}

}  // namespace bole::evaluation
