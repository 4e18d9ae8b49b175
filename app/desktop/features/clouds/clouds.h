// Other clouds beside the survey that is open: last year's, one that was flown, the map of another preset. They are
// looked at in the 3-D view, the plan map and the cross-section, moved, measured by clicks, and never computed with.
#pragma once

#include <QObject>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "features/clouds/cloud_entry.h"
#include "running/background_work.h"

namespace bole::desktop {

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
  void place(int id, const Eigen::Vector3d& shift_m, double turn_deg);
  void move_here(int id);  // onto the survey

  // Looks, no steps of undo.
  void show(int id, bool on);
  void paint(int id, const render::Color& color, const std::string& color_by, double point_px);
  void zoom_to(int id);

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
    double turn_deg = 0;
    std::shared_ptr<const PointCloud> points;
    std::shared_ptr<const PointIndex> index;
  };

  void make_commands();
  void ask_for_files();
  void read_next();
  void take(const std::shared_ptr<const ReadCloud>& read);
  void refuse(const QString& why);
  void tell_if_far(const CloudEntry& entry);
  CloudEntry* entry(int id);
  void insert(std::size_t where, CloudEntry entry);
  CloudEntry take_out(int id);
  void put_place(int id, const Eigen::Vector3d& shift_m, double turn_deg);
  void draw();
  void update();  // after a change of the list: draws it, keeps it, tells the panel
  void load();
  void store() const;
  QString file() const;

  Workbench& bench_;
  CloudPanel* panel_ = nullptr;
  std::shared_ptr<const ReadCloud> result_;  // written by the thread that reads, before it says that it is done
  BackgroundWork work_;
  std::vector<CloudEntry> list_;
  std::map<int, Placed> placed_;
  std::deque<Wish> wishes_;
  std::optional<Wish> current_;
  bool dropped_ = false;  // what is being read belongs to a document that was closed
  double fraction_ = 0;
  int last_id_ = 0;
  QString unread_;  // a list that is there and could not be read: it is not written over
};

}  // namespace bole::desktop
