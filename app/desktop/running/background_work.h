// One piece of work in a thread of its own, such as data that are simulated; signals arrive in the thread of the
// window.
#pragma once

#include <QObject>
#include <functional>
#include <thread>

#include "base/run.h"

namespace bole::desktop {

class BackgroundWork : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~BackgroundWork() override;  // cancels and waits

  // Ends with done(), cancelled() or failed(). Does nothing while other work is under way.
  void start(std::function<void(const Run&)> work);
  void cancel() { thread_.request_stop(); }
  bool busy() const { return busy_; }

 Q_SIGNALS:
  void progressed(double fraction, const QString& what);
  void done();
  void cancelled();
  void failed(const QString& sentence);

 private:
  std::jthread thread_;
  bool busy_ = false;
};

}  // namespace bole::desktop
