#include "views/slice_view.h"

#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "base/angles.h"
#include "document/cell_words.h"
#include "document/stem_circle.h"
#include "look/pixels.h"
#include "look/text_lines.h"
#include "render/charts/columns.h"
#include "views/figure_picture.h"

namespace bole::desktop {
namespace {

constexpr double reasons_margin_mm = 3;
constexpr std::size_t max_reason_lines = 3;
constexpr double circle_grip_px = 8, same_height_m = 0.05;

// What a person decided; empty for what the program found.
QString decision(const std::string& state) {
  const bool decided = state == "accepted" || state == "rejected" || state == "edited";
  return decided ? cell_words("state", QString::fromStdString(state)) : QString();
}

}  // namespace

SliceView::SliceView(Selection& selection, QWidget* parent)
    : QWidget(parent), selection_(selection), height_(new QDoubleSpinBox(this)), thickness_(new QDoubleSpinBox(this)) {
  setMinimumSize(150, 130);
  setMouseTracking(true);
  height_->setRange(0, 60);
  height_->setSingleStep(0.1);
  height_->setValue(cut_.height_m);
  height_->setToolTip(tr("Height of the cut above ground"));
  thickness_->setRange(0.01, 2);
  thickness_->setSingleStep(0.02);
  thickness_->setValue(cut_.thickness_m);
  thickness_->setToolTip(tr("Thickness of the cut"));
  height_->setObjectName("cut_height");
  thickness_->setObjectName("cut_thickness");
  connect(height_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double v) {
    cut_.height_m = v;
    reload(true);
    Q_EMIT height_changed(v);
  });
  connect(thickness_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double v) {
    cut_.thickness_m = v;
    reload(true);
  });
  connect(&selection_, &Selection::beside, this, [this] { reload(false); });
}

void SliceView::show_survey(const Survey& survey) {
  survey_ = survey;
  known_.reset();
  reload(true);
}

void SliceView::show_clouds(std::vector<CutCloud> beside) {
  beside_ = std::move(beside);
  reload(true);
}

void SliceView::set_breast_height(double metres) {
  cut_.breast_height_m = metres;
  set_height(metres);
}

void SliceView::set_height(double metres) { height_->setValue(metres); }

void SliceView::set_adding(bool on) {
  if (on && !stem_) {
    Q_EMIT said(tr("Select a stem first: a new tree is drawn in the slice about it."));
    return adding_changed(false);
  }
  if (adding_ == on) return;
  adding_ = on;
  if (on && data_.reach_m < 1) data_.reach_m = 1.5;  // a new tree stands beside the selected one
  if (stem_) reload(true);
  if (on) Q_EMIT said(tr("Draw a circle about the points of the new tree. The circle that fits them is taken."));
  setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
  Q_EMIT adding_changed(on);
}

void SliceView::reload(bool keep_view) {
  const std::int64_t before = stem_ ? stem_->tree_id : 0;
  stem_ = selection_.tree() ? stem_place(survey_, *selection_.tree()) : std::nullopt;
  fit_.reset();
  grip_ = Grip::none;
  if (!stem_) {
    data_ = {};
    set_adding(false);
    return update();
  }
  if (before != stem_->tree_id) known_.reset();
  if (!keep_view || before != stem_->tree_id) {
    middle_ = stem_->foot.head<2>();
    data_.reach_m = std::max(0.12, 0.75 * (std::isfinite(stem_->dbh_m) ? stem_->dbh_m : 0.2) + 0.04);
  }
  data_ = cut_across(survey_, *stem_, cut_, middle_, data_.reach_m);
  data_.beside = dots_across(beside_, *stem_, cut_, middle_, data_.reach_m);
  fit_here();
  write_lines();
  update();
}

bool SliceView::away_from_breast_height() const {
  return std::abs(cut_.height_m - cut_.breast_height_m) >= same_height_m;
}

// Away from breast height the stem has a circle of its own, with its interval.
void SliceView::fit_here() {
  here_.reset();
  if (!data_.stem || !away_from_breast_height()) return;
  if (!known_) known_ = known_of(survey_, *stem_, cut_.breast_height_m);
  here_ = diameter_in(survey_, *stem_, cut_, *known_);
  if (here_)
    data_.stem = render::SliceCircle{stem_->tree_id, here_->circle.centre - middle_, here_->circle.radius,
                                     here_->radius_low, here_->radius_high};
}

