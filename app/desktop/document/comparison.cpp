#include "document/comparison.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <array>
#include <utility>

namespace bole::desktop {
namespace {

struct MainNumber {
  std::string_view type, key;
};

constexpr std::array main_numbers{
    MainNumber{"evaluation.plot", "ate_rmse"},
    MainNumber{"evaluation.plot", "ate_max"},
    MainNumber{"evaluation.plot", "drift"},
    MainNumber{"evaluation.plot", "completeness"},
    MainNumber{"evaluation.plot", "correctness"},
    MainNumber{"evaluation.plot", "dbh_bias"},
    MainNumber{"evaluation.plot", "dbh_rmse"},
    MainNumber{"evaluation.plot", "height_bias"},
    MainNumber{"stems.measure", "stems"},
    MainNumber{"slam.run", "frames"},
    MainNumber{"slam.run", "frames_failed"},
    MainNumber{"slam.run", "keyframes"},
    MainNumber{"slam.run", "loops"},
    MainNumber{"slam.run", "refused_loops"},
    MainNumber{"slam.run", "path_length"},
    MainNumber{"slam.run", "registration_rms"},
    MainNumber{"slam.run", "overlap"},
    MainNumber{"slam.run", "points"},
    MainNumber{"slam.run", "seconds"},
};

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

// Place in the list of what matters; its length for all others.
std::size_t rank_of(const std::string& type, const std::string& key) {
  const auto it = std::ranges::find_if(main_numbers, [&](const auto& m) { return m.type == type && m.key == key; });
  return static_cast<std::size_t>(it - main_numbers.begin());
}

std::optional<double> value_in(const vtkbridge::RunOutcome& outcome, std::string_view type, const std::string& key) {
  for (const auto& stage : outcome.stages)
    if (stage.record.type == type) {
      const auto numbers = numbers_of(&stage);
      if (const auto it = numbers.find(key); it != numbers.end()) return it->second.value;
    }
  return {};
}

}  // namespace

std::vector<ComparedNumber> compared_numbers(const vtkbridge::RunOutcome& first, const vtkbridge::RunOutcome& second) {
  std::vector<std::pair<std::size_t, ComparedNumber>> ranked;
  for (const auto& stage : first.stages) {
    const auto a = numbers_of(&stage), b = numbers_of(stage_named(second, stage.record.id));
    auto keys = a;
    keys.insert(b.begin(), b.end());
    for (const auto& [key, number] : keys) {
      const auto rank = rank_of(stage.record.type, key);
      ComparedNumber c;
      c.stage = QString::fromStdString(stage.record.id);
      c.name = QString::fromStdString(key).replace('_', ' ');
      c.unit = QString::fromUtf8(unit_symbol(number.unit).data(), static_cast<int>(unit_symbol(number.unit).size()));
      if (const auto it = a.find(key); it != a.end()) c.first = it->second.value;
      if (const auto it = b.find(key); it != b.end()) c.second = it->second.value;
      c.main = rank < main_numbers.size();
      ranked.emplace_back(rank, std::move(c));
    }
  }
  std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, ComparedNumber>::first);
  std::vector<ComparedNumber> out;
  for (auto& [rank, number] : ranked) out.push_back(std::move(number));
  return out;
}

QString headline(const vtkbridge::RunOutcome& outcome) {
  QStringList parts;
  if (const auto n = value_in(outcome, "stems.measure", "stems")) parts << QObject::tr("%1 stems").arg(*n);
  if (const auto m = value_in(outcome, "evaluation.plot", "ate_rmse"))
    parts << QObject::tr("ATE %1 cm").arg(100 * *m, 0, 'f', 1);
  if (const auto cm = value_in(outcome, "evaluation.plot", "dbh_bias"))
    parts << QObject::tr("DBH bias %1 cm").arg(*cm, 0, 'f', 2);
  if (parts.isEmpty())
    if (const auto m = value_in(outcome, "slam.run", "path_length"))
      parts << QObject::tr("path of %1 m").arg(*m, 0, 'f', 1);
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
