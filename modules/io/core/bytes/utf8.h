#pragma once

#include <string>

namespace bole::io {

// `text` where it is UTF-8; else as if its bytes were Latin-1, as older programs write them.
std::string as_utf8(std::string text);

}  // namespace bole::io
