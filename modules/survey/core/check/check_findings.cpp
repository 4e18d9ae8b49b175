#include "survey/core/check/check_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/no_number.h"
#include "base/verdict.h"

namespace bole::survey {
namespace {

// From y (north) clockwise, 0 to 360.
double bearing_of(const Eigen::Vector2d& d) {
  const double bearing = degrees(std::atan2(d.x(), d.y()));
  return bearing < 0 ? bearing + 360 : bearing;
}

}  // namespace

void CheckFindings::add(Severity severity, std::string code, std::string text, std::optional<Eigen::Vector2d> place) {
  if (place) {
    const Eigen::Vector2d d = *place - centre_;
    text += fmt::format(". Go to ({:.1f}, {:.1f}), {:.1f} m from the centre at {:.0f} deg from north", place->x(),
                        place->y(), d.norm(), bearing_of(d));
  }
  entries_.push_back({{std::move(code), severity, std::move(text)}, place});
}

void CheckFindings::skip(const std::string& measure, const std::string& reason) {
  not_judged_ += (not_judged_.empty() ? "" : "; ") + measure + ": " + reason;
}

double CheckFindings::distance_m(const Entry& e) const { return e.place ? (*e.place - centre_).norm() : no_number; }
double CheckFindings::bearing_deg(const Entry& e) const { return e.place ? bearing_of(*e.place - centre_) : no_number; }

std::vector<CheckFindings::Entry> CheckFindings::sorted() const {
  auto entries = entries_;
  std::ranges::stable_sort(entries, std::ranges::greater{}, [](const Entry& e) { return e.finding.severity; });
  return entries;
}

std::string CheckFindings::verdict() const {
  Severity worst = Severity::note;
  for (const auto& e : entries_) worst = std::max(worst, e.finding.severity);
  return worst == Severity::refused ? "walk again" : worst == Severity::look ? "look" : "sign";
}

Table CheckFindings::table() const {
  std::vector<std::string> code, severity, text;
  std::vector<double> x, y, distance, bearing;
  for (const auto& e : sorted()) {
    code.push_back(e.finding.code);
    severity.emplace_back(severity_name(e.finding.severity));
    text.push_back(e.finding.text);
    x.push_back(e.place ? e.place->x() : no_number);
    y.push_back(e.place ? e.place->y() : no_number);
    distance.push_back(distance_m(e));
    bearing.push_back(bearing_deg(e));
  }
  Table t;
  t.set("code", std::move(code));
  t.set("severity", std::move(severity));
  t.set("text", std::move(text));
  t.set("x_m", std::move(x));
  t.set("y_m", std::move(y));
  t.set("distance_m", std::move(distance));
  t.set("bearing_deg", std::move(bearing));
  t.facts["verdict"] = verdict();
  t.facts["not_judged"] = not_judged_;
  return t;
}

void CheckFindings::tell(Report& report) const {
  for (const auto& e : sorted()) report.find(e.finding.severity, e.finding.code, e.finding.text);
  report.facts["map_verdict"] = verdict();
  if (!not_judged_.empty()) report.facts["not_judged"] = not_judged_;
}

}  // namespace bole::survey
