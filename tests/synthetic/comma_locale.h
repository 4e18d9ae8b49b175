// The numbers of a country that writes 7,5 for seven and a half, for as long as the object lives. A desktop program
// runs under such a locale; no file may read or look different for it.
#pragma once

#include <unistd.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace bole {

class CommaLocale {
 public:
  CommaLocale() : before_(std::setlocale(LC_NUMERIC, nullptr)) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
      if (!found_) found_ = std::setlocale(LC_NUMERIC, name) != nullptr;
    if (!found_) compile();
  }
  ~CommaLocale() {
    std::setlocale(LC_NUMERIC, before_.c_str());
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  // False where the system has no such locale and none can be compiled.
  explicit operator bool() const { return found_ && std::localeconv()->decimal_point == std::string(","); }

 private:
  void compile() {
    folder_ = std::filesystem::temp_directory_path() / ("bole_locale_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    const std::string command = "localedef -c -i de_DE -f UTF-8 '" + (folder_ / "de_DE.UTF-8").string() + "' 2>&1";
    if (std::system(command.c_str()) != 0) return;
    ::setenv("LOCPATH", folder_.c_str(), 1);
    found_ = std::setlocale(LC_NUMERIC, "de_DE.UTF-8") != nullptr;
    ::unsetenv("LOCPATH");
  }

  std::string before_;
  bool found_ = false;
  std::filesystem::path folder_;
};

}  // namespace bole
