// The list of what was measured in the 3-D view, with all its numbers.
#pragma once

#include <QWidget>
#include <vector>

#include "render/scene/measurement.h"

class QPushButton;
class QTreeWidget;

namespace bole::desktop {

class MeasurePanel : public QWidget {
  Q_OBJECT

 public:
  explicit MeasurePanel(QWidget* parent);

  void show_list(const std::vector<render::Measurement>& list);
  void select(int which);  // -1: none
  int selected() const;

 Q_SIGNALS:
  void selection_changed(int which);
  void renamed(int which, const QString& name);
  void remove_asked(int which);
  void export_asked();
  void zoom_asked(int which);

 private:
  QTreeWidget* tree_;
  QPushButton *remove_, *export_;
  bool following_ = false;
};

}  // namespace bole::desktop
