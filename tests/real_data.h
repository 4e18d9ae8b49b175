// Real files beside the checkout, in ../shared/data. A test that needs one which is absent is skipped, and ./do test
// counts it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#define BOLE_NEEDS_REAL(path)         \
  if (!std::filesystem::exists(path)) \
  GTEST_SKIP() << "for want of ../shared/data: " << std::filesystem::path(path).lexically_normal().string()
