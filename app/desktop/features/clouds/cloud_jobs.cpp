#include "features/clouds/cloud_jobs.h"

#include <QFileInfo>
#include <QLocale>

#include "base/angles.h"
#include "document/disk_memory.h"
#include "features/clouds/cloud_align.h"
#include "features/clouds/clouds.h"
#include "io/core/clouds/cloud_writer.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

QString count_text(std::size_t count) { return QLocale().toString(static_cast<qulonglong>(count)); }

constexpr std::size_t bytes_per_point = 64;  // of a cloud that is compared, with its search tree

QString mm_text(double metres) { return CloudJobs::tr("%1 mm").arg(1000 * metres, 0, 'f', 1); }

}  // namespace

CloudJobs::CloudJobs(Clouds& clouds, Workbench& bench) : QObject(&clouds), clouds_(clouds), bench_(bench) {
  connect(&work_, &BackgroundWork::progressed, this, [this](double fraction) {
    if (fraction < fraction_ + 0.01) return;
    fraction_ = fraction;
    Q_EMIT changed();
  });
  connect(&work_, &BackgroundWork::done, this, [this] {
    if (still_holds())
      std::exchange(take_, nullptr)();
    else
      bench_.say(tr("A cloud was moved, removed or read again meanwhile: the result was dropped."));
    end({});
  });
  connect(&work_, &BackgroundWork::cancelled, this, [this] { end(tr("Cancelled: nothing was changed.")); });
  connect(&work_, &BackgroundWork::failed, this, [this](const QString& why) {
    bench_.complain(why);
    end({});
  });
  connect(&bench_, &Workbench::document_opened, this, [this] {
    work_.cancel();
    said_of_fine_.clear();
  });
}

void CloudJobs::end(const QString& text) {
  if (!text.isEmpty()) bench_.say(text);
  doing_.clear();
  take_ = nullptr;
  fine_.reset();
  difference_.reset();
  given_ = {};
  Q_EMIT changed();
  bench_.commands().update();
}

CloudJobs::Given CloudJobs::given(int cloud, int other) const {
  Given given{cloud, other, clouds_.placed_points(cloud),
              other == 0 ? bench_.scene().survey().points : clouds_.placed_points(other)};
  if (!given.points || !given.of_other || cloud == other)
    throw bad_input("a cloud is not there", "two that were read", "Wait until they are read, or run the survey");
  if (const auto* entry = clouds_.find(cloud); entry->read->on_disk())
    bench_.say(tr("%1 is shown from the disk: its coarse points are used.").arg(entry->name()));
  return given;
}

std::function<std::shared_ptr<const PointCloud>(const Run&)> CloudJobs::other_about(double margin_m) {
  from_disk_ = std::make_shared<NearOnDisk>();
  const auto* entry = clouds_.find(given_.other);
  const auto& index = given_.other == 0 ? bench_.scene().survey().index : entry->read->index;
  if (!index || !index->disk()) return [points = given_.of_other](const Run&) { return points; };
  const auto place = given_.other == 0 ? render::CloudPlace() : entry->place();
  return [disk = index->disk(), place, about = given_.points, margin_m, most = disk_memory_bytes() / bytes_per_point,
          told = from_disk_](const Run& run) {
    *told = near_on_disk(*disk, place, *about, margin_m, most, run);
    return std::exchange(told->points, nullptr);
  };
}

bool CloudJobs::still_holds() const {
  if (!given_.of_other) return take_ != nullptr;  // what is written is not changed by what comes later
  const auto now = clouds_.placed_points(given_.cloud);
  const auto other = given_.other == 0 ? bench_.scene().survey().points : clouds_.placed_points(given_.other);
  return take_ && now == given_.points && other == given_.of_other;
}

void CloudJobs::start(const QString& doing, std::function<void(const Run&)> work, std::function<void()> take) {
  doing_ = doing;
  fraction_ = 0;
  take_ = std::move(take);
  work_.start(std::move(work));
  Q_EMIT changed();
  bench_.commands().update();
}

void CloudJobs::register_finely(int cloud, int onto, double reach_m) {
  if (busy()) throw bad_input("another cloud is being worked on", "one at a time", "Wait for it, or cancel it");
  given_ = given(cloud, onto);
  fine_ = std::make_shared<alignment::FineRegistration>();
  start(
      tr("Fitting %1").arg(clouds_.find(cloud)->name()),
      [points = given_.points, other = other_about(reach_m), reach_m, result = fine_](const Run& run) {
        *result = alignment::register_finely(*points, *other(run), {.reach_m = reach_m}, run);
      },
      [this] { take_fine(); });
}

void CloudJobs::tell_spacing() {
  if (!from_disk_ || from_disk_->spacing_m == 0) return;
  const QString name = given_.other == 0 ? tr("the survey") : clouds_.find(given_.other)->name();
  if (from_disk_->all_within_m == 0)
    return bench_.say(
        tr("%1 has too many points for View > Memory for points on disk: those about %2 m apart were used.")
            .arg(name)
            .arg(from_disk_->spacing_m, 0, 'g', 2));
  bench_.say(tr("%1 has too many points for View > Memory for points on disk: within %2 m all were used, farther away "
                "those about %3 m apart.")
                 .arg(name)
                 .arg(from_disk_->all_within_m, 0, 'g', 2)
                 .arg(from_disk_->spacing_m, 0, 'g', 2));
}

