#include "cloud/data.h"

#include <array>

namespace bole {
inline namespace cloud {

std::string_view data_kind_name(DataKind kind) {
  constexpr std::array<std::string_view, 7> names{"none", "cloud", "table", "raster", "trajectory", "frames", "views"};
  return names[static_cast<std::size_t>(kind)];
}

bool DataSet::has(std::string_view port) const {
  const auto it = data_.find(port);
  return it != data_.end() && data_kind(it->second) != DataKind::none;
}

Error DataSet::missing(std::string_view port) {
  return bad_input("nothing of the right kind is connected to the input '" + std::string(port) + "'",
                   "the output of an earlier stage");
}

}  // namespace cloud
}  // namespace bole
