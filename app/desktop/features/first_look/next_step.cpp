#include "features/first_look/next_step.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <algorithm>

#include "document/stage_roles.h"
#include "look/elided_label.h"
#include "look/finding_words.h"
#include "render/charts/columns.h"
#include "running/first_look.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

const QString between = QStringLiteral("  ·  ");

struct StemCounts {
  int all = 0, doubtful = 0, decided = 0;
};

StemCounts count_stems(const Table& stems) {
  StemCounts counts;
  const auto qualities = render::texts_or_empty(stems, "quality"), states = render::texts_or_empty(stems, "state");
  for (std::size_t i = 0; i < stems.rows(); ++i) {
    const bool decided = states[i] == "accepted" || states[i] == "rejected" || states[i] == "edited";
    ++counts.all;
    counts.decided += decided;
    counts.doubtful += !decided && (qualities[i] == "poor" || qualities[i] == "fair");
  }
  return counts;
}

}  // namespace

NextStep::NextStep(Workbench& bench, QWidget* parent)
    : QFrame(parent), bench_(bench), what_(new ElidedLabel(this)), button_(new QPushButton(this)) {
  setObjectName("next_step");
  what_->setObjectName("next_step_what");
  button_->setObjectName("next_step_button");
  QFont bold = button_->font();
  bold.setBold(true);
  button_->setFont(bold);
  button_->setMinimumHeight(button_->fontMetrics().height() + 14);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(what_, 1);
  layout->addWidget(button_);
  connect(button_, &QPushButton::clicked, this, [this] {
    if (bench_.commands().action(command_)->isEnabled()) bench_.commands().trigger(command_);
  });
  connect(&bench_.runner(), &Runner::jobs_changed, this, &NextStep::show_work);
  hide();
}

void NextStep::offer(const QString& command, const QString& text) {
  offered_ = command;
  offered_text_ = text;
  show_work();
}

// While something runs it can be cancelled; then comes what was offered.
void NextStep::show_work() {
  const bool runs = bench_.runner().running();
  command_ = runs ? QStringLiteral("run.cancel") : offered_;
  if (command_.isEmpty()) return;
  const auto* action = bench_.commands().action(command_);
  button_->setText(runs ? tr("Cancel the run") : offered_text_);
  button_->setIcon(action->icon());
  button_->setToolTip(action->toolTip());
}

void NextStep::offer_run() {
  const auto& document = bench_.session().document();
  offer("run.all", editor_of(document, "stems") != nullptr            ? tr("Measure the stems")
                   : stage_with_output(document, "stems") != nullptr  ? tr("Measure the stems")
                   : stage_with_output(document, "rows") != nullptr   ? tr("Find the rows")
                   : stage_with_output(document, "traits") != nullptr ? tr("Measure the plant")
                                                                      : tr("Run the pipeline"));
}

void NextStep::offer_result() {
  if (QFileInfo::exists(bench_.last_export() + "/report.html"))
    offer("document.open_report", tr("Open the report"));
  else
    offer("run.all", tr("Write survey and report"));
}

void NextStep::show_opened() {
  what_->set_line(QFileInfo(bench_.session().path()).fileName());
  offer_run();
  show();
}

void NextStep::show_seen(const FirstSeen& seen) {
  QStringList line{seen.file};
  line << seen.facts;
  what_->set_line(line.join(between));
  if (!seen.large.isEmpty()) what_->setToolTip(what_->text() + "\n\n" + seen.large);
  if (!seen.warnings.isEmpty()) what_->setToolTip(what_->text() + "\n\n" + finding_words(seen.warnings.join('\n')));
}

void NextStep::show_preparing(const QString& file, double fraction) {
  what_->set_line(QStringList{
      file, tr("larger than the memory for points: an index is built once, %1 %").arg(static_cast<int>(100 * fraction))}
                      .join(between));
}

void NextStep::show_problem(const QString& why) { what_->set_line(finding_words(why)); }

void NextStep::show_survey(const Survey& survey) {
  if (survey.empty()) return;
  if (!survey.stems || !survey.stems->has("dbh_cm")) return offer_result();
  const auto stems = count_stems(*survey.stems);
  what_->set_line(QStringList{tr("%n stem(s)", nullptr, stems.all), tr("%n doubtful", nullptr, stems.doubtful),
                              tr("%n decided", nullptr, stems.decided)}
                      .join(between));
  if (stems.doubtful > 0)
    offer("stem.next", tr("Look at the next doubtful stem"));
  else
    offer_result();
}

}  // namespace bole::desktop
