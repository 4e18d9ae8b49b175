#include "features/clouds/cloud_widgets.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>
#include <cmath>

#include "commands/commands.h"

namespace bole::desktop {

QColor qt_color(const render::Color& color) { return QColor::fromRgbF(color.r, color.g, color.b); }

QIcon swatch(const QColor& color) {
  constexpr int swatch_px = 14;
  QPixmap pixmap(swatch_px, swatch_px);
  pixmap.fill(color);
  QPainter painter(&pixmap);
  painter.setPen(color.darker(140));
  painter.drawRect(0, 0, swatch_px - 1, swatch_px - 1);
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // not tinted
  return icon;
}

QDoubleSpinBox* cloud_number(const char* id, const QString& tip, const CloudNumber& number) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(id);
  box->setToolTip(tip);
  box->setDecimals(number.decimals);
  box->setRange(number.min, number.max);
  box->setSingleStep(number.step);
  box->setSuffix(number.unit);
  box->setKeyboardTracking(false);
  box->setMinimumWidth(box->fontMetrics().horizontalAdvance("-500000.000 m"));
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return box;
}

double typed(const QDoubleSpinBox& box, double before) {
  return std::abs(box.value() - before) < 0.6 * std::pow(10, -box.decimals()) ? before : box.value();
}

void put_action(QToolButton& button, QAction& action, const QString& short_text) {
  action.setIconText(short_text);
  button.setDefaultAction(&action);
  button.setFocusPolicy(Qt::StrongFocus);
}

QWidget* button_row(Commands& commands, const std::vector<std::pair<const char*, QString>>& buttons) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  for (const auto& [id, text] : buttons) {
    auto* button = new QToolButton;
    put_action(*button, *commands.action(id), text);
    layout->addWidget(button);
  }
  layout->addStretch();
  return row;
}

}  // namespace bole::desktop
