// Text for XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace bole {
inline namespace base {

// `text` with the five special characters as entities, for element text and quoted attributes; control characters that
// no XML document may hold are left out.
std::string escaped(std::string_view text);

}  // namespace base
}  // namespace bole
