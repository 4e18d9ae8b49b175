// Small parts that the pages of the panel of clouds share.
#pragma once

#include <QColor>
#include <QDoubleSpinBox>
#include <QIcon>
#include <utility>
#include <vector>

#include "render/draw/color.h"

class QAction;
class QToolButton;

namespace bole::desktop {

class Commands;

QColor qt_color(const render::Color& color);
QIcon swatch(const QColor& color);

struct CloudNumber {
  double min = 0, max = 0, step = 0;
  int decimals = 0;
  QString unit{};
};
QDoubleSpinBox* cloud_number(const char* id, const QString& tip, const CloudNumber& number);

// What a box shows of a value is rounded: the digits that it lacks are kept.
double typed(const QDoubleSpinBox& box, double before);

// A tool button takes the short text of its action.
void put_action(QToolButton& button, QAction& action, const QString& short_text);

// A row of them, by the names of their commands.
QWidget* button_row(Commands& commands, const std::vector<std::pair<const char*, QString>>& buttons);

inline const auto number_changed = QOverload<double>::of(&QDoubleSpinBox::valueChanged);

}  // namespace bole::desktop
