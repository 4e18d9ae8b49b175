// Figures that features draw of what they show. File > Export a figure lists them behind those of the report.
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "render/draw/figure.h"

namespace bole::desktop {

struct OfferedFigure {
  QString name;                                         // in the language of the window; each has its own
  std::function<render::Figure(double width_mm)> make;  // may be called in any thread, and later
};

class OfferedFigures : public QObject {
  Q_OBJECT

 public:
  static OfferedFigures& of(QObject& bench);  // the one of the window, made when it is first asked for

  void offer(std::function<std::vector<OfferedFigure>()> source);
  std::vector<OfferedFigure> now() const;
  void export_one(const QString& name) { Q_EMIT asked(name); }

 Q_SIGNALS:
  void asked(const QString& name);  // to be exported

 private:
  explicit OfferedFigures(QObject* bench) : QObject(bench) {}

  std::vector<std::function<std::vector<OfferedFigure>()>> sources_;
};

}  // namespace bole::desktop
