// A locale that writes 7,5 for seven and a half, in force for as long as the object lives. A desktop program runs under
// such a locale, and no file may be read or written differently for it.
#pragma once

#include <unistd.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace bole {

// Compiled here by localedef, which every system with glibc has: the test does not depend on the locales installed.
class CommaLocale {
 public:
  CommaLocale()
      : before_(std::setlocale(LC_NUMERIC, nullptr)),
        folder_(std::filesystem::temp_directory_path() / ("bole_locale_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "source") << "comment_char %\nescape_char /\nLC_NUMERIC\ndecimal_point \",\"\n"
                                         "thousands_sep \".\"\ngrouping 3;3\nEND LC_NUMERIC\n";
    std::ofstream(folder_ / "ascii") << "<code_set_name> ANSI_X3.4-1968\n<comment_char> %\n<escape_char> /\n"
                                        "CHARMAP\n<U0000>..<U007F> /x00 ASCII\nEND CHARMAP\n";
    const std::string at = folder_.string();
    const std::string command =
        "localedef -c -i '" + at + "/source' -f '" + at + "/ascii' '" + at + "/comma' >/dev/null 2>&1";
    // The exit code tells nothing: it is 1 for the categories that the source leaves out.
    [[maybe_unused]] const int ignored = std::system(command.c_str());
    ::setenv("LOCPATH", folder_.c_str(), 1);
    std::setlocale(LC_NUMERIC, "comma");
    ::unsetenv("LOCPATH");
  }
  ~CommaLocale() {
    std::setlocale(LC_NUMERIC, before_.c_str());
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  // False where localedef is absent.
  explicit operator bool() const { return std::localeconv()->decimal_point == std::string(","); }

 private:
  std::string before_;
  std::filesystem::path folder_;
};

}  // namespace bole
