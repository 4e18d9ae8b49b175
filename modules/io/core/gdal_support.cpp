#include "io/core/gdal_support.h"

#include <cpl_error.h>
#include <gdal_priv.h>

#include <unistd.h>

#include <mutex>

#include "base/error.h"

namespace bole::gdal {

void CloseDataset::operator()(GDALDataset* set) const { GDALClose(set); }

GDALDriver& driver(const char* name) {
  static std::once_flag once;
  std::call_once(once, GDALAllRegister);
  auto* found = GetGDALDriverManager()->GetDriverByName(name);
  if (found == nullptr) throw failure(std::string("this GDAL has no driver ") + name, "a GDAL with it");
  return *found;
}

Errors::Errors() {
  CPLErrorReset();
  CPLPushErrorHandler(CPLQuietErrorHandler);
}

Errors::~Errors() { CPLPopErrorHandler(); }

std::string Errors::last() const {
  const std::string text = CPLGetLastErrorMsg();
  return text.empty() ? "no reason given" : text;
}

void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::string& temporary)>& write) {
  // The extension stays: some drivers look at it.
  const std::string temporary = (path.parent_path() / (path.stem().string() + ".partial-" + std::to_string(::getpid()) +
                                                       path.extension().string()))
                                    .string();
  std::error_code ignored;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ignored);
  std::filesystem::remove(temporary, ignored);
  try {
    write(temporary);
  } catch (...) {
    std::filesystem::remove(temporary, ignored);
    throw;
  }
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error) {
    std::filesystem::remove(temporary, ignored);
    throw failure("'" + path.string() + "' cannot take its name: " + error.message());
  }
}

}  // namespace bole::gdal
