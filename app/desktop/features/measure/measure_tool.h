// Measures in the 3-D view by clicks. What was measured is kept beside the document, in NAME.measurements.json, written
// at every change; it can be undone with the edits of the document.
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "render/scene/measurement.h"

namespace bole::desktop {

class MeasurePanel;
class Workbench;

class MeasureTool : public QObject {
  Q_OBJECT

 public:
  explicit MeasureTool(Workbench& bench);

  const std::vector<render::Measurement>& list() const { return list_; }
  std::optional<render::Measurement::Kind> tool() const { return tool_; }
  void start(render::Measurement::Kind kind);
  void stop();
  void select(int which);
  void remove(int which);
  void rename(int which, const QString& name);
  void export_csv(const QString& path) const;  // throws bole::Error

 private:
  friend class EditMeasurements;
  void make_commands();
  void load();
  void store() const;
  QString file() const;
  void change(const QString& what, std::vector<render::Measurement> after);  // one step of undo
  void put(const std::vector<render::Measurement>& list);
  void take(const Eigen::Vector3d& place, const QVariant& point);
  void finish();
  void fit_ring(render::Measurement& ring) const;
  void draw();
  QString free_name(render::Measurement::Kind kind) const;

  Workbench& bench_;
  MeasurePanel* panel_;
  std::vector<render::Measurement> list_;
  std::optional<render::Measurement::Kind> tool_;
  std::optional<render::Measurement> open_;  // being clicked
  int selected_ = -1;
  QString unread_;  // a file that is there and could not be read
};

}  // namespace bole::desktop
