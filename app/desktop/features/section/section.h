// Cross-sections: a line in the 3-D view with a width gives a profile beside it. It steps sideways by its width, or on
// along the walk or the selected row; what measures in the 3-D view measures in it too.
#pragma once

#include <QObject>
#include <map>
#include <optional>
#include <vector>

#include "document/cross_section.h"
#include "running/last_wish.h"
#include "views/clouds/scene_cloud.h"

class QDockWidget;
class QDoubleSpinBox;
class QLabel;
class QTimer;

namespace bole::desktop {

class SectionView;
class Workbench;

class SectionTool : public QObject {
  Q_OBJECT

 public:
  explicit SectionTool(Workbench& bench);

  const std::optional<SectionLine>& line() const { return line_; }
  SectionView& view() { return *view_; }
  void show(const SectionLine& line);  // a free one
  void draw_line(bool on);             // by two clicks in the 3-D view
  void across_walk();                  // throw bole::Error where there is none
  void across_row();                   // the selected one
  void along_row();
  void step(int by);  // by its width: along its path, else sideways
  void clear();
  void save(const QString& path) const;  // PNG, SVG or PDF; throws bole::Error

 private:
  void make_dock();
  void make_commands();
  void take(const Eigen::Vector3d& place);
  void drag(int grip, const Eigen::Vector3d& at, bool released);
  void follow(std::vector<Eigen::Vector2d> path);
  void put_on_path(double at_m);
  void put(const SectionLine& line, bool keep_sight);
  void cut(bool keep_sight);
  void cut_soon();
  struct SlabWish {
    std::shared_ptr<const DiskPoints> disk;  // of the survey; null where its points are in memory
    SectionLine line;
    std::vector<SceneCloud> beside;  // that lie on the disk
  };
  struct Slab {
    std::shared_ptr<const PointCloud> survey;                 // null where its points are in memory
    std::map<int, std::shared_ptr<const PointCloud>> beside;  // by the id of the cloud
  };
  void show_cut(const Survey& of, bool keep_sight, const Slab& slab = {});
  void ask_disk();
  void read_slab(const SlabWish& wish, const std::stop_token& stop, const LastWish<SlabWish>::Answer& answer);
  void take_slab(const SlabWish& wish, const Slab& slab);
  std::vector<SceneCloud> beside_on_disk() const;
  void join_point_tools();
  void take_outline(const std::vector<Eigen::Vector2d>& corners);
  void take_stroke(std::uint32_t point, bool begins);
  void click(const std::optional<std::uint32_t>& point, std::int64_t stem);
  void draw_in_scene();
  void draw_measurements();
  void show_where();
  std::vector<Eigen::Vector2d> selected_row() const;

  Workbench& bench_;
  SectionView* view_;
  QDockWidget* dock_ = nullptr;
  QLabel* where_;
  QDoubleSpinBox *width_, *length_;
  QTimer* soon_;
  Survey survey_;  // what cuts show of it
  Survey cut_;     // of which the points that are shown are: read from the disk where the survey lies there
  std::vector<SectionCloud> beside_;  // likewise
  std::vector<int> beside_ids_;       // of the clouds of beside_
  LastWish<SlabWish> slabs_{this};
  bool reads_disk_ = false;
  std::optional<SectionLine> line_;
  std::vector<Eigen::Vector2d> path_;  // that the line is stepped along; empty: it is free
  double at_m_ = 0;                    // of the path
  std::optional<Eigen::Vector2d> first_;
  bool drawing_ = false;
  bool outlines_ = false;  // the outline that is told about was drawn in the section
  bool moved_ = false;     // another line since the last cut
};

}  // namespace bole::desktop
