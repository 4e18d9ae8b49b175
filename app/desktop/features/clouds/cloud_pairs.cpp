#include "features/clouds/cloud_pairs.h"

#include <QVariant>
#include <algorithm>
#include <limits>

#include "features/clouds/cloud_align.h"
#include "features/clouds/clouds.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

const std::string pair_layer = "cloud_pairs";

}  // namespace

CloudPairs::CloudPairs(Clouds& clouds, Workbench& bench) : QObject(&clouds), clouds_(clouds), bench_(bench) {
  auto& scene = bench_.scene();
  connect(&scene, &SceneView::place_taken, this, &CloudPairs::take);
  connect(&scene, &SceneView::place_taker_changed, this, [this](const QObject* taker) {
    if (taker == this || cloud_ == 0) return;
    cloud_ = 0;
    first_.reset();
    bench_.hint({});
    tell();
  });
  connect(&bench_, &Workbench::document_opened, this, [this] {
    stop();
    pairs_.clear();
    tell();
  });
  connect(&clouds_, &Clouds::changed, this, [this] {
    if (cloud_ != 0 && !clouds_.is_drawn(cloud_)) stop();
    draw();
  });
}

const std::vector<CloudPair>& CloudPairs::of(int cloud) const {
  static const std::vector<CloudPair> none;
  const auto it = pairs_.find(cloud);
  return it == pairs_.end() ? none : it->second;
}

QString CloudPairs::next_click() const {
  if (cloud_ == 0) return {};
  const auto* cloud = clouds_.find(cloud_);
  const QString name = cloud == nullptr ? QString() : cloud->name();
  if (!first_) return tr("Click a point of %1, or the point that it belongs to.").arg(name);
  return first_->of == cloud_ ? tr("Click where this point of %1 belongs: in the survey or another cloud.").arg(name)
                              : tr("Click the point of %1 that belongs there.").arg(name);
}

void CloudPairs::start(int cloud) {
  if (!clouds_.is_drawn(cloud))
    throw bad_input("the cloud is not drawn", "one whose points can be clicked",
                    "Tick it in the list, or move it here");
  bench_.scene().set_place_taker(this);
  cloud_ = cloud;
  first_.reset();
  tell();
}

void CloudPairs::stop() {
  if (cloud_ != 0) bench_.scene().set_place_taker(nullptr);
}

// In either order: what is in front is clicked first.
void CloudPairs::take(const Eigen::Vector3d& place, const QVariant& point) {
  if (cloud_ == 0) return;
  if (point.isNull()) return bench_.say(tr("There is no point here. Click one that is drawn."));
  const int of = bench_.scene().taken_beside();
  const auto* entry = of == 0 ? nullptr : clouds_.find(of);
  if (of != 0 && entry == nullptr) return;
  const End end{entry == nullptr ? place : entry->place().back(place), of};
  if (!first_) {
    first_ = end;
    return tell();
  }
  if ((first_->of == cloud_) == (of == cloud_)) {
    const auto* cloud = clouds_.find(cloud_);
    bench_.say((of == cloud_ ? tr("Both points are of %1: the second one takes the place of the first.")
                             : tr("Neither point is of %1: the second one takes the place of the first."))
                   .arg(cloud == nullptr ? QString() : cloud->name()));
    first_ = end;
    return tell();
  }
  const auto& own = of == cloud_ ? end : *first_;
  const auto& other = of == cloud_ ? *first_ : end;
  pairs_[cloud_].push_back({own.at_m, other.of, other.at_m, true});
  first_.reset();
  selected_ = static_cast<int>(pairs_[cloud_].size()) - 1;
  tell();
}

void CloudPairs::use(int cloud, int which, bool on) {
  auto& pairs = pairs_[cloud];
  if (which < 0 || which >= static_cast<int>(pairs.size())) return;
  pairs[static_cast<std::size_t>(which)].used = on;
  tell();
}

