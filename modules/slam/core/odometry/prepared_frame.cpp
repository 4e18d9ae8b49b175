#include "slam/core/odometry/prepared_frame.h"

#include "base/error.h"
#include "slam/core/stopwatch.h"

namespace bole::slam {

void prepare_frame(const FrameSource& source, std::size_t i, const ScanGate& gate, FeatureExtractor& extractor,
                   PreparedFrame& out) {
  Stopwatch watch;
  out.unreadable.clear();
  try {
    source.read(i, out.frame);
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::cancelled) throw;
    out.unreadable = e.what();
  }
  out.read_s = watch.lap();
  if (!out.unreadable.empty()) return;
  prepare_scan(out.frame, gate, out.scan);
  extractor.extract(out.scan, out.features);
  out.features_s = watch.lap();
}

}  // namespace bole::slam
