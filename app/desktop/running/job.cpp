#include "running/job.h"

#include <QObject>
#include <QStringList>
#include <cmath>

namespace bole::desktop {
namespace {

constexpr double min_fraction = 0.02, min_s = 1;  // before a rest is guessed
constexpr int longest_value = 24;                 // letters

}  // namespace

QString job_state_text(JobState state) {
  switch (state) {
    case JobState::waiting:
      return QObject::tr("waiting");
    case JobState::running:
      return QObject::tr("running");
    case JobState::done:
      return QObject::tr("done");
    case JobState::kept:
      return QObject::tr("ended early");
    case JobState::failed:
      return QObject::tr("failed");
    case JobState::cancelled:
      return QObject::tr("cancelled");
  }
  return {};
}

double Job::elapsed_s(Clock::time_point now) const {
  if (state == JobState::waiting || began == Clock::time_point{}) return 0;
  return std::chrono::duration<double>((over() ? ended : now) - began).count();
}

std::optional<double> Job::left_s(Clock::time_point now) const {
  if (state != JobState::running || ending) return {};
  const double spent_s = std::chrono::duration<double>(now - stage_began).count();
  if (fraction < min_fraction || spent_s < min_s) return {};
  return spent_s * (1 - fraction) / fraction + later_s.value_or(0);
}

QString duration_text(double seconds) {
  const auto s = static_cast<long long>(std::round(std::max(0.0, seconds)));
  if (s < 60) return QObject::tr("%1 s").arg(s);
  const auto two = [](long long n) { return QString::number(n).rightJustified(2, '0'); };
  if (s < 3600) return QObject::tr("%1:%2 min").arg(QString::number(s / 60), two(s % 60));
  return QObject::tr("%1:%2:%3 h").arg(QString::number(s / 3600), two(s / 60 % 60), two(s % 60));
}

std::vector<OptionChange> changed_options(const pipeline::PipelineDocument& before,
                                          const pipeline::PipelineDocument& after) {
  std::vector<OptionChange> changes;
  for (const auto& node : after.stages())
    for (const auto& old : before.stages()) {
      if (old.id != node.id || old.type != node.type) continue;
      for (const auto& spec : node.type->options->specs) {
        const auto a = old.options.get(spec.name), b = node.options.get(spec.name);
        if (a != b) changes.push_back({node.id, spec.name, option_text(a), option_text(b)});
      }
    }
  return changes;
}

QString changes_text(const std::vector<OptionChange>& changes) {
  QStringList texts;
  for (const auto& c : changes) {
    QString value = QString::fromStdString(c.after);
    if (value.size() > longest_value) value = value.left(longest_value - 1) + QChar(0x2026);
    texts << QString::fromStdString(c.stage + "." + c.option) + " = " + value;
  }
  return texts.join(", ");
}

}  // namespace bole::desktop
