// Real files beside the checkout, in ../shared/data. A test that needs one which is absent is skipped, and ./do test
// counts it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace bole {

inline std::string want_of(const std::filesystem::path& real) {
  return "for want of ../shared/data: " + real.lexically_normal().string();
}

}  // namespace bole

#define BOLE_NEEDS_REAL(real) \
  if (!std::filesystem::exists(real)) GTEST_SKIP() << ::bole::want_of(real)
