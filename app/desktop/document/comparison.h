// Two runs beside each other in numbers.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "document/job.h"

namespace bole::desktop {

struct ComparedNumber {
  QString stage, name, unit;
  std::optional<double> first, second;
  bool main = false;  // one of those a survey is judged by
};

// Every count and metric of the reports, in the order of the stages; those that matter first.
std::vector<ComparedNumber> compared_numbers(const vtkbridge::RunOutcome& first, const vtkbridge::RunOutcome& second);

// The numbers a run is remembered by: "78 trees, ATE 0.7 cm, DBH bias -0.19 cm"; what it has of them.
QString headline(const vtkbridge::RunOutcome& outcome);

// The path that the evaluation of a run holds the estimate against; null when there is none.
std::shared_ptr<const Trajectory> reference_path(const pipeline::PipelineDocument& document, const Results& results);

}  // namespace bole::desktop
