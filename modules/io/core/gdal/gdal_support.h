// Drivers and error messages of GDAL, for the readers and writers of this folder.
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

// The driver of this name. Throws Error{failed} where GDAL was built without it.
GDALDriver& driver(const char* name);

// Collects GDAL's errors during its lifetime, so that they are not printed.
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
