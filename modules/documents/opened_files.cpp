#include "documents/opened_files.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "io/core/formats.h"

namespace bole::documents {

std::map<std::string, pipeline::OpenedFiles> opened_files() {
  std::map<std::string, pipeline::OpenedFiles> opened;
  std::map<std::string, std::set<std::string>> seen;
  for (const auto& format : io::formats()) {
    if (format.folder) continue;
    auto& files = opened[std::string(format.stage())];
    if (files.description.empty()) {
      files.description = std::string(io::content_name(format.content())) + " (Bole)";
      files.description[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(files.description[0])));
    }
    for (const auto ending : format.endings) {
      const std::string extension(ending.substr(1));  // without the dot
      if (!seen[std::string(format.stage())].insert(extension).second) continue;
      files.extensions += (files.extensions.empty() ? "" : " ") + extension;
    }
  }
  return opened;
}

}  // namespace bole::documents
