#include "running/comparison.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <map>

namespace bole::desktop {
namespace {

struct Number {
  double value = 0;
  Unit unit = Unit::none;
};

std::map<std::string, Number> numbers_of(const vtkbridge::StageOutcome* stage) {
  std::map<std::string, Number> out;
  if (!stage) return out;
  const auto& report = stage->record.report;
  for (const auto& [key, count] : report.counts) out[key] = {static_cast<double>(count), Unit::none};
  for (const auto& [key, metric] : report.metrics) out[key] = {metric.value, metric.unit};
  if (report.seconds > 0) out["seconds"] = {report.seconds, Unit::second};
  return out;
}

const vtkbridge::StageOutcome* stage_named(const vtkbridge::RunOutcome& outcome, const std::string& id) {
  const auto it = std::ranges::find_if(outcome.stages, [&](const auto& s) { return s.record.id == id; });
  return it == outcome.stages.end() ? nullptr : &*it;
}

// The keys of a report by which a run is judged, as the stage declares them.
const std::vector<std::string>& main_numbers(const vtkbridge::StageOutcome& stage) {
  static const std::vector<std::string> none;
  const auto* type = pipeline::StageRegistry::global().find(stage.record.type);
  return type != nullptr ? type->main_numbers : none;
}

// A main number of any stage.
std::optional<double> main_number(const vtkbridge::RunOutcome& outcome, const std::string& key) {
  for (const auto& stage : outcome.stages) {
    if (std::ranges::find(main_numbers(stage), key) == main_numbers(stage).end()) continue;
    const auto numbers = numbers_of(&stage);
    if (const auto it = numbers.find(key); it != numbers.end()) return it->second.value;
  }
  return {};
}

ComparedNumber compared(const vtkbridge::StageOutcome& stage, const std::string& key,
                        const std::map<std::string, Number>& first, const std::map<std::string, Number>& second) {
  const auto a = first.find(key), b = second.find(key);
  const auto unit = unit_symbol(a != first.end() ? a->second.unit : b->second.unit);
  ComparedNumber c;
  c.stage = QString::fromStdString(stage.record.id);
  c.name = QString::fromStdString(key).replace('_', ' ');
  c.unit = QString::fromUtf8(unit.data(), static_cast<int>(unit.size()));
  if (a != first.end()) c.first = a->second.value;
  if (b != second.end()) c.second = b->second.value;
  return c;
}

}  // namespace

// Results come last in a pipeline: the main numbers of later stages stand first.
std::vector<ComparedNumber> compared_numbers(const vtkbridge::RunOutcome& first, const vtkbridge::RunOutcome& second) {
  std::vector<ComparedNumber> main, others;
  for (const auto& stage : first.stages) {
    const auto a = numbers_of(&stage), b = numbers_of(stage_named(second, stage.record.id));
    auto keys = a;
    keys.insert(b.begin(), b.end());
    std::vector<ComparedNumber> of_stage;
    for (const auto& key : main_numbers(stage))
      if (keys.erase(key) > 0) {
        of_stage.push_back(compared(stage, key, a, b));
        of_stage.back().main = true;
      }
    main.insert(main.begin(), of_stage.begin(), of_stage.end());
    for (const auto& [key, number] : keys) others.push_back(compared(stage, key, a, b));
  }
  main.insert(main.end(), others.begin(), others.end());
  return main;
}

QString headline(const vtkbridge::RunOutcome& outcome) {
  QStringList parts;
  if (const auto n = main_number(outcome, "stems")) parts << QObject::tr("%1 stems").arg(*n);
  if (const auto m = main_number(outcome, "ate_rmse")) parts << QObject::tr("ATE %1 cm").arg(100 * *m, 0, 'f', 1);
  if (const auto cm = main_number(outcome, "dbh_bias")) parts << QObject::tr("DBH bias %1 cm").arg(*cm, 0, 'f', 2);
  const auto m = main_number(outcome, "path_length");
  if (parts.isEmpty() && m) parts << QObject::tr("path of %1 m").arg(*m, 0, 'f', 1);
  return parts.join(", ");
}

std::shared_ptr<const Trajectory> reference_path(const pipeline::PipelineDocument& document, const Results& results) {
  for (const auto& node : document.stages()) {
    const auto joint = node.inputs.find("reference_trajectory");
    if (joint == node.inputs.end()) continue;
    const auto source = pipeline::parse_source(joint->second);
    const auto found = results.find(source.id);
    if (found != results.end() && found->second.has(source.port)) return found->second.get<Trajectory>(source.port);
  }
  return nullptr;
}

}  // namespace bole::desktop
