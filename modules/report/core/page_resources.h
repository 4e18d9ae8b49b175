// The style and the scripts of pages: files in resources/report.
#pragma once

#include <string>
#include <string_view>

namespace bole::report {

// The text of resources/report/NAME. Throws Error{bad_input} when it is absent, Error{failed} when it cannot be read.
std::string page_resource(std::string_view name);

// "<style>...</style>" and "<script>...</script>" of such a file.
std::string page_style(std::string_view name);
std::string page_script(std::string_view name);

// Doctype, head with title and style, and the open <body>.
std::string page_head(const std::string& title, std::string_view style);

}  // namespace bole::report
