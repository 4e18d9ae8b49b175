#include "io/core/bytes/utf8.h"

#include <cpl_conv.h>
#include <cpl_string.h>

#include <memory>

namespace bole::io {

std::string as_utf8(std::string text) {
  if (CPLIsUTF8(text.data(), static_cast<int>(text.size())) != FALSE) return text;
  const std::unique_ptr<char, decltype(&VSIFree)> recoded(CPLRecode(text.c_str(), CPL_ENC_ISO8859_1, CPL_ENC_UTF8),
                                                          &VSIFree);
  return recoded.get();
}

}  // namespace bole::io
