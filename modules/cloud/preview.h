// Snapshots of a stage's work in hand, for somebody who watches it grow.
#pragma once

#include "cloud/data.h"

namespace bole {
inline namespace cloud {

// A stage that has something to look at before it is done (Run::preview) asks wants() now and then, and makes and shows
// a snapshot only when somebody takes it: an unwatched run pays one comparison with null. Nothing comes back from
// here, so a watched run gives the same result. Both are called from the thread that called the stage.
class Preview {
 public:
  virtual ~Preview() = default;

  // Whether a snapshot would be taken now; false while the one before is still being looked at.
  virtual bool wants() = 0;

  // Parts by name, documented where the stage makes them. Taken at any time: a stage shows the last state of a step
  // unasked.
  virtual void show(DataSet snapshot) = 0;
};

}  // namespace cloud
}  // namespace bole
