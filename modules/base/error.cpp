#include "base/error.h"

#include <utility>

namespace bole {
inline namespace base {
std::string Error::compose(const Parts& p) {
  std::string text = p.place.empty() ? p.found : p.place + ": " + p.found;
  if (!p.needed.empty()) text += "; needed: " + p.needed;
  if (!p.hint.empty()) text += ". " + p.hint;
  return text;
}

Error::Error(ErrorKind error_kind, Parts parts)
    : std::runtime_error(compose(parts)), kind_(error_kind), parts_(std::move(parts)) {}

Error::Error(ErrorKind error_kind, std::string what_found, std::string what_needed, std::string what_to_do)
    : Error(error_kind, Parts{{}, std::move(what_found), std::move(what_needed), std::move(what_to_do)}) {}

Error Error::at(const std::string& where) const {
  Parts parts = parts_;
  parts.place = parts.place.empty() ? where : where + ": " + parts.place;
  return Error(kind_, std::move(parts));
}

int Error::exit_code() const {
  switch (kind_) {
    case ErrorKind::failed:
      return 1;
    case ErrorKind::bad_input:
      return 2;
    case ErrorKind::cancelled:
      return 3;
  }
  return 1;
}

Error bad_input(std::string found, std::string needed, std::string hint) {
  return Error(ErrorKind::bad_input, std::move(found), std::move(needed), std::move(hint));
}
Error failure(std::string found, std::string needed, std::string hint) {
  return Error(ErrorKind::failed, std::move(found), std::move(needed), std::move(hint));
}

}  // namespace base
}  // namespace bole
