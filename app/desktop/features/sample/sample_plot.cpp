#include "features/sample/sample_plot.h"

#include <QDir>
#include <QStandardPaths>

#include "document/new_document.h"
#include "workbench/workbench.h"

namespace bole::desktop {

SamplePlot::SamplePlot(Workbench& bench) : QObject(&bench) {
  auto* b = &bench;
  bench.commands().add(
      {.id = "document.open_sample", .text = tr("Open sample plot"), .places = {in_menu(Menu::file)}, .act = [this] {
         prepare(default_folder());
       }});
  connect(this, &SamplePlot::ready, b, [b](const auto& document, const QString& path) {
    b->guarded([&] { b->open_made(*document, sample_pipeline_path(path)); });
  });
  connect(this, &SamplePlot::progressed, b,
          [b](double, const QString& what) { b->hint(tr("Making the sample plot: %1").arg(what)); });
  connect(this, &SamplePlot::failed, b, &Workbench::complain);
  connect(&work_, &BackgroundWork::progressed, this, &SamplePlot::progressed);
  connect(&work_, &BackgroundWork::failed, this, &SamplePlot::failed);
  connect(&work_, &BackgroundWork::done, this,
          [this] { Q_EMIT ready(document_, QDir(folder_).filePath("sample_plot.json")); });
}

QString SamplePlot::default_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/sample_plot";
}

void SamplePlot::prepare(const QString& folder) {
  if (busy()) return;
  folder_ = folder;
  work_.start([this, folder](const Run& run) {
    document_ = std::make_shared<const pipeline::PipelineDocument>(sample_document(folder, run));
  });
}

void install_sample(Workbench& bench) { new SamplePlot(bench); }

}  // namespace bole::desktop
