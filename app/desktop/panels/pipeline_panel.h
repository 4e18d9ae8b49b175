// The stages of the document, with the state of the last run.
#pragma once

#include <QTreeWidget>

#include "base/report.h"
#include "document/session.h"

namespace bole::desktop {

enum class StageState { idle, running, done, warning, failed };

class PipelinePanel : public QTreeWidget {
  Q_OBJECT

 public:
  PipelinePanel(Session& session, QWidget* parent);

  void set_state(const QString& stage, StageState state, const QString& message = {});

 Q_SIGNALS:
  void stage_selected(const QString& id);

 private:
  void fill();
  Session& session_;
};

}  // namespace bole::desktop
