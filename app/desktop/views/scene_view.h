// The 3-D view of a survey: points, fitted stems and the walk, drawn from the same parts as the figures of the report.
// Points come from an octree: while the camera moves as many as the frame has time for; when it rests all that are
// seen, some in each frame.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QPoint>
#include <QTimer>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "document/selection.h"
#include "document/survey.h"
#include "render/beside/still_points_renderer.h"
#include "render/draw/screen_look.h"
#include "render/scene/camera_shapes.h"
#include "render/scene/furniture_layer.h"
#include "render/scene/pick.h"
#include "render/scene/point_layer.h"
#include "views/camera_layer.h"
#include "views/clouds/cloud_layers.h"
#include "views/frame_pace.h"
#include "views/map/map_layer.h"
#include "views/map/terrain_layer.h"
#include "views/scene_drawing.h"
#include "views/scene_outline.h"
#include "views/view_point.h"
#include "views/view_settings.h"

class QImage;
class vtkActor;

namespace bole::desktop {

class ClipHandles;
class MapStyle;

// Where a perspective view is seen from.
struct SceneEye {
  Pose T_world_camera = Pose::Identity();  // x right, y down, z ahead
  double tan_half_height = 0;              // of the angle of view
  int width_px = 0, height_px = 0;
};

class SceneView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  SceneView(Selection& selection, QWidget* parent);
  ~SceneView() override;

  void show_survey(const Survey& survey);
  bool has_survey() const { return !survey_.empty(); }
  const Survey& survey() const { return survey_; }

  const ViewSettings& settings() const { return settings_; }
  void set_settings(const ViewSettings& settings);  // takes effect at once
  void color_by(const std::string& array);
  std::vector<std::string> colorable() const;  // arrays of the cloud
  const render::PointPaint& paint() const { return layer_.paint(); }
  void set_filter(const render::PointFilter& filter);
  const render::ClipBox& whole() const { return whole_; }              // around the cloud but its strays
  bool extent_known() const { return has_survey() && extent_known_; }  // whole() is that of something
  bool north_known() const;                                            // from the axes of the points, or a map
  render::ClipBox everything() const;                                  // around every point; looks at each
  const render::Interval& heights() const { return heights_; }  // above ground, or z, of the cloud but its strays
  void show_clip_handles(bool on);
  bool clip_handles_shown() const;

  void reset_camera();
  bool camera_moved() const;  // since the view itself put it somewhere
  void look_along(const Eigen::Vector3d& direction, const Eigen::Vector3d& up);  // all of the survey
  void set_parallel(bool on);
  bool parallel() const;
  void set_flat(bool on);  // a drag moves the view in place of turning it
  bool flat() const;
  void zoom_to_tree(std::int64_t id);
  void zoom_to(const Eigen::Vector3d& place);
  void zoom_to(const render::ClipBox& box);  // all of it, from where the camera looks
  Eigen::Vector3d centre() const;            // of rotation, world coordinates
  // Moves and turns the eye (scene_camera.h); what it looks at is then the centre of rotation.
  void fly(const Eigen::Vector3d& right_up_ahead_m, double right_rad, double up_rad);

  // The point under a place of the widget; selects its tree, or the stem there.
  void pick(const QPoint& at);
  std::optional<std::uint32_t> picked() const;  // where it is a point of the survey, and not of a cloud on disk

  // While somebody takes places, a click gives one to all who listen instead of selecting what is there. One at a time:
  // a taker that hears of another one stops. Null: nobody. Where outlines are taken the left button draws one. Where
  // corners are, clicks add to one and a drag draws a part of it: it is told after each, and stays until
  // drop_outline(). Strokes are places in a row under the left button that is held.
  enum class Takes { places, outlines, corners, strokes };
  void set_place_taker(const QObject* taker, Takes takes = Takes::places);
  const QObject* place_taker() const { return place_taker_; }
  Takes takes() const { return takes_; }
  // Gives the place of a point to all who listen; `beside`: id of the cloud beside the survey that it belongs to.
  void give_place(const render::PickedPoint& point, int beside = 0);
  // The cloud of the point that was given last: that of the survey, a part of a cloud on disk, or one beside it.
  const std::shared_ptr<const PointCloud>& taken_cloud() const { return taken_cloud_; }
  bool taken_from_survey() const { return taken_beside_ == 0; }
  int taken_beside() const { return taken_beside_; }  // id of the cloud beside the survey; 0: of the survey
  void drop_outline();
  // Points of the survey that stand out until others do, or another survey is shown. At most 300 000 are drawn.
  void mark_points(const std::vector<std::uint32_t>& points);
  const std::vector<std::uint32_t>& marked_points() const { return marked_points_; }

