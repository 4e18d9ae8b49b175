#include "base/error.h"

#include <utility>

namespace bole {
namespace {

std::string compose(const std::string& place, const std::string& found, const std::string& needed, const std::string& hint) {
  std::string text = place.empty() ? found : place + ": " + found;
  if (!needed.empty()) text += "; needed: " + needed;
  if (!hint.empty()) text += ". " + hint;
  return text;
}

}  // namespace

Error::Error(ErrorKind kind, std::string place, std::string found, std::string needed, std::string hint)
    : std::runtime_error(compose(place, found, needed, hint)),
      kind_(kind),
      place_(std::move(place)),
      found_(std::move(found)),
      needed_(std::move(needed)),
      hint_(std::move(hint)) {}

Error::Error(ErrorKind kind, std::string found, std::string needed, std::string hint) : Error(kind, std::string{}, std::move(found), std::move(needed), std::move(hint)) {}

Error Error::at(const std::string& place) const { return Error(kind_, place_.empty() ? place : place + ": " + place_, found_, needed_, hint_); }

int Error::exit_code() const {
  switch (kind_) {
    case ErrorKind::failed: return 1;
    case ErrorKind::bad_input: return 2;
    case ErrorKind::cancelled: return 3;
  }
  return 1;
}

Error bad_input(std::string found, std::string needed, std::string hint) { return Error(ErrorKind::bad_input, std::move(found), std::move(needed), std::move(hint)); }
Error failure(std::string found, std::string needed, std::string hint) { return Error(ErrorKind::failed, std::move(found), std::move(needed), std::move(hint)); }

}  // namespace bole