void CloudPairs::remove(int cloud, int which) {
  auto& pairs = pairs_[cloud];
  if (which < 0 || which >= static_cast<int>(pairs.size())) return;
  pairs.erase(pairs.begin() + which);
  tell();
}

void CloudPairs::clear(int cloud) {
  pairs_.erase(cloud);
  first_.reset();
  tell();
}

void CloudPairs::set_with_scale(bool on) {
  with_scale_ = on;
  tell();
}

void CloudPairs::show(int cloud, int selected) {
  if (cloud == shown_ && selected == selected_) return;
  if (cloud_ != 0 && cloud != cloud_) stop();
  shown_ = cloud;
  selected_ = selected;
  draw();
}

// Both points as they are seen; nothing where the cloud of the other point is gone.
std::optional<alignment::PointPair> CloudPairs::in_view(int cloud, const CloudPair& pair) const {
  const auto* moved = clouds_.find(cloud);
  const auto* other = pair.onto == 0 ? nullptr : clouds_.find(pair.onto);
  if (moved == nullptr || (pair.onto != 0 && other == nullptr)) return {};
  return alignment::PointPair{moved->place().of(pair.own_m),
                              other == nullptr ? pair.there_m : other->place().of(pair.there_m)};
}

CloudPairs::Solution CloudPairs::solve(int cloud) const {
  Solution solution;
  std::vector<alignment::PointPair> used;
  for (const auto& pair : of(cloud))
    if (const auto seen = in_view(cloud, pair); seen && pair.used) used.push_back(*seen);
  solution.used = used.size();
  solution.problem = alignment::problem_of(used);
  if (solution.problem == alignment::PairProblem::none) solution.fit = alignment::fit_pairs(used, with_scale_);
  for (const auto& pair : of(cloud)) {
    const auto seen = in_view(cloud, pair);
    solution.residual_m.push_back(seen && solution.fit ? alignment::residual_m(solution.fit->motion, *seen)
                                                       : std::numeric_limits<double>::quiet_NaN());
  }
  return solution;
}

void CloudPairs::move(int cloud) {
  const auto* moved = clouds_.find(cloud);
  if (moved == nullptr) return;
  std::vector<alignment::PointPair> used;
  for (const auto& pair : of(cloud))
    if (const auto seen = in_view(cloud, pair); seen && pair.used) used.push_back(*seen);
  const auto fit = alignment::fit_pairs(used, with_scale_);
  const QString name = moved->name();
  stop();
  clouds_.place(cloud, placed_after(*moved, fit.motion), tr("move %1 by pairs of points").arg(name));
  bench_.say(tr("%1 was moved by %2 pairs of points: RMS %3 m").arg(name).arg(used.size()).arg(fit.rms_m, 0, 'f', 3));
  tell();
}

void CloudPairs::tell() {
  bench_.hint(next_click());
  draw();
  Q_EMIT changed();
  bench_.commands().update();
}

void CloudPairs::draw() {
  std::vector<SceneDrawing> drawings;
  const auto& pairs = of(shown_);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto seen = in_view(shown_, pairs[k]);
    if (!seen) continue;
    SceneDrawing d;
    d.lines = {{seen->moved, seen->fixed}};
    d.marks = {seen->moved, seen->fixed};
    d.label = QString::number(k + 1).toStdString();
    d.label_at = seen->fixed;
    d.strong = static_cast<int>(k) == selected_;
    d.warning = !pairs[k].used;
    drawings.push_back(std::move(d));
  }
  if (first_)
    if (const auto* entry = first_->of == 0 ? nullptr : clouds_.find(first_->of); first_->of == 0 || entry) {
      SceneDrawing d;
      d.marks = {entry == nullptr ? first_->at_m : entry->place().of(first_->at_m)};
      d.strong = true;
      drawings.push_back(std::move(d));
    }
  bench_.scene().set_drawings(pair_layer, std::move(drawings));
}

}  // namespace bole::desktop
