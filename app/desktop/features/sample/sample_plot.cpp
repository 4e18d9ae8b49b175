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
}

SamplePlot::~SamplePlot() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

QString SamplePlot::default_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/sample_plot";
}

void SamplePlot::prepare(const QString& folder) {
  if (busy_) return;
  if (thread_.joinable()) thread_.join();
  busy_ = true;
  thread_ = std::jthread([this, folder](const std::stop_token& cancel) {
    const auto tell = [this](auto signal) { QMetaObject::invokeMethod(this, signal, Qt::QueuedConnection); };
    Run run;
    run.cancel = cancel;
    run.progress = [&](double fraction, std::string_view what) {
      tell([this, fraction, text = QString::fromUtf8(what.data(), static_cast<int>(what.size()))] {
        Q_EMIT progressed(fraction, text);
      });
    };
    try {
      auto document = std::make_shared<const pipeline::PipelineDocument>(sample_document(folder, run));
      tell([this, document, folder] {
        busy_ = false;
        Q_EMIT ready(document, QDir(folder).filePath("sample_plot.json"));
      });
    } catch (const std::exception& e) {
      tell([this, text = QString::fromUtf8(e.what())] {
        busy_ = false;
        Q_EMIT failed(text);
      });
    }
  });
}

void install_sample(Workbench& bench) { new SamplePlot(bench); }

}  // namespace bole::desktop
