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
  std::string text = CPLGetLastErrorMsg();
  if (text.empty()) return "no reason given";
  // SQLite repeats the whole statement, kilobytes of it, and says why behind it.
  constexpr std::size_t longest = 160;
  if (text.size() <= longest) return text;
  const auto reason = text.rfind(": ");
  auto why = reason == std::string::npos ? std::string() : text.substr(reason + 2);
  if (!why.empty() && why.size() <= longest) return why;
  return text.substr(0, longest) + " ...";
}

}  // namespace bole::io::gdal
