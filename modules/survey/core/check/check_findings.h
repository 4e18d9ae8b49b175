// What a check found, with the place where somebody should go.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "cloud/table.h"

namespace bole::survey {

class CheckFindings {
 public:
  // `centre`: of the plot; distances and bearings are counted from it.
  explicit CheckFindings(const Eigen::Vector2d& centre) : centre_(centre) {}

  // The words of the way to `place` (plot axes, metres) are added to the text.
  void add(Severity severity, std::string code, std::string text, std::optional<Eigen::Vector2d> place = {});
  // A measure that could not be judged, with the reason.
  void skip(const std::string& measure, const std::string& reason);

  // "sign", "look" or "walk again": the most severe finding decides.
  std::string verdict() const;
  // code, severity, text, x_m, y_m, distance_m, bearing_deg; the fact `verdict`; the most severe first.
  Table table() const;
  // Findings, the facts `verdict` and `not_judged`.
  void tell(Report& report) const;

 private:
  struct Entry {
    Finding finding;
    std::optional<Eigen::Vector2d> place;
  };
  double distance_m(const Entry& e) const;
  double bearing_deg(const Entry& e) const;
  std::vector<Entry> sorted() const;

  Eigen::Vector2d centre_;
  std::vector<Entry> entries_;
  std::string not_judged_;
};

}  // namespace bole::survey
