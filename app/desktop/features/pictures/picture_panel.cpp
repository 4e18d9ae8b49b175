#include "features/pictures/picture_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "features/pictures/picture_images.h"

namespace bole::desktop {
namespace {

constexpr int gap_px = 8;  // of the picture, between two beside each other
const QColor point_color(214, 40, 160), kept_color(40, 200, 90, 150), refused_color(235, 60, 50, 110),
    left_color(255, 150, 0), right_color(0, 190, 255);

bool has_columns(const Table* table, std::initializer_list<const char*> names) {
  return table != nullptr && std::ranges::all_of(names, [&](const char* name) { return table->has(name); });
}

bool has_matches(const Table* t) {
  return has_columns(t, {"name_a", "name_b", "x_a_px", "y_a_px", "x_b_px", "y_b_px", "state"});
}

}  // namespace

PicturePanel::PicturePanel(QWidget* parent)
    : QWidget(parent),
      canvas_(new PictureCanvas(this)),
      kind_(new QComboBox(this)),
      partner_(new QComboBox(this)),
      points_(new QCheckBox(tr("Points"), this)),
      contours_(new QCheckBox(tr("Stem edges"), this)),
      readout_(new QLabel(this)) {
  setObjectName("picture_panel");
  kind_->setObjectName("picture_kind");
  kind_->addItems({tr("Colour"), tr("Depth"), tr("Depth − cloud")});
  kind_->setToolTip(tr("Depth − cloud: measured depth minus the depth of the cloud as this view sees it"));
  points_->setObjectName("picture_points");
  points_->setToolTip(tr("Points of the cloud that this view sees, at the pixels where they should be"));
  contours_->setObjectName("picture_contours");
  contours_->setToolTip(tr("Edges of the stem as they were measured in this picture"));
  contours_->setChecked(true);
  partner_->setObjectName("picture_partner");
  partner_->setToolTip(tr("Matches with another view: green were kept, red were refused"));
  auto* fit = new QToolButton(this);
  fit->setText(tr("Fit"));
  fit->setToolTip(tr("Show the whole picture (double click)"));
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(4, 2, 4, 2);
  for (QWidget* widget : {static_cast<QWidget*>(kind_), static_cast<QWidget*>(points_),
                          static_cast<QWidget*>(contours_), static_cast<QWidget*>(partner_)})
    bar->addWidget(widget);
  bar->addStretch(1);
  bar->addWidget(fit);
  readout_->setContentsMargins(6, 2, 6, 2);
  readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(bar);
  layout->addWidget(canvas_, 1);
  layout->addWidget(readout_);
  connect(kind_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PicturePanel::draw);
  connect(points_, &QCheckBox::toggled, this, &PicturePanel::draw);
  connect(contours_, &QCheckBox::toggled, this, &PicturePanel::draw);
  connect(partner_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PicturePanel::choose_partner);
  connect(fit, &QToolButton::clicked, canvas_, &PictureCanvas::fit);
  connect(canvas_, &PictureCanvas::hovered, this, &PicturePanel::tell);
  connect(canvas_, &PictureCanvas::left, this, &PicturePanel::tell_view);
  clear();
}

void PicturePanel::clear() {
  views_.reset();
  matches_.reset();
  contour_table_.reset();
  picture_.reset();
  partner_->hide();
  contours_->hide();
  points_->setEnabled(false);
  canvas_->set_marks({});
  canvas_->show_picture({});
  canvas_->set_message(tr("There are no views in this pipeline."));
  readout_->clear();
}

void PicturePanel::set_views(std::shared_ptr<const ViewSource> views) {
  views_ = std::move(views);
  picture_.reset();
}

void PicturePanel::set_tables(std::shared_ptr<const Table> matches, std::shared_ptr<const Table> contours) {
  matches_ = std::move(matches);
  contour_table_ = std::move(contours);
  contours_->setVisible(
      has_columns(contour_table_.get(), {"name", "left_x_px", "left_y_px", "right_x_px", "right_y_px"}));
}

// Pairs of this view come first, then those of others: a few pairs have their matches kept.
void PicturePanel::show_view(std::size_t index) {
  const auto wanted = next_partner_ ? std::exchange(next_partner_, {}) : partner();
  index_ = index;
  const QSignalBlocker quiet(partner_);
  partner_->clear();
  partner_->addItem(tr("No matches"), -1);
  partner_->setVisible(has_matches(matches_.get()));
  if (!views_ || !has_matches(matches_.get())) return;
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < views_->size(); ++i) places.emplace(views_->name(i), i);
  std::map<std::pair<std::size_t, std::size_t>, std::pair<int, int>> pairs;  // kept and refused
  const auto &a = matches_->texts("name_a"), &b = matches_->texts("name_b"), &state = matches_->texts("state");
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto at_a = places.find(a[i]), at_b = places.find(b[i]);
    if (at_a == places.end() || at_b == places.end()) continue;
    auto pair = std::minmax(at_a->second, at_b->second);
    auto& counts =
        pairs[pair.second == index ? std::pair(pair.second, pair.first) : std::pair(pair.first, pair.second)];
    ++(state[i] == "kept" ? counts.first : counts.second);
  }
  for (const bool own : {true, false})
    for (const auto& [pair, counts] : pairs) {
      if ((pair.first == index) != own) continue;
      partner_->addItem(
          tr("%1 and %2: %3 kept, %4 refused")
              .arg(QString::fromStdString(views_->name(pair.first)), QString::fromStdString(views_->name(pair.second)))
              .arg(counts.first)
              .arg(counts.second),
          static_cast<int>(pair.second));
      partner_->setItemData(partner_->count() - 1, static_cast<int>(pair.first), Qt::UserRole + 1);
    }
  partner_->setEnabled(partner_->count() > 1);
  for (int i = 1; wanted && i < partner_->count(); ++i)
    if (partner_->itemData(i, Qt::UserRole + 1).toInt() == static_cast<int>(index) &&
        partner_->itemData(i).toInt() == static_cast<int>(*wanted))
      partner_->setCurrentIndex(i);
}

