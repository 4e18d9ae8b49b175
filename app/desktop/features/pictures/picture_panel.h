// The picture of one view: colour, depth, residual of depth, with points of the cloud, contours and matches over it.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "cloud/table.h"
#include "features/pictures/picture_canvas.h"
#include "running/picture_reader.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace bole::desktop {

class PicturePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PicturePanel(QWidget* parent);

  void clear();
  void set_views(std::shared_ptr<const ViewSource> views);
  // Of the last run; may be null. Views are known by their names in them.
  void set_tables(std::shared_ptr<const Table> matches, std::shared_ptr<const Table> contours);
  void show_view(std::size_t index);  // what matches there are with others; its picture follows
  void show_picture(const std::shared_ptr<const Picture>& picture);
  void show_failure(const QString& text);

  std::optional<std::size_t> partner() const;  // the view that matches are shown with
  PictureCanvas& canvas() { return *canvas_; }
  QString readout() const;

 Q_SIGNALS:
  void partner_changed();
  void view_wanted(int index);  // one that has matches was chosen

 private:
  enum class Kind { color, depth, residual };
  Kind kind() const;
  void draw();
  void draw_marks(bool with_partner, int shift);
  void choose_partner();
  void add_points(std::vector<PictureMarks>& marks) const;
  void add_contours(std::vector<PictureMarks>& marks) const;
  void add_matches(std::vector<PictureMarks>& marks, int shift) const;
  QString missing() const;  // why there is no such picture; empty: there is
  void tell(const QPointF& pixel);
  void tell_view();

  PictureCanvas* canvas_;
  QComboBox *kind_, *partner_;
  QCheckBox *points_, *contours_;
  QLabel* readout_;
  std::shared_ptr<const ViewSource> views_;
  std::shared_ptr<const Table> matches_, contour_table_;
  std::shared_ptr<const Picture> picture_;
  std::size_t index_ = 0;
  std::optional<std::size_t> next_partner_;  // of the view that was wanted
};

}  // namespace bole::desktop
