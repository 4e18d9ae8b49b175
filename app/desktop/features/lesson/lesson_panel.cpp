#include "features/lesson/lesson_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "commands/commands.h"
#include "features/lesson/lesson_guide.h"
#include "features/lesson/lesson_words.h"
#include "features/lesson/question_view.h"
#include "features/lesson/wrapped_label.h"

namespace bole::desktop {
namespace {

constexpr int work_steps = 1000;

WrappedLabel* add_text(QVBoxLayout& layout, const QString& text, QWidget* parent) {
  auto* label = new WrappedLabel(text, parent);
  layout.addWidget(label);
  return label;
}

WrappedLabel* make_bold(WrappedLabel* label) {
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

QScrollArea* scrolling(QWidget* content) {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // one that comes and goes changes where lines break
  scroll->setWidget(content);
  return scroll;
}

// A button that does a command and has its text and keys.
QToolButton* button_of(QAction* action, const char* name) {
  auto* button = new QToolButton;
  button->setObjectName(name);
  button->setDefaultAction(action);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  return button;
}

}  // namespace

LessonPanel::LessonPanel(LessonGuide& guide, Commands& commands, QWidget* parent)
    : QStackedWidget(parent), guide_(guide), commands_(commands) {
  list_ = make_list();
  page_ = make_page();
  setObjectName("lesson_panel");
  addWidget(list_);
  addWidget(page_);
  connect(&guide, &LessonGuide::step_changed, this, &LessonPanel::show_step);
  connect(&guide, &LessonGuide::changed, this, &LessonPanel::show_state);
  connect(&guide, &LessonGuide::progressed, this, [this](double fraction, const QString& what) {
    work_->setValue(static_cast<int>(work_steps * fraction));
    work_->setToolTip(what);
  });
  fill_list();
}

QWidget* LessonPanel::make_list() {
  auto* content = new QWidget;
  list_layout_ = new QVBoxLayout(content);
  return scrolling(content);
}

void LessonPanel::fill_list() {
  while (auto* item = list_layout_->takeAt(0)) {
    if (auto* widget = item->widget()) widget->deleteLater();
    delete item;
  }
  auto* content = list_layout_->parentWidget();
  for (const auto& lesson : guide_.lessons()) {
    auto* open = new QPushButton(lesson_text(lesson.title), content);
    open->setObjectName("lesson_open_" + QString::fromStdString(lesson.id));
    open->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    open->setToolTip(open->text());
    connect(open, &QPushButton::clicked, commands_.action("lesson.open." + QString::fromStdString(lesson.id)),
            &QAction::trigger);
    list_layout_->addWidget(open);
    QStringList sentences;
    for (const auto& sentence : lesson.learn) sentences << lesson_text(sentence);
    add_text(*list_layout_, sentences.join(' '), content);
    const int right = LessonProgress(lesson.id).right_count();
    auto* facts = add_text(*list_layout_,
                           tr("About %1 minutes. %2 of %3 questions answered rightly.")
                               .arg(lesson.minutes)
                               .arg(right)
                               .arg(lesson.question_count()),
                           content);
    facts->setForegroundRole(QPalette::PlaceholderText);
  }
  list_layout_->addStretch(1);
}

QWidget* LessonPanel::make_page() {
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addLayout(make_header(page));
  scroll_ = scrolling(new QWidget);
  layout->addWidget(scroll_, 1);
  layout->addLayout(make_buttons(page));
  return page;
}

QLayout* LessonPanel::make_header(QWidget* page) {
  auto* column = new QVBoxLayout;
  title_ = make_bold(add_text(*column, {}, page));
  title_->setObjectName("lesson_title");
  auto* line = new QHBoxLayout;
  place_ = new QLabel(page);
  place_->setObjectName("lesson_place");
  line->addWidget(place_, 1);
  for (const char* id : {"lesson.again", "lesson.leave"}) {
    auto* button = button_of(commands_.action(id), id);
    button->setAutoRaise(true);
    button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    line->addWidget(button);
  }
  column->addLayout(line);
  auto* making = new QHBoxLayout;
  work_ = new QProgressBar(page);
  work_->setRange(0, work_steps);
  cancel_ = new QPushButton(tr("Cancel"), page);
  cancel_->setObjectName("lesson_cancel");
  connect(cancel_, &QPushButton::clicked, &guide_, &LessonGuide::cancel);
  making->addWidget(work_, 1);
  making->addWidget(cancel_);
  column->addLayout(making);
  return column;
}

QLayout* LessonPanel::make_buttons(QWidget* page) {
  auto* line = new QHBoxLayout;
  for (const char* id : {"lesson.back", "lesson.show", "lesson.next"}) {
    auto* button = button_of(commands_.action(id), id);
    button->setParent(page);
    line->addWidget(button);
  }
  return line;
}

void LessonPanel::show_step() {
  if (!guide_.lesson()) {
    fill_list();
    return setCurrentWidget(list_);
  }
  title_->set_words(lesson_text(guide_.lesson()->title));
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(2, 2, 2, 2);
  make_bold(add_text(*layout, lesson_text(guide_.step().title), content));
  for (const auto& paragraph : guide_.step().text) add_text(*layout, lesson_text(paragraph), content);
  needs_ = add_text(*layout, {}, content);
  needs_->setObjectName("lesson_needs");
  needs_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  connect(needs_, &QLabel::linkActivated, &guide_, [this](const QString& need) { guide_.show_need(need.toInt()); });
  add_sights(*layout);
  for (int i = 0; i < static_cast<int>(guide_.step().questions.size()); ++i)
    layout->addWidget(new QuestionView(guide_, i, content));
  layout->addStretch(1);
  scroll_->setWidget(content);  // the one before is deleted
  setCurrentWidget(page_);
  show_state();
}

void LessonPanel::add_sights(QVBoxLayout& layout) {
  sights_.clear();
  if (guide_.step().see.empty()) return;
  auto* grid = new QGridLayout;
  grid->setColumnStretch(0, 1);
  int row = 0;
  for (const auto& sight : guide_.step().see) {
    auto* words = new WrappedLabel(lesson_text(sight.text));
    auto* value = new QLabel;
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(words, row, 0);
    grid->addWidget(value, row++, 1);
    sights_.push_back(value);
  }
  layout.addLayout(grid);
}

void LessonPanel::show_needs() {
  QStringList lines;
  for (const auto& need : guide_.needs()) {
    const QString words = need.words.toHtmlEscaped();
    const QString link = QString("<a href='%1'>%2</a>").arg(lines.size()).arg(words);
    lines << (need.met ? QStringLiteral("✓ ") : QStringLiteral("○ ")) + (need.option ? link : words);
  }
  needs_->set_words(lines.join("<br>"));
}

void LessonPanel::show_state() {
  commands_.update();
  if (!guide_.lesson()) return;
  const auto& lesson = *guide_.lesson();
  place_->setText(tr("Step %1 of %2; %3 of %4 questions")
                      .arg(guide_.step_index() + 1)
                      .arg(lesson.steps.size())
                      .arg(guide_.progress().right_count())
                      .arg(lesson.question_count()));
  work_->setVisible(guide_.making_data());
  cancel_->setVisible(guide_.making_data());
  show_needs();
  const bool met = guide_.all_met();
  for (std::size_t i = 0; i < sights_.size(); ++i) {
    const auto& sight = guide_.step().see[i];
    QString text = QStringLiteral("–");
    try {
      if (met)
        text =
            QString::number(guide_.value(sight.value), 'f', sight.decimals) + " " + QString::fromStdString(sight.unit);
    } catch (const Error& e) {
      sights_[i]->setToolTip(QString::fromUtf8(e.what()));
    }
    sights_[i]->setText(text.trimmed());
  }
}

}  // namespace bole::desktop
