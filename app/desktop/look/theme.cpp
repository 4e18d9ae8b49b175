#include "look/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QSettings>
#include <QStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <algorithm>

namespace bole::desktop {
namespace {

QPalette dark_palette() {
  QPalette palette(QColor(45, 45, 48), QColor(45, 45, 48));
  const QColor text(224, 224, 224), quiet(130, 130, 130), base(30, 30, 32);
  for (const auto role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText, QPalette::BrightText}) {
    palette.setColor(role, text);
    palette.setColor(QPalette::Disabled, role, quiet);
  }
  palette.setColor(QPalette::PlaceholderText, quiet);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, QColor(38, 38, 41));
  palette.setColor(QPalette::ToolTipBase, QColor(60, 60, 64));
  palette.setColor(QPalette::Highlight, QColor(38, 110, 190));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(80, 80, 80));
  palette.setColor(QPalette::Link, QColor(90, 170, 250));
  return palette;
}

// Fusion outlines boxes to tick by a darker shade of the window, which nobody sees on a dark one.
class DarkStyle : public QProxyStyle {
 public:
  DarkStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool box = element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck,
               round = element == PE_IndicatorRadioButton;
    if (!box && !round) return;
    const bool off = !option->state.testFlag(State_Enabled);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing, round);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(option->palette.color(off ? QPalette::Disabled : QPalette::Active, QPalette::PlaceholderText));
    const QRect outline = option->rect.adjusted(0, 0, -1, -1);
    round ? painter->drawEllipse(outline) : painter->drawRect(outline);
    painter->restore();
  }
};

// Light palettes of Qt leave the colour of quiet words open: a label that asks for it would be blank.
QPalette with_quiet_words(QPalette palette) {
  palette.setColor(QPalette::PlaceholderText, QColor(110, 110, 110));
  return palette;
}

const QPalette& palette_of_the_system() {
  static const QPalette palette = QApplication::palette();  // asked for before any other is set
  return palette;
}

}  // namespace

bool is_dark(const QPalette& palette) { return palette.color(QPalette::Window).lightness() < 128; }

void apply_theme(Theme theme) {
  const QPalette& system = palette_of_the_system();
  if (theme == Theme::system && !is_dark(system)) {
    QApplication::setPalette(with_quiet_words(system));
    return;
  }
  const bool dark = theme == Theme::dark || theme == Theme::system;
  // Fusion takes any palette. A style that is set anew dresses every widget anew.
  auto* style = QApplication::style();
  const bool is_there = dark ? dynamic_cast<DarkStyle*>(style) != nullptr : style->objectName() == "fusion";
  if (!is_there) QApplication::setStyle(dark ? new DarkStyle : QStyleFactory::create("Fusion"));
  const QPalette palette = dark ? dark_palette() : with_quiet_words(QApplication::style()->standardPalette());
  if (palette != QApplication::palette()) QApplication::setPalette(palette);
}

Theme saved_theme() { return static_cast<Theme>(std::clamp(QSettings().value("theme", 0).toInt(), 0, 2)); }

void save_theme(Theme theme) { QSettings().setValue("theme", static_cast<int>(theme)); }

void apply_saved_theme() { apply_theme(saved_theme()); }

QImage on_paper(QImage chart, const QPalette& palette) {
  if (!is_dark(palette)) return chart;
  chart = chart.convertToFormat(QImage::Format_RGBA8888);
  const QColor& paper = palette.color(QPalette::Base);
  const int base[3] = {paper.red(), paper.green(), paper.blue()};
  for (int y = 0; y < chart.height(); ++y) {
    auto* pixel = chart.scanLine(y);
    for (int x = 0; x < chart.width(); ++x, pixel += 4) {
      const auto [lo, hi] = std::minmax({pixel[0], pixel[1], pixel[2]});
      const int turn = 255 - lo - hi;  // L becomes 1 - L, hue and chroma stay
      for (int k = 0; k < 3; ++k) {
        const int value = std::clamp(pixel[k] + turn, 0, 255);
        pixel[k] = static_cast<uchar>(base[k] + value * (255 - base[k]) / 255);
      }
    }
  }
  return chart;
}

}  // namespace bole::desktop
