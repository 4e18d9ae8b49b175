#include "io/core/gdal/gdal_support.h"

#include <cpl_error.h>
#include <gdal_priv.h>

#include <unistd.h>

#include <mutex>

#include "base/error.h"

namespace bole::io::gdal {

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

}  // namespace bole::io::gdal
