#include "base/user_path.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

namespace bole {
inline namespace base {
namespace {

// Empty where it is not known.
std::string home_of(const std::string& user) {
  if (const char* home = std::getenv("HOME"); user.empty() && home != nullptr && *home != '\0') return home;
  const passwd* const entry = user.empty() ? ::getpwuid(::getuid()) : ::getpwnam(user.c_str());
  return entry != nullptr && entry->pw_dir != nullptr ? entry->pw_dir : std::string();
}

}  // namespace

std::string expand_home(std::string_view path) {
  if (!path.starts_with('~')) return std::string(path);
  const auto slash = path.find('/');
  const auto user = path.substr(1, slash == std::string_view::npos ? slash : slash - 1);
  const auto home = home_of(std::string(user));
  if (home.empty()) return std::string(path);
  return home + std::string(slash == std::string_view::npos ? std::string_view{} : path.substr(slash));
}

}  // namespace base
}  // namespace bole
