// Work on clouds that takes a while, in the background: fine registration, distances, files. One at a time.
#pragma once

#include <QObject>
#include <map>
#include <memory>

#include "alignment/core/cloud_difference.h"
#include "alignment/core/fine_registration.h"
#include "features/clouds/cloud_entry.h"
#include "features/clouds/near_on_disk.h"
#include "running/background_work.h"

namespace bole::desktop {

class Clouds;
class Workbench;

class CloudJobs : public QObject {
  Q_OBJECT

 public:
  CloudJobs(Clouds& clouds, Workbench& bench);

  // `onto` and `from`: id of another cloud, 0: the survey. Both throw Error{bad_input} where a cloud is not there.
  void register_finely(int cloud, int onto, double reach_m);  // a step of undo where it converged
  void measure(int cloud, int from, const alignment::DifferenceOptions& options);
  // As it is shown, with its distances: in the axes of the survey where it was moved, so without its coordinate system
  // then. Throws Error{bad_input} for a cloud on disk, of which only coarse points are here.
  void save(int cloud, const QString& path);

  bool busy() const { return work_.busy(); }
  QString doing() const { return doing_; }
  double fraction() const { return fraction_; }
  void cancel() { work_.cancel(); }
  QString said_of_fine(int cloud) const;  // how its last fine registration ended

 Q_SIGNALS:
  void changed();

 private:
  // What the work was given; of another place or another cloud its result is dropped.
  struct Given {
    int cloud = 0, other = 0;
    std::shared_ptr<const PointCloud> points, of_other;
  };
  Given given(int cloud, int other) const;
  // The other cloud about the one that is given: as it is in memory, or from the disk.
  std::function<std::shared_ptr<const PointCloud>(const Run&)> other_about(double margin_m);
  void tell_spacing();  // where the other cloud was too large to be read in full
  bool still_holds() const;
  void start(const QString& doing, std::function<void(const Run&)> work, std::function<void()> take);
  void take_fine();
  QString words_of(const alignment::FineRegistration& fine) const;
  void end(const QString& text);

  Clouds& clouds_;
  Workbench& bench_;
  BackgroundWork work_;
  Given given_;
  QString doing_;
  double fraction_ = 0;
  std::function<void()> take_;
  // Written by the thread that works, before it says that it is done.
  std::shared_ptr<alignment::FineRegistration> fine_;
  std::shared_ptr<alignment::CloudDifference> difference_;
  alignment::DifferenceOptions difference_options_;
  std::map<int, QString> said_of_fine_;
  std::shared_ptr<NearOnDisk> from_disk_;  // what was read of the other cloud, without its points
};

}  // namespace bole::desktop
