// The stages of the document, with the state of the last run and an eye for each view. Its menu adds, renames, deletes
// and copies stages; every step can be undone.
#pragma once

#include <QTreeWidget>
#include <functional>

#include "document/session.h"
#include "document/visibility.h"

class QMenu;

namespace bole::desktop {

class Commands;
class StageStates;

class PipelinePanel : public QTreeWidget {
  Q_OBJECT

 public:
  enum Column { stage_column, scene_column, cuts_column, state_column };

  PipelinePanel(Session& session, Visibility& visibility, const StageStates& states, Commands& commands,
                QWidget* parent);

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
  void fill();
  void fit_columns(bool on);
  void for_all(const std::function<void(QTreeWidgetItem*)>& change);
  void show_states();
  void show_state(QTreeWidgetItem* item);
  void show_eyes(QTreeWidgetItem* item);
  void click(QTreeWidgetItem* item, int column);
  void make_commands(Commands& commands);
  void fill_add_menu(QMenu& menu);
  void guarded(const std::function<void()>& act);

  Session& session_;
  Visibility& visibility_;
  const StageStates& states_;
};

}  // namespace bole::desktop
