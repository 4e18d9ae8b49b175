#include "base/run.h"

#include "base/error.h"

namespace bole {
inline namespace base {

void Run::check_cancel() const {
  if (cancelled()) throw Error(ErrorKind::cancelled, "cancelled on request", {}, "Nothing was changed");
}

Run Run::part(double begin, double end) const {
  Run inner = *this;
  if (progress)
    inner.progress = [outer = progress, begin, end](double f, std::string_view what) {
      outer(begin + f * (end - begin), what);
    };
  return inner;
}

}  // namespace base
}  // namespace bole