void PicturePanel::choose_partner() {
  const auto view = partner_->currentData(Qt::UserRole + 1);
  if (!view.isValid() || view.toInt() == static_cast<int>(index_)) return Q_EMIT partner_changed();
  next_partner_ = partner();
  Q_EMIT view_wanted(view.toInt());
}

std::optional<std::size_t> PicturePanel::partner() const {
  const int view = partner_->currentIndex() < 0 ? -1 : partner_->currentData().toInt();
  if (view < 0) return {};
  return static_cast<std::size_t>(view);
}

void PicturePanel::show_picture(const std::shared_ptr<const Picture>& picture) {
  picture_ = picture;
  points_->setEnabled(picture_->placed);
  draw();
  tell_view();
}

void PicturePanel::show_failure(const QString& text) {
  picture_.reset();
  canvas_->set_marks({});
  canvas_->show_picture({});
  canvas_->set_message(text);
  readout_->clear();
}

PicturePanel::Kind PicturePanel::kind() const { return static_cast<Kind>(std::max(0, kind_->currentIndex())); }

QString PicturePanel::missing() const {
  if (kind() == Kind::color) return {};
  if (picture_->view.depth.empty()) return tr("This view has no depth image.");
  if (kind() == Kind::depth || !picture_->residual.empty()) return {};
  return picture_->placed ? tr("This view has no depth image.")
                          : tr("There is no cloud yet, or this view has no pose: run the pipeline.");
}

void PicturePanel::draw() {
  if (!picture_) return;
  const QString why = missing();
  if (!why.isEmpty()) {
    canvas_->set_marks({});
    canvas_->show_picture({});
    return canvas_->set_message(why);
  }
  const auto& view = picture_->view;
  const bool both = kind() == Kind::color && partner().has_value() && !picture_->other.empty();
  if (kind() == Kind::depth) {
    const auto bar = depth_bar(view.depth, tr("depth (m)"));
    canvas_->show_picture(picture_of(view.depth, bar, 1, true), bar);
  } else if (kind() == Kind::residual) {
    const auto bar = residual_bar(picture_->residual, tr("measured − cloud (mm)"));
    canvas_->show_picture(picture_of(picture_->residual, bar, 1000, false), bar);
  } else if (both) {
    canvas_->show_picture(beside(picture_of(view.color), picture_of(picture_->other), gap_px));
  } else {
    canvas_->show_picture(picture_of(view.color));
  }
  draw_marks(both, view.color.width + gap_px);
}

void PicturePanel::draw_marks(bool with_partner, int shift) {
  std::vector<PictureMarks> marks;
  if (points_->isChecked()) add_points(marks);
  if (contours_->isChecked() && kind() == Kind::color) add_contours(marks);
  if (with_partner) add_matches(marks, shift);
  canvas_->set_marks(std::move(marks));
}

