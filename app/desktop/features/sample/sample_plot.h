// File > Open sample plot: simulates a small plot once, opens its pipeline and runs it.
#pragma once

#include <QObject>

#include "pipeline/document.h"
#include "running/background_work.h"

namespace bole::desktop {

class Workbench;

class SamplePlot : public QObject {
  Q_OBJECT

 public:
  explicit SamplePlot(Workbench& bench);

  // Makes the sample in a thread unless it exists; ends with ready() or failed().
  void prepare(const QString& folder);
  bool busy() const { return work_.busy(); }
  static QString default_folder();  // in the cache of the person

 Q_SIGNALS:
  void progressed(double fraction, const QString& what);
  void ready(const std::shared_ptr<const pipeline::PipelineDocument>& document, const QString& path);
  void failed(const QString& sentence);

 private:
  QString folder_;
  std::shared_ptr<const pipeline::PipelineDocument> document_;
  BackgroundWork work_;  // the last member: it ends before the others
};

}  // namespace bole::desktop
