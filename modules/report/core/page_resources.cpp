#include "report/core/page_resources.h"

#include <fstream>
#include <sstream>

#include "base/error.h"
#include "base/markup.h"
#include "base/resources.h"

namespace bole::report {

std::string page_resource(std::string_view name) {
  const auto path = resource_path("report/" + std::string(name));
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw failure("cannot read " + path.string());
  return text.str();
}

std::string page_style(std::string_view name) { return "<style>\n" + page_resource(name) + "</style>\n"; }

std::string page_script(std::string_view name) { return "<script>\n" + page_resource(name) + "</script>\n"; }

std::string page_head(const std::string& title, std::string_view style) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n" + page_style(style) + "</head>\n<body>\n";
}

}  // namespace bole::report
