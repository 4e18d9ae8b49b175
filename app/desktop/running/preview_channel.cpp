#include "running/preview_channel.h"

namespace bole::desktop {

bool PreviewChannel::wants() { return *under_way_ == 0 && std::chrono::steady_clock::now() - last_ >= gap; }

void PreviewChannel::show(DataSet snapshot) {
  last_ = std::chrono::steady_clock::now();
  ++*under_way_;
  QMetaObject::invokeMethod(
      receiver_,
      [take = take_, under_way = under_way_, snapshot = std::move(snapshot)] {
        take(snapshot);
        --*under_way;
      },
      Qt::QueuedConnection);
}

}  // namespace bole::desktop
