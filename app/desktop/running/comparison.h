// Two runs beside each other in numbers.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "running/job.h"

namespace bole::desktop {

struct ComparedNumber {
  QString stage, name, unit;
  std::optional<double> first, second;
  bool main = false;  // one of those a survey is judged by
};

// Every count and metric of the reports, in the order of the stages; the main ones first.
std::vector<ComparedNumber> compared_numbers(const vtkbridge::RunOutcome& first, const vtkbridge::RunOutcome& second);

// The result in one line: "78 stems, ATE 0.7 cm, DBH bias -0.19 cm"; what the run has of it.
QString headline(const vtkbridge::RunOutcome& outcome);

// The path with which the evaluation of a run compares the estimate; null when there is none.
std::shared_ptr<const Trajectory> reference_path(const pipeline::PipelineDocument& document, const Results& results);

}  // namespace bole::desktop
