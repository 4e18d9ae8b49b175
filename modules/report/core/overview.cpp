#include "report/core/overview.h"

#include <algorithm>
#include <cmath>

#include "base/markup.h"
#include "cloud/table_columns.h"
#include "render/draw/axes.h"
#include "report/core/html.h"
#include "report/core/look_list.h"
#include "report/core/plan.h"
#include "report/core/slices.h"
#include "report/core/terms.h"
#include "report/core/value_rows.h"

namespace bole::report {
namespace {

constexpr std::size_t max_pictured = 4;  // of the trees to look at; the others follow in a table below
constexpr const char* not_given = "not given";

std::string facts_html(const std::vector<std::pair<std::string, std::string>>& facts) {
  std::string out = "<dl class=\"facts\">\n";
  for (const auto& [name, value] : facts)
    out += "<div><dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd></div>\n";
  return out + "</dl>\n";
}

std::string count_of(std::size_t n, const std::string& one, const std::string& several) {
  return std::to_string(n) + " " + (n == 1 ? one : several);
}

std::string trees_sentence(const LookList& look) {
  if (look.in_plot == 0) return "No stem was found in the plot.";
  const auto stems = count_of(look.in_plot, "stem", "stems");
  if (look.rows.empty()) return "None of the " + stems + " in the plot needs a look.";
  return std::to_string(look.rows.size()) + " of " + stems + " in the plot " +
         (look.rows.size() == 1 ? "needs" : "need") + " a look.";
}

const char* meaning_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::sign:
      return "No check of this run found a reason to doubt the values as a whole.";
    case Verdict::look:
      return "The values may be right, but these findings must be looked at first:";
    case Verdict::refused:
      return "The run found that its result is not right, or that it cannot be used as it is:";
  }
  return "";
}

std::string verdict_html(const Judgement& judgement, const LookList& look) {
  std::string reasons;
  std::size_t notes = 0;
  for (const auto& f : judgement.findings) {
    if (f.finding.severity == Severity::note)
      ++notes;
    else
      reasons += "<li>" + escaped(typeset(f.finding.text)) + "</li>\n";
  }
  std::string out = "<div class=\"verdict " + std::string(verdict_name(judgement.verdict)) + "\">\n<h2>" +
                    escaped(verdict_headline(judgement.verdict, look.rows.size())) + "</h2>\n<p>" +
                    escaped(meaning_of(judgement.verdict)) + "</p>\n";
  if (!reasons.empty()) out += "<ul>\n" + reasons + "</ul>\n";
  out += "<p>" + escaped(trees_sentence(look));
  if (notes > 0) out += " <a href=\"#check\">" + count_of(notes, "note", "notes") + "</a> of the stages.";
  return out + "</p>\n</div>\n";
}

struct Card {
  std::string value, interval, unit, name, note;
};

std::string card_html(const Card& c) {
  return "<div class=\"card\"><div class=\"name\">" + explained(c.name) + "</div><div class=\"value\"><b>" +
         escaped(c.value) + "</b>" + (c.interval.empty() ? "" : "<em>" + escaped(c.interval) + "</em>") + " <span>" +
         escaped(c.unit) + "</span></div>" +
         (c.note.empty() ? "" : "<div class=\"note\">" + escaped(c.note) + "</div>") + "</div>\n";
}

class Cards {
 public:
  explicit Cards(const Table& plot_values)
      : table_(plot_values), v_(plot_values), bounded_(v_.given("area")), to_check_(optional("stems_to_check")) {}

  std::string html() const {
    std::vector<Card> cards{volume(), basal_area(), stems(), diameter(), height()};
    // The first card is the largest: what is known comes first.
    std::stable_partition(cards.begin(), cards.end(), [](const Card& c) { return c.value != not_given; });
    std::string out = "<div class=\"cards\">\n";
    for (const auto& c : cards) out += card_html(c);
    return out + "</div>\n";
  }

 private:
  // A measure that older tables do not have; NaN without it.
  double optional(const std::string& measure) const {
    const auto& names = table_.texts("measure");
    const auto it = std::ranges::find(names, measure);
    return it == names.end() ? std::nan("") : table_.numbers("value")[static_cast<std::size_t>(it - names.begin())];
  }

  // What the value is without the stems that ask for a look, where that is known and there are any.
  void add_sound(Card& c, const std::string& measure, int decimals) const {
    const double sound = optional(measure + "_sound");
    if (to_check_ > 0 && std::isfinite(sound))
      c.note += (c.note.empty() ? "" : "; ") + render::fixed(sound, decimals) + " without the stems to look at";
  }

