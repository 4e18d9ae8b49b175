// File > Open sample plot: simulates a small plot once, opens its pipeline and runs it.
#pragma once

#include <QObject>
#include <optional>
#include <stop_token>
#include <thread>

#include "pipeline/document.h"

namespace bole::desktop {

class Workbench;

class SamplePlot : public QObject {
  Q_OBJECT

 public:
  explicit SamplePlot(Workbench& bench);
  ~SamplePlot() override;  // cancels and waits

  // Makes the sample in a thread unless it exists; ends with ready() or failed().
  void prepare(const QString& folder);
  bool busy() const { return busy_; }
  static QString default_folder();  // in the cache of the person

 Q_SIGNALS:
  void progressed(double fraction, const QString& what);
  void ready(const std::shared_ptr<const pipeline::PipelineDocument>& document, const QString& path);
  void failed(const QString& sentence);

 private:
  std::jthread thread_;
  bool busy_ = false;
};

}  // namespace bole::desktop
