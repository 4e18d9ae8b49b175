// Two runs side by side: linked 3-D views, the error along the path of each, and their numbers with the differences.
#pragma once

#include <QWidget>
#include <array>

#include "document/selection.h"
#include "running/comparison.h"

class QCheckBox;
class QLabel;
class QTableWidget;

namespace bole::desktop {

class CameraLink;
class FigureView;
class SceneView;

class CompareWindow : public QWidget {
  Q_OBJECT

 public:
  struct Side {
    std::shared_ptr<const Job> job;
    JobResult result;
  };
  CompareWindow(Side first, Side second, QWidget* parent);  // with a parent too it is a window of its own

  SceneView& scene(std::size_t which) { return *scenes_[which]; }
  FigureView& errors(std::size_t which) { return *errors_[which]; }
  CameraLink& link() { return *link_; }
  const QTableWidget& table() const { return *table_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* column(std::size_t which);
  double greatest_error() const;  // along the paths of both runs, cm; 0 without reference paths
  void fill_table();
  QString title(std::size_t which) const;

  std::array<Side, 2> sides_;
  std::array<Selection, 2> selections_;  // tree ids of one run mean nothing in another
  std::array<SceneView*, 2> scenes_{};
  std::array<FigureView*, 2> errors_{};
  CameraLink* link_ = nullptr;
  QTableWidget* table_;
  QCheckBox* all_numbers_;
  bool filled_ = false;
};

}  // namespace bole::desktop
