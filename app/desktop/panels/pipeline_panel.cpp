#include "panels/pipeline_panel.h"

#include <QHeaderView>
#include <QStyle>

namespace bole::desktop {
namespace {

QString state_text(StageState state) {
  switch (state) {
    case StageState::idle:
      return {};
    case StageState::running:
      return QObject::tr("running");
    case StageState::done:
      return QObject::tr("done");
    case StageState::warning:
      return QObject::tr("look");
    case StageState::failed:
      return QObject::tr("failed");
  }
  return {};
}

QStyle::StandardPixmap state_icon(StageState state) {
  switch (state) {
    case StageState::running:
      return QStyle::SP_BrowserReload;
    case StageState::done:
      return QStyle::SP_DialogApplyButton;
    case StageState::warning:
      return QStyle::SP_MessageBoxWarning;
    case StageState::failed:
      return QStyle::SP_MessageBoxCritical;
    case StageState::idle:
      break;
  }
  return QStyle::SP_FileIcon;
}

}  // namespace

PipelinePanel::PipelinePanel(Session& session, QWidget* parent) : QTreeWidget(parent), session_(session) {
  setColumnCount(2);
  setHeaderLabels({tr("Stage"), tr("State")});
  setRootIsDecorated(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header()->setStretchLastSection(false);
  connect(&session_, &Session::document_replaced, this, &PipelinePanel::fill);
  connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item) Q_EMIT stage_selected(item->data(0, Qt::UserRole).toString());
  });
}

void PipelinePanel::fill() {
  clear();
  for (const auto& node : session_.document().stages()) {
    auto* item = new QTreeWidgetItem(this);
    item->setText(0, QString::fromStdString(node.type->title));
    item->setData(0, Qt::UserRole, QString::fromStdString(node.id));
    item->setToolTip(0, QString::fromStdString(node.id + " (" + node.type->name + ")\n" + node.type->help));
    item->setIcon(1, style()->standardIcon(state_icon(StageState::idle)));
  }
  if (topLevelItemCount() > 0) setCurrentItem(topLevelItem(0));
}

void PipelinePanel::set_state(const QString& stage, StageState state, const QString& message) {
  for (int i = 0; i < topLevelItemCount(); ++i) {
    auto* item = topLevelItem(i);
    if (item->data(0, Qt::UserRole).toString() != stage) continue;
    item->setText(1, state_text(state));
    item->setIcon(1, style()->standardIcon(state_icon(state)));
    item->setToolTip(1, message);
  }
}

}  // namespace bole::desktop