  Qt::KeyboardModifiers drag_keys() const { return drag_keys_; }  // that are held while a grip is dragged

  // What lies over the picture, one list for each layer ("rows", "measurements").
  void set_drawings(const std::string& layer, std::vector<SceneDrawing> drawings);
  const std::vector<SceneDrawing>& drawings(const std::string& layer) const;
  const std::vector<render::StemShape>& stem_shapes() const { return shapes_; }
  QPoint place_of(const Eigen::Vector3d& world);  // in the widget; (-1, -1) behind the eye

  // The cameras of views, in the axes of the survey; a click on one selects its view.
  void set_cameras(std::vector<render::CameraShape> cameras);
  const std::vector<render::CameraShape>& cameras() const { return cameras_.shapes(); }
  void show_picture(std::size_t view, const ColorImage& picture);  // in the camera of that view while it is selected

  // Clouds to look at beside the survey, of which no stage knows: they are drawn, clipped, picked and cut as it is.
  void set_clouds(std::vector<SceneCloud> clouds);
  const std::vector<SceneCloud>& clouds() const { return clouds_.clouds(); }
  const CloudLayers& cloud_layers() const { return clouds_; }

  // A picture of the place below the survey; null: none. Shown as the settings have it.
  void set_map(std::shared_ptr<const SceneMap> map);
  const std::shared_ptr<const SceneMap>& map() const { return map_.map(); }
  const std::optional<render::PlacedPicture>& map_shown() const { return map_.shown(); }
  Eigen::Vector2d north() const;  // unit, world x and y: that of the map, else the y axis
  const TerrainLayer& terrain_layer() const { return terrain_; }

  std::optional<SceneEye> eye();  // none of a parallel view
  // A picture of what is seen from the eye, over the points until the eye moves.
  void show_rendering(const ColorImage& picture);
  void hide_rendering();
  bool rendering_shown() const { return rendering_; }

  // As it is seen, `width_px` wide; the height follows from the shape of the view. Throws bole::Error for a size that
  // cannot be drawn.
  QImage picture(int width_px, bool transparent);
  ViewPoint view_point() const;
  void set_view_point(const ViewPoint& point);

  int actor_count();  // of things that are shown, the cloud as one
  std::size_t drawn_points() const { return layer_.drawn(); }
  const render::StillPointsRenderer& points_renderer() const { return *renderer_.Get(); }
  bool refined() const { return complete_ && !moving_ && awaited() == 0; }
  // While one lives frames wait; then one shows all that has changed.
  class Hold {
   public:
    explicit Hold(SceneView& view) : view_(view) { view_.hold_frames(); }
    ~Hold() { view_.let_frames(); }
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   private:
    SceneView& view_;
  };
  // One frame as it is drawn while the camera moves; seconds. For the frame-rate test and benchmark.
  double draw_moving_frame();
  double frame_target_s() const;

 Q_SIGNALS:
  void point_picked(const QStringList& facts);
  void place_taken(const Eigen::Vector3d& place, const QVariant& point);  // index in taken_cloud(), null on bare ground
  void outline_taken(const SceneOutline& outline);
  void stroke_taken(const Eigen::Vector3d& place, bool begins);
  void stroke_ended();
  void outline_dropped();
  void points_marked();
  void place_taker_changed(const QObject* taker);
  void drawing_clicked(const QString& layer, int drawing);
  void drawings_changed(const QString& layer);
  void grip_dragged(const QString& layer, int drawing, int grip, const Eigen::Vector3d& at, bool released);
  void menu_asked(const QPoint& global);  // by a right click
  void settings_changed();                // by the view: handles of the clip box, another survey
  void index_built();
  void clouds_changed();  // those beside the survey
  void map_changed();     // another one, or none
  void eye_moved();       // or the size of the view changed; after the frame that showed it

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void follow_theme();
  void follow_index();
  void show_points();
  void take_arrivals();
  std::size_t awaited() const { return layer_.awaited() + clouds_.awaited(); }
  void dress_clouds();
  void size_points(double scale = 1);  // of a picture against the window
  void rebuild();
  void repaint_points();
  void take_trees();
  void add_trees(render::ViewFurniture& furniture, const render::PickView& view, double sheet_mm_per_px);
  void clip_solids();
  bool sees_stem(const Eigen::Vector2d& from, const render::StemShape& stem) const;
  void measure_extent();
  void draw_cameras();
  void draw_map();
  void draw_terrain();
  std::optional<render::ClipBox> all_of_it() const;
  void rebuild_grid();
  void draw_in_theme();
  void draw_highlight();
  void redraw();
  void draw_now();
  void hold_frames();
  void note_frame_of_vtk() {
    frame_wanted_ = frame_wanted_ || holds_ > 0;
  }  // asked for, and drawn unless they are held
  void let_frames();
  void begin_motion();
  void begin_interaction();
  void before_frame();
  void place_clipping_planes();
  void after_frame();
  void frame_shown();
  void follow_eye();
  void place_furniture();
  std::vector<double> sorted_sample(int axis) const;
  render::PickView pick_view();
  Eigen::Vector2d to_pixels(const QPoint& at) const;
  struct PointThere {
    render::PickedPoint point;
    const SceneCloud* beside = nullptr;  // null: of the survey
  };
  std::optional<PointThere> point_at(const QPoint& at, bool of_survey_only = false);
  std::optional<Grip> grip_at(const QPoint& at);
  bool click_drawing(const QPoint& at);
  bool behind_a_stem(const Eigen::Vector3d& point, const QPoint& at);
  void take_place(const QPoint& at);
  Eigen::Vector3d stem_place_of(std::int64_t tree) const;  // at breast height; the centre when it is not drawn
  void draw_outline();
  void take_outline();
  void take_stroke(const QPoint& at, bool begins);
  bool takes_drag() const { return dragged_ || stroking_ || !path_px_.empty(); }
  SceneOutline outline_drawn();

