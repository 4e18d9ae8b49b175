#include "views/figure_picture.h"

#include <vtkRenderer.h>

#include <QFontDatabase>

#include "look/number_words.h"
#include "look/theme.h"

namespace bole::desktop {
namespace {

std::string in_the_language_of_the_window(std::string_view english) {
  return with_its_numbers("figures", QString::fromUtf8(english.data(), static_cast<int>(english.size()))).toStdString();
}

std::string chinese_font() {
  const auto families = QFontDatabase().families(QFontDatabase::SimplifiedChinese);
  return families.isEmpty() ? std::string() : families.front().toStdString();
}

}  // namespace

render::ScreenLook screen_look(const QPalette& palette) {
  static const std::string wide_font = chinese_font();
  return {is_dark(palette), in_the_language_of_the_window, wide_font};
}

void set_background(vtkRenderer* renderer, bool dark) {
  const render::Color paper = dark ? render::on_dark(render::ink::paper) : render::ink::paper;
  renderer->SetBackground(paper.r, paper.g, paper.b);
}

// Charts have colours of their own, which on_paper() turns over with the inks.
QImage figure_picture(const render::Figure& figure, const QPalette& palette, double dpi, double ratio) {
  auto look = screen_look(palette);
  look.dark = false;
  const auto image = render::screen_image(figure, dpi * ratio, look);
  const QImage picture(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888);
  QImage shown = on_paper(picture.copy(), palette);
  shown.setDevicePixelRatio(ratio);
  return shown;
}

}  // namespace bole::desktop
