// A figure of the report at the width of the widget.
#pragma once

#include <QWidget>
#include <functional>

#include "render/draw/figure.h"

namespace bole::desktop {

class FigureView : public QWidget {
  Q_OBJECT

 public:
  FigureView(const QString& empty_text, QWidget* parent);

  // Called with the width in millimetres whenever that changes; empty: the text is shown.
  void show_figure(std::function<render::Figure(double width_mm)> make);
  bool empty() const { return !make_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString empty_text_;
  std::function<render::Figure(double)> make_;
};

}  // namespace bole::desktop
