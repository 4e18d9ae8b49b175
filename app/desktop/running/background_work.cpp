#include "running/background_work.h"

#include "base/error.h"

namespace bole::desktop {

BackgroundWork::~BackgroundWork() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void BackgroundWork::start(std::function<void(const Run&)> work) {
  if (busy_) return;
  if (thread_.joinable()) thread_.join();
  busy_ = true;
  thread_ = std::jthread([this, work = std::move(work)](const std::stop_token& cancel) {
    const auto tell = [this](auto signal) { QMetaObject::invokeMethod(this, signal, Qt::QueuedConnection); };
    const auto end = [&](auto signal) {
      tell([this, signal] {
        busy_ = false;
        signal();
      });
    };
    Run run;
    run.cancel = cancel;
    run.progress = [&](double fraction, std::string_view what) {
      tell([this, fraction, text = QString::fromUtf8(what.data(), static_cast<int>(what.size()))] {
        Q_EMIT progressed(fraction, text);
      });
    };
    try {
      work(run);
      end([this] { Q_EMIT done(); });
    } catch (const std::exception& e) {
      const auto* error = dynamic_cast<const Error*>(&e);
      if (error && error->kind() == ErrorKind::cancelled)
        end([this] { Q_EMIT cancelled(); });
      else
        end([this, text = QString::fromUtf8(e.what())] { Q_EMIT failed(text); });
    }
  });
}

}  // namespace bole::desktop
