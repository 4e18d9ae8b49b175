// A figure as a page embeds it.
#pragma once

#include <string>

namespace bole::report {

struct ReportPicture {
  std::string title, caption;
  std::string media_type;  // "image/svg+xml" or "image/png"
  std::string bytes;
  bool wide = true;  // over the whole page; else two side by side
};

}  // namespace bole::report