  // The value with its half width, both with `decimals` digits.
  Card card(const std::string& name, const std::string& measure, int decimals, const std::string& unit) const {
    const auto& v = v_.at(measure);
    Card c{v_.text(measure, decimals), "", unit, name, ""};
    if (std::isfinite(v.half)) c.interval = " ± " + render::fixed(v.half, decimals);
    if (std::isfinite(v.sampled_half))
      c.note = "± " + render::fixed(v.sampled_half, decimals) + " as a sample of a stand";
    add_sound(c, measure, decimals);
    return c;
  }

  Card volume() const {
    const char* measure = bounded_ ? "volume_per_ha" : "volume";
    if (v_.given(measure)) return card("Stem volume", measure, bounded_ ? 0 : 2, bounded_ ? "m³/ha" : "m³");
    return {not_given, "", "", "Stem volume",
            v_.value("stems") == 0 ? "no stems"
                                   : "tops seen on " + v_.count("tops_seen") + " of " + v_.count("stems") + " stems"};
  }

  Card basal_area() const {
    return bounded_ ? card("Basal area", "basal_area_per_ha", 1, "m²/ha") : card("Basal area", "basal_area", 2, "m²");
  }

  Card stems() const {
    if (!bounded_) return {v_.count("stems"), "", "", "Stems", "no plot boundary, so nothing is given per hectare"};
    auto c = card("Stems", "stem_density", 0, "per ha");
    c.interval.clear();  // a count has no error of measuring of its own
    const double sound = optional("stems_sound");
    const auto parts = to_check_ > 0 && std::isfinite(sound)
                           ? ": " + render::fixed(sound, 0) + " sound, " + render::fixed(to_check_, 0) + " to look at"
                           : std::string();
    c.note = v_.count("stems") + " counted in the plot" + parts;
    return c;
  }

  Card diameter() const {
    auto c = card("Quadratic mean diameter", "quadratic_mean_dbh", 1, "cm");
    c.note = "from " + v_.text("min_dbh", 1) + " to " + v_.text("max_dbh", 1) + " cm";
    return c;
  }

  Card height() const {
    const std::string seen = "tops seen on " + v_.count("tops_seen") + " of " + v_.count("stems") + " stems";
    if (v_.given("lorey_height") && few_heights(v_)) {
      const std::string share = seen + ", " + v_.count("tops_basal_area") + " % of the basal area";
      if (v_.has("lorey_height_all"))
        return {v_.text("lorey_height_all", 1), "", "m", "Lorey's height", share + "; the others by the height curve"};
      return {"\u2265 " + v_.text("lorey_height_at_least", 1), "", "m", "Lorey's height",
              share + "; the others count with the height that they reach at least"};
    }
    if (v_.given("lorey_height")) return {v_.text("lorey_height", 1), "", "m", "Lorey's height", seen};
    return {not_given, "", "", "Height", seen};
  }

  const Table& table_;
  const PlotValues v_;
  bool bounded_;
  double to_check_;
};

std::string look_html(const SurveyData& d, const LookList& look) {
  if (look.in_plot == 0) return {};
  std::string out = "<h2>Trees to look at</h2>\n";
  if (look.rows.empty()) return out + paragraph(trees_sentence(look), "note");
  const auto dbh = numbers_or_nan(*d.stems, "dbh_cm");
  const auto reasons = texts_or_empty(*d.stems, "reasons"), quality = texts_or_empty(*d.stems, "quality");
  out += "<ul class=\"look\">\n";
  for (std::size_t k = 0; k < std::min(max_pictured, look.rows.size()); ++k) {
    const auto i = look.rows[k];
    const auto name = tree_name(*d.stems, i);
    out += "<li data-tree=\"" + escaped(name) + "\">" + slice_again(d, name) + "<div><b>Tree " + escaped(name) +
           "</b> " + render::fixed(dbh[i], 1) + " cm <span class=\"quality " + escaped(quality[i]) + "\">" +
           escaped(quality[i]) + "</span><br/>" + escaped(typeset(reasons[i])) + "</div></li>\n";
  }
  out += "</ul>\n";
  if (look.rows.size() > max_pictured)
    out += "<p class=\"note\"><a href=\"#check\">All " + std::to_string(look.rows.size()) +
           " with their reasons</a></p>\n";
  return out;
}

}  // namespace

std::string overview_html(const OverviewContent& content, const SurveyData& d) {
  const auto look = trees_to_look_at(d);
  std::string out = "<header id=\"overview\">\n<h1>" + escaped(content.title) + "</h1>\n" + facts_html(content.facts);
  if (content.judgement) out += verdict_html(*content.judgement, look);
  out += "<div class=\"first\">\n<div>\n";
  if (d.plot_values != nullptr) out += Cards(*d.plot_values).html();
  out += look_html(d, look) + "</div>\n<div>\n" + plan_html(d) + "</div>\n</div>\n";
  return out + "</header>\n";
}

}  // namespace bole::report
