#include "features/lesson/question_view.h"

#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

#include "features/lesson/lesson_words.h"
#include "features/lesson/wrapped_label.h"
#include "look/scrolled_page.h"

namespace bole::desktop {
namespace {

constexpr int number_width_px = 110;

}  // namespace

QuestionView::QuestionView(LessonGuide& guide, int question, QWidget* parent)
    : QWidget(parent), guide_(guide), question_(question), feedback_(new WrappedLabel({}, this)) {
  setObjectName("lesson_question");
  const auto& asked = guide.step().questions.at(static_cast<std::size_t>(question));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 6, 0, 0);
  auto* ask = new WrappedLabel(lesson_text(asked.ask), this);
  QFont bold = ask->font();
  bold.setBold(true);
  ask->setFont(bold);
  layout->addWidget(ask);
  if (asked.choices.empty())
    add_number(asked, *layout);
  else
    add_choices(asked, *layout);
  auto* check_it = new QPushButton(tr("Check answer"), this);
  check_it->setObjectName("lesson_check");
  connect(check_it, &QPushButton::clicked, this, &QuestionView::check);
  if (number_) connect(number_, &QLineEdit::returnPressed, this, &QuestionView::check);
  auto* line = new QHBoxLayout;
  line->addWidget(check_it);
  line->addStretch(1);
  layout->addLayout(line);
  feedback_->setObjectName("lesson_feedback");
  feedback_->set_words(guide.progress().right(guide.step_index(), question) ? tr("You answered this rightly.")
                                                                            : QString());
  layout->addWidget(feedback_);
}

// The words of a choice wrap, which those of a QRadioButton cannot: the button stands in the margin of a label.
void QuestionView::add_choices(const LessonQuestion& question, QVBoxLayout& layout) {
  constexpr int gap_px = 6;
  choices_ = new QButtonGroup(this);
  for (int i = 0; i < static_cast<int>(question.choices.size()); ++i) {
    auto* words = new WrappedLabel(lesson_text(question.choices[static_cast<std::size_t>(i)].text), this);
    auto* button = new QRadioButton(words);
    button->setAccessibleName(words->text());
    button->setFixedSize(button->sizeHint().width(), words->fontMetrics().height());
    words->setContentsMargins(button->width() + gap_px, 0, 0, 0);
    choices_->addButton(button, i);
    layout.addWidget(words);
  }
}

void QuestionView::add_number(const LessonQuestion& question, QVBoxLayout& layout) {
  number_ = new QLineEdit(this);
  number_->setObjectName("lesson_number");
  number_->setMaximumWidth(number_width_px);
  number_->setAccessibleName(lesson_text(question.ask));
  auto* line = new QHBoxLayout;
  line->addWidget(number_);
  line->addWidget(new QLabel(QString::fromStdString(question.unit), this));
  line->addStretch(1);
  layout.addLayout(line);
}

void QuestionView::check() {
  const auto said = number_ ? guide_.answer_number(question_, number_->text())
                            : guide_.answer_choice(question_, choices_->checkedId());
  feedback_->set_words((said.right ? QStringLiteral("✓ ") : QString()) + said.text);
  scroll_to(*feedback_);  // below the last question it would be out of sight
}

}  // namespace bole::desktop
