#include "panels/log_panel.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QStyle>
#include <QTableView>
#include <QTime>
#include <QVBoxLayout>

#include "commands/commands.h"
#include "look/finding_words.h"

namespace bole::desktop {
namespace {

constexpr int level_role = Qt::UserRole + 1, english_role = Qt::UserRole + 2, max_lines = 5000;

class FromLevel : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void show_from(int level) {
    min_level_ = level;
    invalidateFilter();
  }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    return sourceModel()->index(row, 1, parent).data(level_role).toInt() >= min_level_;
  }

 private:
  int min_level_ = 0;
};

}  // namespace

LogPanel::LogPanel(Commands& commands, QWidget* parent)
    : QWidget(parent),
      model_(new QStandardItemModel(0, 2, this)),
      by_level_(new FromLevel(this)),
      by_words_(new QSortFilterProxyModel(this)),
      view_(new QTableView(this)),
      level_(new QComboBox(this)),
      words_(new QLineEdit(this)) {
  by_level_->setSourceModel(model_);
  by_words_->setSourceModel(by_level_);
  by_words_->setFilterKeyColumn(1);
  by_words_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  view_->setModel(by_words_);
  view_->horizontalHeader()->hide();
  view_->horizontalHeader()->setStretchLastSection(true);
  view_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  view_->setShowGrid(false);
  view_->setWordWrap(true);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  commands.add({.id = "log.copy",
                .text = tr("Copy"),
                .key = QKeySequence::Copy,
                .places = {in_context("log")},
                .act = [this] { copy(); },
                .owner = view_});
  commands.give_context_menu(*view_, "log");

  level_->addItems({tr("All"), tr("Warnings"), tr("Errors")});
  connect(level_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this](int level) { static_cast<FromLevel*>(by_level_)->show_from(level); });
  words_->setPlaceholderText(tr("Search"));
  words_->setClearButtonEnabled(true);
  connect(words_, &QLineEdit::textChanged, by_words_, &QSortFilterProxyModel::setFilterFixedString);
  auto* line = new QHBoxLayout;
  line->addWidget(level_);
  line->addWidget(words_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(line);
  layout->addWidget(view_);
}

void LogPanel::add(const QString& text, LogLevel level) {
  add({QTime::currentTime().toString("HH:mm:ss"), text, level});
}

void LogPanel::add(const LogLine& line) {
  const auto* bar = view_->verticalScrollBar();
  const bool at_end = bar->value() >= bar->maximum() - 4;
  const QString words = finding_words(line.text);
  auto* time = new QStandardItem(line.time);
  auto* what = new QStandardItem(words);
  what->setData(static_cast<int>(line.level), level_role);
  what->setData(line.text, english_role);
  what->setToolTip(words);
  if (line.level != LogLevel::info)
    what->setIcon(style()->standardIcon(line.level == LogLevel::error ? QStyle::SP_MessageBoxCritical
                                                                      : QStyle::SP_MessageBoxWarning));
  time->setTextAlignment(Qt::AlignTop);
  model_->appendRow({time, what});
  if (model_->rowCount() > max_lines) model_->removeRow(0);
  if (at_end) view_->scrollToBottom();
}

std::vector<LogLine> LogPanel::all_lines() const {
  std::vector<LogLine> lines;
  for (int row = 0; row < model_->rowCount(); ++row) {
    const auto* what = model_->item(row, 1);
    lines.push_back({model_->item(row, 0)->text(), what->data(english_role).toString(),
                     static_cast<LogLevel>(what->data(level_role).toInt())});
  }
  return lines;
}

int LogPanel::lines() const { return by_words_->rowCount(); }

void LogPanel::show_from(LogLevel level) { level_->setCurrentIndex(static_cast<int>(level)); }

void LogPanel::search(const QString& words) { words_->setText(words); }

QString LogPanel::text() const {
  QStringList lines;
  for (int row = 0; row < by_words_->rowCount(); ++row)
    lines << by_words_->index(row, 0).data().toString() + " " + by_words_->index(row, 1).data().toString();
  return lines.join('\n');
}

void LogPanel::copy() const {
  QStringList lines;
  for (const auto& index : view_->selectionModel()->selectedRows(1)) lines << index.data().toString();
  QGuiApplication::clipboard()->setText(lines.join('\n'));
}

}  // namespace bole::desktop
