#include "features/lesson/lesson_guide.h"

#include <QFile>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "features/lesson/lesson_files.h"
#include "features/lesson/lesson_words.h"
#include "look/finding_words.h"
#include "workbench/workbench.h"

namespace bole::desktop {

LessonGuide::LessonGuide(Workbench& bench, std::vector<Lesson> lessons)
    : QObject(&bench), bench_(bench), lessons_(std::move(lessons)) {
  connect_window();
  connect(&work_, &BackgroundWork::progressed, this, &LessonGuide::progressed);
  connect(&work_, &BackgroundWork::done, this, &LessonGuide::open_document);
  connect(&work_, &BackgroundWork::cancelled, this, [this] { stop_showing(tr("Cancelled.")); });
  connect(&work_, &BackgroundWork::failed, this, [this](const QString& why) { stop_showing(why); });
}

void LessonGuide::connect_window() {
  const auto look = [this] { look_again(); };
  connect(&bench_.session(), &Session::option_changed, this, look);
  connect(&bench_.session(), &Session::document_replaced, this, look);
  connect(&bench_.selection(), &Selection::changed, this, look);
  connect(&bench_.runner(), &Runner::finished, this,
          [this](const vtkbridge::RunOutcome& outcome, const Results& results) {
            ended_ = lesson_ ? LessonRun{outcome, results} : LessonRun{};
          });
  connect(&bench_.runner(), &Runner::job_ended, this, &LessonGuide::take_run);
}

// Runner::finished has the results, this signal says of which document.
void LessonGuide::take_run(int job) {
  const auto run = bench_.runner().job(job);
  if (lesson_ && run && run->has_result() && run->path == bench_.session().path()) {
    run_ = ended_;
    ran_ = run->document->to_json();
  }
  ended_ = {};
  look_again();
}

void LessonGuide::begin(const std::string& id) {
  const auto it = std::ranges::find(lessons_, id, &Lesson::id);
  if (it == lessons_.end()) throw bad_input("there is no lesson '" + id + "'", "one of Help > Lessons");
  lesson_ = &*it;
  bench_.docks().raise("lesson");
  go(std::min(progress().step(), static_cast<int>(lesson_->steps.size()) - 1));
}

void LessonGuide::begin_again() {
  progress().forget();
  go(0);
}

void LessonGuide::leave() {
  cancel();
  auto& session = bench_.session();
  if (session.has_document() && is_lesson_path(session.path())) session.save(session.path());  // asks nothing later
  lesson_ = nullptr;
  showing_ = false;
  run_ = ended_ = {};
  ran_.clear();
  Q_EMIT step_changed();
}

void LessonGuide::go(int step) {
  step_ = std::clamp(step, 0, static_cast<int>(lesson_->steps.size()) - 1);
  if (progress().step() < step_) progress().set_step(step_);
  showing_ = false;
  Q_EMIT step_changed();
  if (!is_lesson_document_open(place(), this->step().needs.front().name)) return open_data();
  select_stage();
  look_again();
}

std::vector<LessonGuide::Need> LessonGuide::needs() const {
  std::vector<Need> list;
  for (const auto& need : step().needs)
    list.push_back({need_words(need, place()), is_met(need, place()), need.kind == LessonNeed::Kind::option});
  return list;
}

bool LessonGuide::all_met() const {
  return std::ranges::all_of(step().needs, [&](const auto& need) { return is_met(need, place()); });
}

void LessonGuide::select_stage() {
  for (const auto& need : step().needs)
    if (show_option(need, place())) return;
}

void LessonGuide::show_need(int need) {
  if (show_option(step().needs.at(static_cast<std::size_t>(need)), place())) bench_.docks().raise("options");
}

void LessonGuide::look_again() {
  if (!lesson_) return;
  keep_values();
  Q_EMIT changed();
  if (showing_) QTimer::singleShot(0, this, &LessonGuide::go_on_showing);  // after all have seen the change
}

void LessonGuide::keep_values() {
  if (step().keep.empty() || !all_met()) return;
  bench_.guarded([&] {
    for (const auto& [name, expression] : step().keep) progress().keep(name, value(expression));
  });
}

void LessonGuide::open_data() {
  if (work_.busy()) return;
  work_.start([lesson = *lesson_, folder = lesson_folder(*lesson_) + "/data"](const Run& run) {
    make_lesson_data(lesson, folder, run);
  });
  Q_EMIT changed();
}

// Documents of lessons are made anew: what a step needs is set in it.
void LessonGuide::open_document() {
  if (!lesson_) return;
  bench_.guarded([&] {
    auto& session = bench_.session();
    const auto& name = step().needs.front().name;
    const auto path = lesson_document_path(*lesson_, name);
    const auto document = lesson_document(*lesson_, name, lesson_folder(*lesson_) + "/data");
    if (session.has_document() && is_lesson_path(session.path())) session.save(session.path());  // asks nothing
    QFile::remove(path);
    QFile::remove(Session::recovery_path(path));
    bench_.open_made(document, path);
    bench_.docks().raise("lesson");
    select_stage();
  });
  look_again();
}

void LessonGuide::cancel() { work_.cancel(); }

void LessonGuide::show_me() {
  if (!lesson_ || showing_) return;
  showing_ = true;
  tried_.clear();
  Q_EMIT changed();
  go_on_showing();
}

void LessonGuide::stop_showing(const QString& why) {
  showing_ = false;
  if (!why.isEmpty()) bench_.complain(why);
  Q_EMIT changed();
}

// One need after the other: what ends later, such as a run, calls this again.
void LessonGuide::go_on_showing() {
  if (!lesson_ || !showing_ || work_.busy() || bench_.runner().running()) return;
  for (std::size_t i = 0; i < step().needs.size(); ++i) {
    const auto& need = step().needs[i];
    if (is_met(need, place())) continue;
    if (!tried_.insert(i).second) return stop_showing(tr("This could not be done: %1").arg(need_words(need, place())));
    if (need.kind == LessonNeed::Kind::document) return open_data();
    try {
      if (!meet(need, place())) return stop_showing(tr("Do this yourself: %1").arg(need_words(need, place())));
    } catch (const Error& e) {
      return stop_showing(QString::fromUtf8(e.what()));
    }
    return look_again();
  }
  bench_.guarded([&] {
    for (const auto& id : step().commands) bench_.commands().trigger(QString::fromStdString(id));
  });
  for (const auto& id : step().panels) bench_.docks().raise(QString::fromStdString(id));
  bench_.docks().raise("lesson");
  stop_showing({});
}

double LessonGuide::value(const std::string& expression) const {
  auto values = progress().kept();
  for (const auto& name : names_in_expression(expression))
    if (const auto number = lesson_->numbers.find(name); number != lesson_->numbers.end())
      values[name] = lesson_number(number->second, run_);
  return lesson_value(expression, values);
}

LessonGuide::Feedback LessonGuide::note(int question, const Feedback& feedback) {
  if (feedback.right) progress().set_right(step_, question);
  Q_EMIT changed();
  return feedback;
}

LessonGuide::Feedback LessonGuide::answer_number(int question, const QString& typed) {
  const auto& asked = step().questions.at(static_cast<std::size_t>(question));
  if (!all_met()) return {false, tr("First do what the step needs: the answer comes from your own run.")};
  bool number = false;
  const double given = QString(typed).trimmed().replace(',', '.').replace(QChar(0x2212), '-').toDouble(&number);
  if (!number) return {false, tr("'%1' is not a number. Type one such as 12.3, without its unit.").arg(typed)};
  try {
    const double right = value(asked.answer);
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(asked.tolerance))), 0, 4);
    const QString unit = asked.unit.empty() ? QString() : " " + QString::fromStdString(asked.unit);
    if (std::abs(given - right) > asked.tolerance)
      return {false, tr("Not %1.").arg(typed.trimmed() + unit) + " " + lesson_text(asked.hint)};
    return note(question, {true, tr("Right: %1.").arg(QString::number(right, 'f', decimals) + unit) + " " +
                                     lesson_text(asked.why)});
  } catch (const Error& e) {
    return {false, tr("Your run does not give the answer: %1").arg(finding_words(QString::fromUtf8(e.what())))};
  }
}

LessonGuide::Feedback LessonGuide::answer_choice(int question, int choice) {
  const auto& choices = step().questions.at(static_cast<std::size_t>(question)).choices;
  if (choice < 0 || choice >= static_cast<int>(choices.size())) return {false, tr("Choose an answer first.")};
  const auto& chosen = choices[static_cast<std::size_t>(choice)];
  return note(question, {chosen.right, (chosen.right ? tr("Right.") : tr("No.")) + " " + lesson_text(chosen.why)});
}

}  // namespace bole::desktop
