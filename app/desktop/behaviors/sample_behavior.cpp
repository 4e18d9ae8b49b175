#include "behaviors/sample_behavior.h"

#include <QDir>
#include <QStandardPaths>

#include "document/new_document.h"

namespace bole::desktop {

SampleBehavior::~SampleBehavior() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

QString SampleBehavior::default_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/sample_plot";
}

void SampleBehavior::prepare(const QString& folder) {
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

}  // namespace bole::desktop
