// What a QPainter draws, as an SVG file: paths with plain colours, text as outlines, so that it looks the same on every
// computer and in every language. Qt's own SVG module would be one more package.
#pragma once

#include <QByteArray>
#include <QPaintDevice>
#include <QSize>
#include <memory>

namespace bole::desktop {

class SvgPaper : public QPaintDevice {
 public:
  explicit SvgPaper(const QSize& size);  // pixels of the screen
  ~SvgPaper() override;
  SvgPaper(const SvgPaper&) = delete;
  SvgPaper& operator=(const SvgPaper&) = delete;

  QByteArray svg() const;  // when the painter has ended

  QPaintEngine* paintEngine() const override;

 protected:
  int metric(PaintDeviceMetric metric) const override;

 private:
  class Engine;
  QSize size_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace bole::desktop
