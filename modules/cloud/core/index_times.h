// Times of frames without reading them.
#pragma once

#include "cloud/scan_frame.h"

namespace bole {
inline namespace cloud {

// What a FrameSource is too, where the exact start of a frame lies in the frame and the index knows it about.
class IndexTimes {
 public:
  virtual ~IndexTimes() = default;
  // By the index of the recording alone: as exact as the recorder's clock (some ms to some tens of ms).
  virtual double index_time_s(std::size_t index) const = 0;
};

// The start of a frame: about it where that is known without reading, else exactly.
inline double index_time_s(const FrameSource& source, std::size_t index) {
  const auto* times = dynamic_cast<const IndexTimes*>(&source);
  return times != nullptr ? times->index_time_s(index) : source.frame_time_s(index);
}

}  // namespace cloud
}  // namespace bole
