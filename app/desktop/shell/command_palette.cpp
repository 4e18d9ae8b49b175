#include "shell/command_palette.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "commands/fuzzy.h"
#include "shell/main_window.h"
#include "shell/shell_commands.h"

namespace bole::desktop {
namespace {

constexpr int width_px = 560, rows_shown = 12, pad_px = 6, key_gap_px = 16;
constexpr int menu_role = Qt::UserRole + 1, key_role = Qt::UserRole + 2;

QString without_marks(QString text) { return text.remove('&').remove(QStringLiteral("…")); }

// The command, the menu or what is missing behind it, and its key at the right.
class LineDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {0, option.fontMetrics.height() + 2 * pad_px};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem own = option;
    initStyleOption(&own, index);
    const QString text = std::exchange(own.text, {});
    own.widget->style()->drawControl(QStyle::CE_ItemViewItem, &own, painter, own.widget);
    const bool chosen = own.state.testFlag(QStyle::State_Selected), enabled = own.state.testFlag(QStyle::State_Enabled);
    const auto group = enabled ? QPalette::Active : QPalette::Disabled;
    const QColor ink = own.palette.color(group, chosen && enabled ? QPalette::HighlightedText : QPalette::Text);
    const QColor quiet = chosen ? ink : own.palette.color(QPalette::Disabled, QPalette::Text);
    QRect room = own.rect.adjusted(own.decorationSize.width() + 3 * pad_px, 0, -pad_px, 0);
    const auto& metrics = own.fontMetrics;
    painter->setPen(quiet);
    const QString key = index.data(key_role).toString();
    painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, key);
    if (!key.isEmpty()) room.setRight(room.right() - metrics.horizontalAdvance(key) - key_gap_px);
    painter->setPen(ink);
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(text, Qt::ElideRight, room.width()));
    room.setLeft(room.left() + metrics.horizontalAdvance(text) + key_gap_px);
    if (room.width() < 4 * key_gap_px) return;
    painter->setPen(quiet);
    const QString behind = metrics.elidedText(index.data(menu_role).toString(), Qt::ElideRight, room.width());
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter, behind);
  }
};

}  // namespace

CommandPalette::CommandPalette(MainWindow& window)
    : QDialog(&window, Qt::Popup), input_(new QLineEdit(this)), list_(new QListWidget(this)) {
  setObjectName("command_palette");
  setAttribute(Qt::WA_DeleteOnClose);
  input_->setPlaceholderText(tr("Type a few letters of what you want to do"));
  input_->setClearButtonEnabled(true);
  list_->setItemDelegate(new LineDelegate(list_));
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(input_);
  layout->addWidget(list_);
  collect(window);
  input_->installEventFilter(this);
  connect(input_, &QLineEdit::textChanged, this, &CommandPalette::show_found);
  connect(input_, &QLineEdit::returnPressed, this, &CommandPalette::take);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::take);
  show_found();
  const QSize size(std::min(width_px, window.width() - 40),
                   std::min((fontMetrics().height() + 2 * pad_px) * (rows_shown + 2), window.height() - 80));
  resize(size);
  move(window.mapToGlobal(QPoint((window.width() - size.width()) / 2, window.height() / 8)));
}

void CommandPalette::collect(MainWindow& window) {
  for (const auto which : all_menus)
    collect(window.commands(), in_menu(which), without_marks(window.menu(which)->title()));
  for (const auto& entry : window.commands().entries())  // those of context menus alone
    if (entry->action != nullptr &&
        std::ranges::none_of(lines_, [&](const Line& line) { return line.action == entry->action; }))
      add_line(entry->action, {}, entry.get());
}

void CommandPalette::collect(const Commands& commands, const Place& where, const QString& menu) {
  for (const auto& [entry, section] : commands.items(where)) {
    if (entry->action != nullptr) {
      add_line(entry->action, menu, entry);
      continue;
    }
    const QString title = menu + QStringLiteral(" › ") + without_marks(entry->submenu->title);
    if (entry->submenu->fill) {  // what changes: recent files, colours
      auto* live = new QMenu(this);
      entry->submenu->fill(*live);
      for (auto* action : live->actions())
        if (!action->isSeparator() && action->menu() == nullptr) add_line(action, title, nullptr);
    }
    collect(commands, {Place::Kind::submenu, entry->submenu->id}, title);
  }
}

void CommandPalette::add_line(QAction* action, const QString& menu, const Commands::Entry* entry) {
  if (!action->isVisible() || action->text().isEmpty()) return;
  Line line;
  line.action = action;
  line.text = without_marks(action->text());
  line.menu = menu;
  line.id = entry != nullptr ? entry->command.id : QString();
  line.key = action->shortcut().toString(QKeySequence::NativeText);
  line.reason = entry != nullptr ? Commands::reason_disabled(*entry) : QString();
  lines_.push_back(std::move(line));
}

std::vector<const CommandPalette::Line*> CommandPalette::found(const QString& typed) const {
  struct Found {
    const Line* line;
    int score;
  };
  std::vector<Found> all;
  for (const auto& line : lines_) {
    // The words of the window count most; ids let English words find commands in any language.
    auto score = fuzzy_score(line.text, typed);
    for (const QString& wider : {line.text + " " + line.menu, QString(line.id).replace('_', ' ')})
      if (const auto other = fuzzy_score(wider, typed)) score = std::max(score.value_or(*other - 1000), *other - 1000);
    if (score) all.push_back({&line, typed.isEmpty() ? 0 : *score});
  }
  std::ranges::stable_sort(all, [](const Found& a, const Found& b) {
    const bool a_on = a.line->action && a.line->action->isEnabled(),
               b_on = b.line->action && b.line->action->isEnabled();
    return a_on != b_on ? a_on : a.score > b.score;
  });
  std::vector<const Line*> lines;
  for (const auto& f : all) lines.push_back(f.line);
  return lines;
}

void CommandPalette::show_found() {
  list_->clear();
  for (const auto* line : found(input_->text())) {
    auto* item = new QListWidgetItem(line->action->icon(), line->text, list_);
    const bool enabled = line->action->isEnabled();
    item->setData(Qt::UserRole, QVariant::fromValue(static_cast<QObject*>(line->action.data())));
    item->setData(menu_role, enabled || line->reason.isEmpty() ? line->menu : line->reason);
    item->setData(key_role, line->key);
    item->setToolTip(line->reason);
    if (line->action->isChecked()) item->setText(QStringLiteral("✓ ") + line->text);
    if (!enabled) item->setFlags(Qt::ItemIsSelectable);
  }
  list_->setCurrentRow(0);
}

void CommandPalette::take() {
  const auto* item = list_->currentItem();
  if (item == nullptr) return;
  const QPointer<QAction> action = qobject_cast<QAction*>(item->data(Qt::UserRole).value<QObject*>());
  if (!action || !action->isEnabled()) return;
  // Actions of live menus go with the palette: they are triggered first.
  hide();
  const QPointer<CommandPalette> self(this);
  action->trigger();
  if (self) close();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == input_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Down || key == Qt::Key_Up || key == Qt::Key_PageDown || key == Qt::Key_PageUp) {
      QApplication::sendEvent(list_, event);
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

void add_palette_command(MainWindow& window) {
  window.commands().add({.id = "help.palette",
                         .text = MainWindow::tr("All commands…"),
                         .key = QKeySequence("Ctrl+K"),
                         .places = {in_menu(Menu::help), in_tool_bar("file_bar", 2)},
                         .act = [w = &window] {
                           auto* palette = new CommandPalette(*w);
                           palette->show();
                           palette->input().setFocus();
                         }});
}

}  // namespace bole::desktop
