#include "views/chart_view.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "document/rows/row_cut.h"
#include "look/pixels.h"
#include "views/figure_picture.h"

namespace bole::desktop {
namespace {

constexpr double reach_mm = 2.5;

QString to_qt(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<int>(text.size())); }

// With the other words of charts, in the context "figures" of app/desktop/i18n.
QString chart_title(const render::ChartType& chart) {
  return QCoreApplication::translate("figures", to_qt(chart.title).toUtf8().constData());
}

}  // namespace

ChartView::ChartView(Selection& selection, QWidget* parent)
    : QWidget(parent), selection_(selection), charts_(new QComboBox(this)) {
  setMinimumSize(180, 110);
  for (const auto& chart : render::linked_charts()) charts_->addItem(chart_title(chart), to_qt(chart.id));
  connect(charts_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { rebuild(); });
  connect(&selection_, &Selection::beside, this, &ChartView::rebuild);
  connect(&selection_, &Selection::row_changed, this, [this] {
    if (selection_.row()) show_chart("plant_distances");
    rebuild();
  });
}

void ChartView::show_survey(const Survey& survey) {
  survey_ = survey;
  rebuild();
}

void ChartView::show_chart(const QString& id) { charts_->setCurrentIndex(charts_->findData(id)); }

QRect ChartView::sheet() const { return rect().adjusted(0, charts_->sizeHint().height() + 4, 0, 0); }

void ChartView::rebuild() {
  chart_ = {};
  const render::ChartSize size{sheet().width() * mm_per_px, sheet().height() * mm_per_px};
  const auto selected = selection_.tree();
  const auto charts = render::linked_charts();
  const bool stems = survey_.stems && survey_.stems->has("tree_id");
  std::vector<render::RowPlant> row;
  if (selection_.row()) row = row_plants(survey_, *selection_.row());
  if (stems || survey_.rows)
    chart_ = charts[static_cast<std::size_t>(charts_->currentIndex())].draw(
        {stems ? survey_.stems.get() : nullptr, survey_.matches.get(), row}, size, selected);
  update();
}

void ChartView::resizeEvent(QResizeEvent*) {
  charts_->setGeometry(4, 2, std::min(220, width() - 8), charts_->sizeHint().height());
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