void PicturePanel::add_points(std::vector<PictureMarks>& marks) const {
  const bool in_depth = kind() != Kind::color && picture_->camera.depth.has_value();
  PictureMarks layer{.color = point_color, .size_px = 1.5};
  for (const auto& p : in_depth ? picture_->in_depth : picture_->in_color.points)
    layer.dots.emplace_back(static_cast<double>(p.x), static_cast<double>(p.y));
  marks.push_back(std::move(layer));
}

void PicturePanel::add_contours(std::vector<PictureMarks>& marks) const {
  const auto* t = contour_table_.get();
  if (!views_ || contours_->isHidden() || t == nullptr) return;
  const auto& names = t->texts("name");
  const auto name = views_->name(picture_->index);
  for (const auto& [x_name, y_name, color] :
       {std::tuple{"left_x_px", "left_y_px", left_color}, {"right_x_px", "right_y_px", right_color}}) {
    PictureMarks layer{.color = color, .size_px = 3};
    const auto x = t->numbers(x_name), y = t->numbers(y_name);
    for (std::size_t i = 0; i < x.size(); ++i)
      if (names[i] == name) layer.dots.emplace_back(x[i], y[i]);
    marks.push_back(std::move(layer));
  }
}

void PicturePanel::add_matches(std::vector<PictureMarks>& marks, int shift) const {
  if (!views_ || !has_matches(matches_.get())) return;
  const auto& t = *matches_;
  const auto name = views_->name(picture_->index), other = views_->name(*partner());
  const auto &a = t.texts("name_a"), &b = t.texts("name_b"), &state = t.texts("state");
  const auto xa = t.numbers("x_a_px"), ya = t.numbers("y_a_px"), xb = t.numbers("x_b_px"), yb = t.numbers("y_b_px");
  PictureMarks kept{.color = kept_color, .size_px = 1.2}, refused{.color = refused_color, .size_px = 1};
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool forth = a[i] == name && b[i] == other, back = b[i] == name && a[i] == other;
    if (!forth && !back) continue;
    const QPointF here = forth ? QPointF(xa[i], ya[i]) : QPointF(xb[i], yb[i]),
                  there = forth ? QPointF(xb[i], yb[i]) : QPointF(xa[i], ya[i]);
    (state[i] == "kept" ? kept : refused).lines.emplace_back(here, there + QPointF(shift, 0));
  }
  marks.push_back(std::move(refused));
  marks.push_back(std::move(kept));
}

QString PicturePanel::readout() const { return readout_->text(); }

void PicturePanel::tell_view() {
  if (!picture_ || !views_) return readout_->clear();
  QString text = QString::fromStdString(views_->name(picture_->index)) + "   " +
                 tr("view %1 of %2").arg(picture_->index + 1).arg(views_->size());
  if (picture_->placed) text += "   " + tr("%1 points of the cloud seen").arg(picture_->in_color.points.size());
  readout_->setText(text);
}

void PicturePanel::tell(const QPointF& pixel) {
  if (!picture_) return;
  const int x = static_cast<int>(std::lround(pixel.x())), y = static_cast<int>(std::lround(pixel.y()));
  const auto& view = picture_->view;
  QString text = tr("pixel %1, %2").arg(pixel.x(), 0, 'f', 1).arg(pixel.y(), 0, 'f', 1);
  // Depth and colour have the same pixels only where depth is registered to colour.
  const bool registered = !picture_->camera.depth.has_value(), of_color = kind() == Kind::color;
  bool inside = false;
  if ((of_color || registered) && view.color.contains(x, y)) {
    inside = true;
    text += "   " +
            tr("colour %1, %2, %3").arg(view.color.at(x, y, 0)).arg(view.color.at(x, y, 1)).arg(view.color.at(x, y, 2));
  }
  if ((!of_color || registered) && view.depth.contains(x, y)) {
    inside = true;
    const float depth = view.depth.at(x, y);
    text += "   " + (depth > 0 ? tr("depth %1 m").arg(static_cast<double>(depth), 0, 'f', 4) : tr("no depth"));
    if (picture_->residual.contains(x, y) && std::isfinite(picture_->residual.at(x, y)))
      text +=
          "   " + tr("%1 mm from the cloud").arg(1000 * static_cast<double>(picture_->residual.at(x, y)), 0, 'f', 1);
  }
  if (!inside) return tell_view();
  readout_->setText(text);
}

}  // namespace bole::desktop
