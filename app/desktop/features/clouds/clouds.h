// Other clouds beside the survey that is open: last year's, one that was flown, the map of another preset. They are
// looked at in the 3-D view, the plan map and the cross-section, moved, measured by clicks, and never computed with.
#pragma once

#include <QObject>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "alignment/core/cloud_difference.h"
#include "features/clouds/cloud_entry.h"
#include "running/background_work.h"
#include "views/clouds/beside_cut.h"

namespace bole::desktop {

class CloudJobs;
class CloudPairs;
class CloudPanel;
class Workbench;

class Clouds : public QObject {
  Q_OBJECT

 public:
  explicit Clouds(Workbench& bench);

  const std::vector<CloudEntry>& list() const { return list_; }
  const CloudEntry* find(int id) const;  // null: there is none
  bool reading() const { return current_.has_value(); }
  QString reading_text() const;  // "Reading last_year.laz: 40 %"

  void add(const QString& path);  // in the background; it stands in the list when it was read
  void cancel_reading();
  void read_again(int id, const QString& path);  // a file that was not there, or could not be read

  // Steps of undo.
  void remove(int id);
  // Numbers that are typed one after another are one step; what has a name of its own is one by itself.
  void place(int id, const CloudPlacing& at, const QString& what = {});
  void move_here(int id);  // onto the survey

  // Looks, no steps of undo.
  void show(int id, bool on);
  void paint(int id, const render::Color& color, const std::string& color_by, double point_px);
  void fade(int id, double opacity, bool keep = true);  // not kept while a slider is held
  void zoom_to(int id);
  // Whether slice and profile show the clouds that are drawn; kept by the program.
  void show_in_cuts(bool on);
  bool in_cuts() const { return in_cuts_; }

  // Distances that were measured: columns of the cloud until it or what it was compared with moves.
  void take_difference(int id, int from, const alignment::DifferenceOptions& options,
                       alignment::CloudDifference difference);
  void color_up_to(int id, double metres);

  CloudPairs& pairs() { return *pairs_; }
  CloudJobs& jobs() { return *jobs_; }
  std::shared_ptr<const PointCloud> placed_points(int id);  // where it is shown; null: it was not read

  std::optional<double> distance_m(int id) const;  // from the survey; nothing where either is not known
  bool is_far(int id) const;
  bool is_drawn(int id) const;

 Q_SIGNALS:
  void changed();   // the list
  void progress();  // of reading

 private:
  friend class ListCloud;
  friend class PlaceCloud;
  struct Wish {
    int id = 0;  // 0: not in the list yet
    QString path;
  };
  struct Placed {
    std::shared_ptr<const ReadCloud> of;
    render::CloudPlace place;
    std::shared_ptr<const PointCloud> points;
    std::shared_ptr<const PointIndex> index;
  };

  void make_commands();
  void make_align_commands();
  void ask_for_files();
  void ask_where_to_save(int id);
  void read_next();
  void take(const std::shared_ptr<const ReadCloud>& read);
  void refuse(const QString& why);
  void tell_if_far(const CloudEntry& entry);
  CloudEntry* entry(int id);
  void insert(std::size_t where, CloudEntry entry);
  CloudEntry take_out(int id);
  void put_place(int id, const CloudPlacing& at);
  const Placed& placed(const CloudEntry& entry);  // of one that was read
  void drop_distances(CloudEntry& entry);
  void forget_distances(int from);     // of all clouds that were compared with it
  void drop_distances_from(int from);  // likewise, and draws
  void draw();
  void draw_cuts();
  void update();  // after a change of the list: draws it, keeps it, tells the panel
  void load();
  void store() const;
  QString file() const;

  Workbench& bench_;
  CloudPairs* pairs_ = nullptr;
  CloudJobs* jobs_ = nullptr;
  CloudPanel* panel_ = nullptr;
  std::shared_ptr<const ReadCloud> result_;  // written by the thread that reads, before it says that it is done
  BackgroundWork work_;
  std::vector<CloudEntry> list_;
  std::map<int, Placed> placed_;
  std::shared_ptr<const PointCloud> measured_from_;  // points of the survey that distances were measured from
  std::deque<Wish> wishes_;
  std::optional<Wish> current_;
  bool in_cuts_ = true;
  std::vector<CutCloud> cuts_;  // that slice and profile show
  bool dropped_ = false;        // what is being read belongs to a document that was closed
  double fraction_ = 0;
  int last_id_ = 0;
  QString unread_;  // a list that is there and could not be read: it is not written over
};

}  // namespace bole::desktop
