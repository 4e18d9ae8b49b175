#include "views/slice_view.h"

#include <QPainter>
#include <algorithm>

#include "render/charts/slice_sheet.h"

namespace bole::desktop {
namespace {

constexpr double panel_mm = 60;  // width of the sheet that is drawn; the widget scales it by its resolution

}  // namespace

SliceView::SliceView(QWidget* parent) : QWidget(parent) { setMinimumSize(160, 190); }

void SliceView::show_survey(std::shared_ptr<const Table> stems, std::shared_ptr<const PointCloud> slice) {
  stems_ = std::move(stems), slice_ = std::move(slice);
  update();
}

void SliceView::show_tree(std::int64_t id) {
  tree_ = id;
  update();
}

QImage SliceView::drawn() const {
  if (!stems_ || !slice_ || !stems_->has("tree_id")) return {};
  const auto ids = stems_->integers("tree_id");
  const auto it = std::ranges::find(ids, tree_);
  if (it == ids.end()) return {};
  SliceSheetOptions options;
  options.columns = options.rows_per_page = 1;
  const auto sheets =
      slice_sheets(stems_->subset({static_cast<std::size_t>(it - ids.begin())}), *slice_, panel_mm, options);
  if (sheets.empty()) return {};
  const auto& sheet = sheets.front();
  const double scale = std::min(width() / sheet.width_mm, height() / sheet.height_mm) * devicePixelRatioF();
  const auto image = figure_image(sheet, 25.4 * scale);
  return QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::white);
  auto image = drawn();
  if (image.isNull()) {
    painter.setPen(Qt::darkGray);
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("Select a stem to see its slice."));
    return;
  }
  image.setDevicePixelRatio(devicePixelRatioF());
  const QSizeF size = QSizeF(image.size()) / devicePixelRatioF();
  painter.drawImage(QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), image);
}

}  // namespace bole::desktop
