#include "views/walk_layers.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "render/scene/actors.h"

namespace bole::desktop {
namespace {

constexpr std::size_t keyframes_per_block = 32;
constexpr std::size_t max_map_points = 400'000;  // drawn of the map: what software OpenGL turns fluently
constexpr double sensor_height_m = 1.5;          // about: the ground lies below the path
constexpr double top_m = 8;                      // above the ground, where the colours end
constexpr double ground_below_m = 0.4;           // the ground is not known yet, only the height of the sensor
constexpr double sensor_radius_m = 0.25;
constexpr double margin_m = 7;  // about the path, that a camera shows
const render::Color ground_grey = render::hex(0xb9b1a4);
const render::Color frame_color = render::hex(0xe8590c);

using Segments = std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>;

vtkSmartPointer<vtkActor> actor_of(vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

void paint(vtkActor* actor, const render::Color& color) {
  actor->GetMapper()->ScalarVisibilityOff();
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
}

// Points of a scene, with colours or without.
class PointsBuilder {
 public:
  PointsBuilder() {
    points_->SetDataTypeToFloat();
    colors_->SetNumberOfComponents(3);
  }
  void add(const Eigen::Vector3d& p) { points_->InsertNextPoint(p.data()); }
  void add(const Eigen::Vector3d& p, const render::Color& c) {
    add(p);
    colors_->InsertNextTuple3(255 * c.r, 255 * c.g, 255 * c.b);
  }
  std::size_t size() const { return static_cast<std::size_t>(points_->GetNumberOfPoints()); }
  vtkSmartPointer<vtkActor> actor(double size_px) {
    std::vector<vtkIdType> ids(size());
    std::iota(ids.begin(), ids.end(), vtkIdType{0});
    vtkNew<vtkCellArray> verts;
    if (!ids.empty()) verts->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_);
    data->SetVerts(verts);
    const bool colored = colors_->GetNumberOfTuples() > 0;
    if (colored) data->GetPointData()->SetScalars(colors_);
    auto actor = actor_of(data);
    if (colored) actor->GetMapper()->SetColorModeToDirectScalars();
    actor->GetProperty()->SetPointSize(static_cast<float>(size_px));
    return actor;
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

vtkSmartPointer<vtkActor> lines_actor(const Segments& segments, const Eigen::Vector3d& origin,
                                      const render::Color& color) {
  if (segments.empty()) return nullptr;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const auto& [a, b] : segments) {
    const Eigen::Vector3d from = a - origin, to = b - origin;
    const vtkIdType ids[]{points->InsertNextPoint(from.data()), points->InsertNextPoint(to.data())};
    lines->InsertNextCell(2, ids);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  auto actor = actor_of(data);
  paint(actor, color);
  actor->GetProperty()->SetLineWidth(3);
  return actor;
}

// A quiet ground, as the survey has it.
render::Color height_color(double above_ground_m) {
  return above_ground_m < ground_below_m ? ground_grey : render::ColorMap::viridis().at(above_ground_m / top_m);
}

void widen(vtkActor& actor, double by) {
  auto& look = *actor.GetProperty();
  look.SetPointSize(static_cast<float>(by * static_cast<double>(look.GetPointSize())));
  look.SetLineWidth(static_cast<float>(by * static_cast<double>(look.GetLineWidth())));
}

}  // namespace

void WalkLayers::set(vtkSmartPointer<vtkActor>& slot, const vtkSmartPointer<vtkActor>& actor) {
  if (slot) renderer_->RemoveActor(slot);
  slot = actor;
  if (!slot) return;
  widen(*slot, ratio_);
  renderer_->AddActor(slot);
}

void WalkLayers::set_pixel_ratio(double ratio) {
  const double by = ratio / std::exchange(ratio_, ratio);
  if (by == 1) return;
  auto actors = blocks_;
  actors.insert(actors.end(), {path_, good_loops_, bad_loops_, frame_, sensor_});
  for (const auto& actor : actors)
    if (actor) widen(*actor, by);
}

void WalkLayers::set_dark(bool dark) {
  dark_ = dark;
  for (const auto& [actor, color] : {std::pair{path_, render::ink::primary},
                                     {good_loops_, render::ink::good},
                                     {bad_loops_, render::ink::poor},
                                     {sensor_, render::ink::accent}})
    if (actor) paint(actor, shown(color));
}

void WalkLayers::clear() {
  for (auto& block : blocks_) set(block, nullptr);
  blocks_.clear();
  block_points_.clear();
  for (auto* slot : {&path_, &good_loops_, &bad_loops_}) set(*slot, nullptr);
  hide_frame();
  origin_.setZero();
  step_ = 1;
  drawn_ = accepted_ = refused_ = 0;
}

void WalkLayers::set_block(std::size_t block, const LiveMap& map) {
  const auto& keyframes = map.keyframes();
  PointsBuilder points;
  const std::size_t first = block * keyframes_per_block, last = std::min(first + keyframes_per_block, keyframes.size());
  for (std::size_t k = first; k < last; ++k) {
    const double ground_m = keyframes[k].T_map_keyframe.translation().z() - sensor_height_m;
    for (std::size_t i = 0; i < keyframes[k].points.size(); i += step_) {
      const Eigen::Vector3d p = keyframes[k].T_map_keyframe * keyframes[k].points[i].cast<double>();
      points.add(p - origin_, height_color(p.z() - ground_m));
    }
  }
  if (block >= blocks_.size()) {
    blocks_.resize(block + 1);
    block_points_.resize(block + 1);
  }
  block_points_[block] = points.size();
  set(blocks_[block], points.size() > 0 ? points.actor(2) : nullptr);
}

void WalkLayers::show_live(LiveMap& map, bool frame) {
  std::size_t first = map.take_first_changed();
  if (const auto step = map.points() / max_map_points + 1; step > step_) {
    step_ = step;
    first = 0;
  }
  const std::size_t blocks = (map.keyframes().size() + keyframes_per_block - 1) / keyframes_per_block;
  for (std::size_t b = blocks; b < blocks_.size(); ++b) set(blocks_[b], nullptr);
  if (blocks < blocks_.size()) {
    blocks_.resize(blocks);
    block_points_.resize(blocks);
  }
  for (std::size_t b = first / keyframes_per_block; b < blocks; ++b)
    if (first < map.keyframes().size()) set_block(b, map);
  drawn_ = std::accumulate(block_points_.begin(), block_points_.end(), std::size_t{0});
  if (map.path()) set_path(*map.path());
  Segments good, bad;
  const auto place = [&](std::size_t k) { return Eigen::Vector3d(map.keyframes()[k].T_map_keyframe.translation()); };
  for (const auto& loop : map.loops())
    if (loop.to < map.keyframes().size()) (loop.accepted ? good : bad).emplace_back(place(loop.from), place(loop.to));
  set_loops(good, bad);
  if (frame && map.frame() && map.path() && !map.path()->poses.empty()) {
    std::vector<Eigen::Vector3d> positions;
    positions.reserve(map.frame()->size());
    for (std::size_t i = 0; i < map.frame()->size(); ++i) positions.push_back(map.frame()->position(i));
    set_frame(positions, map.path()->poses.back().T_target_sensor.translation());
  }
}

void WalkLayers::show_survey(const Survey& survey, const Table* loops) {
  clear();
  if (survey.points && !survey.points->empty()) {
    origin_ = survey.points->origin;
    std::vector<std::uint32_t> thinned;
    const std::size_t step = survey.points->size() / max_map_points + 1;
    for (std::size_t i = 0; i < survey.points->size(); i += step) thinned.push_back(static_cast<std::uint32_t>(i));
    blocks_.resize(1);
    set(blocks_[0],
        render::points_actor(*survey.points, thinned,
                             render::coloring_for(*survey.points, thinned, render::PointColor::height), origin_, 2));
    drawn_ = thinned.size();
  }
  if (!survey.walk || survey.walk->poses.size() < 2) return;
  set_path(*survey.walk);
  if (!loops || !loops->has("from_time_s")) return;
  const auto from = loops->numbers("from_time_s"), to = loops->numbers("to_time_s");
  Segments good;
  for (std::size_t i = 0; i < from.size(); ++i) {
    try {
      good.emplace_back(survey.walk->at(from[i]).translation(), survey.walk->at(to[i]).translation());
    } catch (const Error&) {  // a key frame in a gap of the path
    }
  }
  set_loops(good, {});
}

void WalkLayers::set_path(const Trajectory& path) {
  if (path.poses.size() < 2) return set(path_, nullptr);
  vtkNew<vtkPoints> points;
  std::vector<vtkIdType> ids;
  for (const auto& pose : path.poses) {
    const Eigen::Vector3d p = pose.T_target_sensor.translation() - origin_;
    ids.push_back(points->InsertNextPoint(p.data()));
  }
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  auto actor = actor_of(data);
  paint(actor, shown(render::ink::primary));
  actor->GetProperty()->SetLineWidth(3);
  set(path_, actor);
}

void WalkLayers::set_loops(const Segments& accepted, const Segments& refused) {
  accepted_ = accepted.size();
  refused_ = refused.size();
  set(good_loops_, lines_actor(accepted, origin_, shown(render::ink::good)));
  set(bad_loops_, lines_actor(refused, origin_, shown(render::ink::poor)));
}

void WalkLayers::show_frame(const PlacedFrame& frame) {
  set_frame(frame.positions, frame.T_target_sensor.translation());
}

void WalkLayers::set_frame(const std::vector<Eigen::Vector3d>& positions, const Eigen::Vector3d& sensor) {
  PointsBuilder points;
  for (const auto& p : positions) points.add(p - origin_);
  auto actor = points.actor(2);
  paint(actor, frame_color);
  set(frame_, actor);
  vtkNew<vtkSphereSource> ball;
  const Eigen::Vector3d at = sensor - origin_;
  ball->SetCenter(at.x(), at.y(), at.z());
  ball->SetRadius(sensor_radius_m);
  ball->SetThetaResolution(16);
  ball->SetPhiResolution(12);
  ball->Update();
  auto mark = actor_of(ball->GetOutput());
  paint(mark, shown(render::ink::accent));
  set(sensor_, mark);
}

std::pair<Eigen::Vector3d, Eigen::Vector3d> WalkLayers::extent() const {
  const auto& from = path_ ? path_ : frame_ ? frame_ : blocks_.empty() ? nullptr : blocks_.front();
  if (!from) return {Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero()};
  const double* b = from->GetBounds();
  Eigen::Vector3d lo(b[0], b[2], b[4]), hi(b[1], b[3], b[5]);
  if (path_) {
    lo -= Eigen::Vector3d(margin_m, margin_m, sensor_height_m);
    hi += Eigen::Vector3d(margin_m, margin_m, top_m / 2);
  }
  return {lo, hi};
}

void WalkLayers::hide_frame() {
  set(frame_, nullptr);
  set(sensor_, nullptr);
}

}  // namespace bole::desktop