void CloudJobs::take_fine() {
  tell_spacing();
  const auto* cloud = clouds_.find(given_.cloud);
  const int id = cloud->id;
  const QString name = cloud->name(), words = words_of(*fine_);
  if (fine_->converged())
    clouds_.place(id, placed_after(*cloud, fine_->motion), tr("fine registration of %1").arg(name));
  said_of_fine_[id] = words;
  bench_.say(name + ": " + words);
}

QString CloudJobs::words_of(const alignment::FineRegistration& fine) const {
  using alignment::FineEnd;
  const QString numbers = tr("RMS %1, overlap %2 % within %3 m, %4 of %5 points compared")
                              .arg(mm_text(fine.rms_m))
                              .arg(100 * fine.overlap, 0, 'f', 0)
                              .arg(fine.final_reach_m, 0, 'f', 2)
                              .arg(count_text(fine.pairs), count_text(fine.points));
  const QString stayed = tr("The cloud was left where it was.");
  switch (fine.end) {
    case FineEnd::converged:
      return tr("Fitted: %1. Before: RMS %2, overlap %3 %. Moved by %4 m and %5°.")
          .arg(numbers, mm_text(fine.start_rms_m))
          .arg(100 * fine.start_overlap, 0, 'f', 0)
          .arg((fine.motion.to - fine.motion.from).norm(), 0, 'f', 3)
          .arg(degrees(Eigen::AngleAxisd(fine.motion.turn).angle()), 0, 'f', 3);
    case FineEnd::apart:
      return tr("Too few points have a partner near them. Move the cloud nearer by pairs of points, or look farther.") +
             " " + stayed;
    case FineEnd::restless:
      return tr("It did not come to rest (%1).").arg(numbers) + " " + stayed;
    case FineEnd::no_better:
      return tr("Nothing fits better than where it is: RMS %1, overlap %2 %.")
                 .arg(mm_text(fine.start_rms_m))
                 .arg(100 * fine.start_overlap, 0, 'f', 0) +
             " " + stayed;
    case FineEnd::open:
      break;
  }
  const auto& shift = fine.open_shift;
  const QString open = shift.norm() > fine.open_turn.norm()
                           ? tr("The points do not hold the cloud: it could slide along (%1, %2, %3).")
                           : tr("The points do not hold the cloud: it could turn about (%1, %2, %3).");
  const Eigen::Vector3d axis = (shift.norm() > fine.open_turn.norm() ? shift : fine.open_turn).normalized();
  return open.arg(axis.x(), 0, 'f', 2).arg(axis.y(), 0, 'f', 2).arg(axis.z(), 0, 'f', 2) + " " + stayed;
}

QString CloudJobs::said_of_fine(int cloud) const {
  const auto it = said_of_fine_.find(cloud);
  return it == said_of_fine_.end() ? QString() : it->second;
}

void CloudJobs::measure(int cloud, int from, const alignment::DifferenceOptions& options) {
  if (busy()) throw bad_input("another cloud is being worked on", "one at a time", "Wait for it, or cancel it");
  given_ = given(cloud, from);
  difference_ = std::make_shared<alignment::CloudDifference>();
  difference_options_ = options;
  start(
      tr("Measuring distances of %1").arg(clouds_.find(cloud)->name()),
      [points = given_.points, other = other_about(options.max_m), options, result = difference_](const Run& run) {
        *result = alignment::difference_of(*points, *other(run), options, run);
      },
      [this] {
        tell_spacing();
        clouds_.take_difference(given_.cloud, given_.other, difference_options_, std::move(*difference_));
      });
}

void CloudJobs::save(int cloud, const QString& path) {
  if (busy()) throw bad_input("another cloud is being worked on", "one at a time", "Wait for it, or cancel it");
  const auto* entry = clouds_.find(cloud);
  if (entry == nullptr || !entry->read) throw bad_input("the cloud was not read", "one that was read");
  if (entry->read->on_disk())
    throw bad_input("the cloud is shown from the disk: only its coarse points are in memory", "one in memory",
                    "Raise View > Memory for points on disk and open it again");
  auto points = *clouds_.placed_points(cloud);
  if (!entry->place().moves_nothing()) {
    points.crs_wkt.clear();
    points.axes = Axes::unknown;
  }
  given_ = {cloud, 0, nullptr, nullptr};
  start(
      tr("Writing %1").arg(QFileInfo(path).fileName()),
      [points = std::move(points), to = path.toStdString()](const Run& run) { io::write_cloud(to, points, run); },
      [this, path] { bench_.say(tr("The cloud was written to %1").arg(path)); });
}

}  // namespace bole::desktop