// The diameter at the height of the cut with its interval and the part of the circle that is seen there.
void SliceView::write_measured() {
  const auto one = survey_.stems->subset({stem_->row});
  const auto number = [&](const char* name) { return render::numbers_or_nan(one, name)[0]; };
  const auto in_cm = [](double v) { return QString::fromStdString(render::fixed(v, 1)); };
  const auto interval = [&](double lo_cm, double hi_cm) {
    return std::isfinite(lo_cm + hi_cm) ? "   " + tr("95 %: %1 to %2").arg(in_cm(lo_cm), in_cm(hi_cm)) : QString();
  };
  const auto arc = [](double deg) {
    return std::isfinite(deg) ? "   " + tr("arc %1°").arg(QString::fromStdString(render::fixed(deg, 0))) : QString();
  };
  const auto add = [this](const QString& line) { data_.lines.push_back(line.toStdString()); };
  const QString dbh = tr("DBH %1 cm").arg(in_cm(number("dbh_cm")));
  if (!away_from_breast_height())
    return add(dbh + interval(number("dbh_lo_cm"), number("dbh_hi_cm")) + arc(number("arc_deg")));
  if (here_)
    add(tr("here %1 cm").arg(in_cm(200 * here_->circle.radius)) +
        interval(200 * here_->radius_low, 200 * here_->radius_high) + arc(degrees(here_->arc_rad)));
  else
    add(tr("no circle fits the points here"));
  add(here_ ? dbh + "   " + tr("spread here %1 cm").arg(in_cm(100 * here_->sigma)) : dbh);
}

void SliceView::write_lines() {
  const auto& stems = *survey_.stems;
  const auto row = stem_->row;
  const auto text = [](const QString& s) { return s.toStdString(); };
  const auto digits = [](double v, int decimals) { return QString::fromStdString(render::fixed(v, decimals)); };
  QString tree =
      tr("Tree %1   %2").arg(stem_->tree_id).arg(cell_words("quality", QString::fromStdString(data_.quality)));
  if (const auto decided = decision(render::texts_or_empty(stems, "state")[row]); !decided.isEmpty())
    tree += "   " + decided;
  if (adding_) tree = tr("New tree: draw a circle about its points");
  data_.lines = {text(tree)};
  const QString reasons = cell_words("reasons", QString::fromStdString(render::texts_or_empty(stems, "reasons")[row]));
  setToolTip(reasons);
  if (!adding_) write_measured();
  if (fit_)
    data_.lines.push_back(text(tr("fit %1 cm   spread %2 cm   arc %3°")
                                   .arg(digits(200 * fit_->circle.radius, 1), digits(100 * fit_->sigma, 1),
                                        digits(degrees(fit_->arc_rad), 0))));
  else if (data_.drawn)
    data_.lines.push_back(text(tr("drawn %1 cm, no fit here").arg(digits(200 * data_.drawn->radius_m, 1))));
  else if (!adding_ && !away_from_breast_height())
    for (auto& line : text_lines(reasons, sheet().width() * mm_per_px - reasons_margin_mm, max_reason_lines))
      data_.lines.push_back(std::move(line));
}

QRect SliceView::sheet() const { return rect().adjusted(0, thickness_->geometry().bottom() + 3, 0, 0); }

render::SliceScale SliceView::scale() const {
  return render::slice_scale(sheet().width() * mm_per_px, sheet().height() * mm_per_px, data_.lines.size(),
                             data_.reach_m);
}

Eigen::Vector2d SliceView::to_metres(const QPoint& at) const {
  const QPoint p = at - sheet().topLeft();
  return scale().to_metres(Eigen::Vector2d(p.x(), p.y()) * mm_per_px);
}

QPointF SliceView::place_of(const Eigen::Vector2d& plan) const {
  const Eigen::Vector2d px = scale().to_sheet(plan - middle_) / mm_per_px;
  return QPointF(px.x(), px.y()) + sheet().topLeft();
}

SliceView::Grip SliceView::grip_at(const QPoint& at) const {
  if (!stem_) return Grip::none;
  if (adding_) return Grip::add;
  const double reach = circle_grip_px * mm_per_px / scale().mm_per_metre,
               off = (to_metres(at) - data_.stem->centre).norm();
  if (off <= std::min(reach, 0.5 * data_.stem->radius_m)) return Grip::centre;
  if (std::abs(off - data_.stem->radius_m) <= reach) return Grip::rim;
  return Grip::none;
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !stem_) return;
  const Grip grip = grip_at(event->pos());
  pressed_ = to_metres(event->pos());
  if (grip == Grip::none) {
    for (const auto& n : data_.neighbours)
      if ((pressed_ - n.centre).norm() <= n.radius_m) return selection_.select(n.tree_id);
    return;
  }
  if (std::abs(cut_.height_m - cut_.breast_height_m) > same_height_m) {
    Q_EMIT said(tr("Diameters are those at breast height: set the height of the cut to %1 m to edit one.")
                    .arg(cut_.breast_height_m, 0, 'f', 2));
    return;
  }
  grip_ = grip;
}