  Selection& selection_;
  Survey survey_;
  ViewSettings settings_;
  render::ClipBox whole_;
  render::Interval heights_;
  bool extent_known_ = false;
  std::vector<render::StemShape> shapes_;
  struct SceneTree {
    std::int64_t id;
    Eigen::Vector3d place;  // of its number
    std::string quality, state;
  };
  std::vector<SceneTree> trees_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  render::ScreenLook look_;
  render::PointLayer layer_;
  double point_ratio_ = 0;  // pixels of the screen for one of Qt, when the points got their size
  vtkNew<render::StillPointsRenderer> renderer_;
  CloudLayers clouds_;                                 // beside the survey
  std::shared_ptr<const render::GroundBelow> ground_;  // of the survey, for their heights; made when it is needed
  vtkSmartPointer<MapStyle> style_;
  render::FurnitureLayer furniture_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
  vtkSmartPointer<vtkActor> path_;  // of them
  vtkSmartPointer<vtkActor> highlight_, grid_, marked_;
  std::vector<std::uint32_t> marked_points_;  // of the survey
  CameraLayer cameras_;
  MapLayer map_;
  TerrainLayer terrain_;
  Eigen::Vector3d eye_ = Eigen::Vector3d::Zero();  // where look_along() put the camera
  std::vector<double> last_eye_;                   // of the last frame: place, direction, angle and size
  std::vector<double> clipped_eye_;                // that the clipping planes are for
  std::vector<double> still_eye_;                  // of the last frame at rest; empty: the points changed since
  bool rendering_ = false;                         // a picture lies over the points
  bool photo_by_itself_ = false;                   // nobody asked for the colours of the cloud
  double grid_step_m_ = 0;
  std::unique_ptr<ClipHandles> clip_handles_;
  std::map<std::string, std::vector<SceneDrawing>> drawings_;
  std::optional<render::PickedPoint> picked_;
  std::shared_ptr<const PointCloud> taken_cloud_;
  int taken_beside_ = 0;
  QStringList facts_;

  static constexpr int rest_ms = 150;  // without a movement, until all points are drawn
  QTimer rest_;
  QMetaObject::Connection arrivals_;  // of points from the disk
  bool moving_ = false, complete_ = true, timed_ = false;
  bool at_once_ = false;    // all points in one frame, however long it takes
  bool thinned_ = false;    // the last frame has fewer points, since the camera moves
  bool frame_due_ = false;  // once the view rests: points are missing
  int holds_ = 0;
  std::optional<Hold> click_;  // from the release of a button until what was clicked is selected
  bool frame_wanted_ = false;  // while frames are held
  const QObject* place_taker_ = nullptr;
  Takes takes_ = Takes::places;
  std::vector<Eigen::Vector2d> path_px_;      // of the outline that is being drawn
  std::optional<Eigen::Vector2d> cursor_px_;  // where its next corner would be
  bool stroking_ = false;
  FramePace pace_;
  std::chrono::steady_clock::time_point frame_start_;
  double drawing_s_ = 0;  // of the last frame
  QPoint pressed_at_;
  bool double_clicked_ = false;  // the release that follows picks nothing
  std::optional<Grip> dragged_;
  Qt::KeyboardModifiers drag_keys_;
};

}  // namespace bole::desktop
