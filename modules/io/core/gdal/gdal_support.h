// What the GDAL writers share.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

class GDALDataset;
class GDALDriver;

namespace bole::io::gdal {

struct CloseDataset {
  void operator()(GDALDataset* set) const;
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

// Registers all drivers once and returns the one of that name. Throws Error{failed} when GDAL was built without it.
GDALDriver& driver(const char* name);

// While it lives, GDAL's errors are collected rather than printed.
class Errors {
 public:
  Errors();
  ~Errors();
  Errors(const Errors&) = delete;
  Errors& operator=(const Errors&) = delete;
  // The last message, or "no reason given".
  std::string last() const;
};

}  // namespace bole::io::gdal
