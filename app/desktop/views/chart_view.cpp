#include "views/chart_view.h"

#include <QComboBox>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "views/figure_picture.h"

namespace bole::desktop {
namespace {

constexpr double mm_per_px = 25.4 / 96, reach_mm = 2.5;

}  // namespace

ChartView::ChartView(Selection& selection, QWidget* parent)
    : QWidget(parent), selection_(selection), kind_(new QComboBox(this)) {
  setMinimumSize(220, 180);
  kind_->addItems({tr("Diameters"), tr("Height over diameter"), tr("Estimated over field")});
  connect(kind_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { rebuild(); });
  connect(&selection_, &Selection::changed, this, &ChartView::rebuild);
}

void ChartView::show_survey(const Survey& survey) {
  survey_ = survey;
  rebuild();
}

void ChartView::show_kind(Kind kind) { kind_->setCurrentIndex(static_cast<int>(kind)); }

QRect ChartView::sheet() const { return rect().adjusted(0, kind_->sizeHint().height() + 4, 0, 0); }

void ChartView::rebuild() {
  chart_ = {};
  const render::ChartSize size{sheet().width() * mm_per_px, sheet().height() * mm_per_px};
  const auto selected = selection_.tree();
  if (survey_.stems && survey_.stems->has("tree_id")) {
    switch (static_cast<Kind>(kind_->currentIndex())) {
      case Kind::diameters:
        chart_ = render::diameter_histogram(*survey_.stems, size, selected);
        break;
      case Kind::heights:
        chart_ = render::height_over_diameter(*survey_.stems, size, selected);
        break;
      case Kind::field:
        chart_ = render::estimated_over_field(survey_.matches ? *survey_.matches : Table(), size, selected);
        break;
    }
  }
  update();
}

void ChartView::resizeEvent(QResizeEvent*) {
  kind_->setGeometry(4, 2, std::min(220, width() - 8), kind_->sizeHint().height());
  rebuild();
}

void ChartView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  if (!chart_.figure.draw) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(sheet(), Qt::AlignCenter | Qt::TextWordWrap, tr("Run the pipeline to see its stems."));
    return;
  }
  painter.drawImage(sheet().topLeft(), figure_picture(chart_.figure, palette(), 96, devicePixelRatioF()));
}

void ChartView::mousePressEvent(QMouseEvent* event) {
  const QPoint at = event->pos() - sheet().topLeft();
  if (const auto tree = chart_.tree_at(Eigen::Vector2d(at.x(), at.y()) * mm_per_px, reach_mm, selection_.tree()))
    selection_.select(tree);
}

QPointF ChartView::place_of(std::int64_t tree) const {
  for (const auto& mark : chart_.marks)
    if (std::ranges::find(mark.trees, tree) != mark.trees.end()) {
      const Eigen::Vector2d at = mark.box.centre() / mm_per_px;
      return QPointF(at.x(), at.y()) + sheet().topLeft();
    }
  return {};
}

}  // namespace bole::desktop
