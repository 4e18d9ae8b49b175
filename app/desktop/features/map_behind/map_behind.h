// File > Map behind the survey: a picture of the place on the earth below the survey in the 3-D view and the plan map.
// It is read in the background, around the survey only, and kept with the document.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "features/map_behind/map_file.h"
#include "features/map_behind/map_ground.h"
#include "running/background_work.h"

namespace bole::desktop {

class Workbench;

class MapBehind : public QObject {
  Q_OBJECT

 public:
  explicit MapBehind(Workbench& bench);

  // Reads it and lays it below the survey; the picture before stays until then, and where it is refused. Where the
  // survey has no place on the earth yet it is kept and shown later, which is said. Throws Error{bad_input} without a
  // document.
  void open(const QString& path);
  void remove();

  const QString& path() const { return kept_.path; }   // of the picture of this document; empty: none
  const QString& problem() const { return problem_; }  // why it is not shown; empty: nothing is wrong
  bool reading() const { return work_.busy(); }

 Q_SIGNALS:
  void changed();  // laid, refused or taken away

 private:
  struct Wish {
    QString path;
    MapGround ground;
  };
  void make_commands();
  void ask_for_file();
  void load();
  void store();
  void follow_look();
  QString file() const;                     // beside the document
  void lay();                               // the picture of the document, below what is shown now
  std::optional<MapGround> ground() const;  // none: the survey has no place
  void read(const QString& path, const MapGround& ground);
  void drop_reading();
  void take();
  void refuse(const QString& why);
  void show(bool on);
  void show_none();
  void say_no_place();
  void tell(const Wish& wish, const ReadMap& read);

  Workbench& bench_;
  KeptMap kept_;
  QString unread_;  // a file that is not written over
  QString problem_;
  std::optional<Wish> tried_;    // last, of the picture of the document
  std::optional<Wish> current_;  // is being read, or is to be when what is read has been dropped
  bool dropped_ = false;         // what is being read is not wanted any more
  bool told_ = false;            // that the survey has no place
  std::shared_ptr<ReadMap> result_;
  BackgroundWork work_;  // last: its thread fills the result
};

}  // namespace bole::desktop
