// The stages of the document, with the state of the last run and an eye for each view. Its menu adds, renames, deletes
// and copies stages; every step can be undone.
#pragma once

#include <QTreeWidget>

#include "document/session.h"
#include "document/visibility.h"
#include "look/stage_icons.h"

class QMenu;

namespace bole::desktop {

class Commands;

class PipelinePanel : public QTreeWidget {
  Q_OBJECT

 public:
  enum Column { stage_column, scene_column, cuts_column, state_column };

  PipelinePanel(Session& session, Visibility& visibility, Commands& commands, QWidget* parent);

  void set_state(const QString& stage, StageMark state, const QString& message = {});
  void forget_states();  // of runs of another document
  QString current_stage() const;
  void select_stage(const QString& id);

  // What the menu does. Throw bole::Error.
  void add_stage(const QString& type);  // behind the current one
  void delete_stage(const QString& id);
  void rename_stage(const QString& id, const QString& to);
  void copy_branch(const QString& id);

 Q_SIGNALS:
  void stage_selected(const QString& id);
  void refused(const QString& sentence);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct State {
    StageMark state = StageMark::idle;
    QString message;
  };
  void fill();
  void show_problems();  // what keeps stages from running, as the tooltip and the mark of the stage
  void show_state(QTreeWidgetItem* item);
  void show_eyes(QTreeWidgetItem* item);
  void click(QTreeWidgetItem* item, int column);
  void make_commands(Commands& commands);
  void fill_add_menu(QMenu& menu);
  void guarded(const std::function<void()>& act);

  Session& session_;
  Visibility& visibility_;
  QMap<QString, State> states_;
  QMap<QString, QString> problems_;
};

}  // namespace bole::desktop
