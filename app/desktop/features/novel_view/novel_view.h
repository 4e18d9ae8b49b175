// Shows the trained field from where the eye of the 3-D view is, in place of the points: coarse at once, finer while
// the eye rests. A move shows the points again until the next picture is there.
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>

#include "running/field_renderer.h"

namespace bole::desktop {

struct Survey;
class Workbench;

class NovelView : public QObject {
  Q_OBJECT

 public:
  explicit NovelView(Workbench& bench);

  void show(bool on);
  bool shown() const { return on_; }

 Q_SIGNALS:
  void pictured(int coarseness);  // a picture from the eye as it is now was put into the view

 private:
  void take_field(const std::shared_ptr<const Table>& field);
  void ask();

  Workbench& bench_;
  FieldRenderer* renderer_;
  std::shared_ptr<const Table> field_;
  std::uint64_t number_ = 0;  // of the last wish
  bool on_ = false;
};

}  // namespace bole::desktop
