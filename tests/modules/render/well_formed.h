// Whether elements of an XML or XHTML-like text open and close in order; scripts, comments and void elements are
// stepped over.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace bole::testing_data {

// Empty when well formed, else what is wrong.
inline std::string markup_trouble(const std::string& text) {
  constexpr std::array<std::string_view, 3> empty_elements{"meta", "br", "img"};
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    const auto end = text.find('>', at);
    if (end == std::string::npos) return "a tag without end";
    std::string tag = text.substr(at + 1, end - at - 1);
    at = end + 1;
    if (tag.empty() || tag[0] == '?' || tag[0] == '!') continue;
    const bool closes = tag[0] == '/', alone = tag.back() == '/';
    const std::string name = tag.substr(closes, tag.find_first_of(" \n\t/", closes) - (closes ? 1U : 0U));
    if (closes) {
      if (open.empty() || open.back() != name)
        return "</" + name + "> closes <" + (open.empty() ? "" : open.back()) + ">";
      open.pop_back();
    } else if (!alone && std::find(empty_elements.begin(), empty_elements.end(), name) == empty_elements.end()) {
      open.push_back(name);
      if (name == "script") at = text.find("</script>", at);
    }
  }
  return open.empty() ? std::string() : "<" + open.back() + "> stays open";
}

}  // namespace bole::testing_data