// The points ask for a circle near the one that is drawn.
void SliceView::drag_to(const Eigen::Vector2d& metres) {
  render::SliceCircle drawn = *data_.stem;
  drawn.lo_m = drawn.hi_m = 0;
  if (grip_ == Grip::centre) drawn.centre += metres - pressed_;
  if (grip_ == Grip::rim) drawn.radius_m = (metres - drawn.centre).norm();
  if (grip_ == Grip::add) {
    drawn.centre = pressed_;
    drawn.radius_m = (metres - pressed_).norm();
    drawn.tree_id = 0;
  }
  drawn.radius_m = std::clamp(drawn.radius_m, min_drawn_radius_m, max_drawn_radius_m);
  data_.drawn = drawn;
  fit_ = circle_near(data_.points, drawn);
  data_.refit.reset();
  if (fit_) data_.refit = render::SliceCircle{drawn.tree_id, fit_->circle.centre, fit_->circle.radius, 0, 0};
  write_lines();
  update();
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (grip_ != Grip::none) return drag_to(to_metres(event->pos()));
  const Grip grip = grip_at(event->pos());
  setCursor(grip == Grip::add      ? Qt::CrossCursor
            : grip == Grip::centre ? Qt::SizeAllCursor
            : grip == Grip::rim    ? Qt::SizeHorCursor
                                   : Qt::ArrowCursor);
}

std::vector<stems::StemEdit> SliceView::edits_of(const render::SliceCircle& circle) const {
  const Eigen::Vector2d centre = circle.centre + middle_;
  if (grip_ == Grip::add) {
    stems::StemEdit edit;
    edit.action = stems::StemEdit::Action::add;
    edit.at = centre;
    edit.dbh_cm = 200 * circle.radius_m;
    return {edit};
  }
  return circle_edits(*stem_, centre, circle.radius_m);
}

// The fit is taken; with Shift the circle as it was drawn.
void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  if (grip_ == Grip::none || event->button() != Qt::LeftButton) return;
  const bool as_drawn = event->modifiers().testFlag(Qt::ShiftModifier) || !data_.refit;
  std::vector<stems::StemEdit> edits;
  if (data_.drawn) edits = edits_of(as_drawn ? *data_.drawn : *data_.refit);
  data_.drawn.reset();
  data_.refit.reset();
  fit_.reset();
  grip_ = Grip::none;
  if (adding_) set_adding(false);
  write_lines();
  update();
  if (!edits.empty()) Q_EMIT edits_requested(edits);
}

void SliceView::wheelEvent(QWheelEvent* event) {
  if (!stem_) return;
  data_.reach_m = std::clamp(data_.reach_m * std::pow(1.15, -event->angleDelta().y() / 120.0), 0.08, 4.0);
  reload(true);
  event->accept();
}

// A number that is cut would be another one: the words give way, which the tips have too, then the box below does.
void SliceView::place_boxes() {
  constexpr int edge_px = 4, top_px = 2, usual_px = 130;
  const int half = (width() - 3 * edge_px) / 2, h = height_->sizeHint().height();
  const auto widest = [&](const QString& of_height, const QString& of_thickness) {
    height_->setSuffix(of_height);
    thickness_->setSuffix(of_thickness);
    return std::max(height_->sizeHint().width(), thickness_->sizeHint().width());
  };
  int needed = widest(tr(" m high"), tr(" m thick"));
  if (needed > half) needed = widest(tr(" m"), tr(" m"));
  const bool below = needed > half;
  if (below) widest(tr(" m high"), tr(" m thick"));
  const int w = below ? width() - 2 * edge_px : std::min(half, std::max(usual_px, needed));
  height_->setGeometry(edge_px, top_px, w, h);
  thickness_->setGeometry(below ? edge_px : 2 * edge_px + w, below ? 2 * top_px + h : top_px, w, h);
}

void SliceView::resizeEvent(QResizeEvent*) {
  place_boxes();
  if (stem_) write_lines();
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  if (!stem_) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(sheet(), Qt::AlignCenter | Qt::TextWordWrap, tr("Select a stem to see its slice."));
    return;
  }
  const auto figure = render::stem_slice(data_, sheet().width() * mm_per_px, sheet().height() * mm_per_px);
  painter.drawImage(sheet().topLeft(), figure_picture(figure, palette(), 96, devicePixelRatioF()));
}

}  // namespace bole::desktop
