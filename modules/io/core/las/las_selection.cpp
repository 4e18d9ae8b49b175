#include "io/core/las/las_selection.h"

#include <tbb/parallel_for.h>

#include "io/core/las/las_bytes.h"

namespace bole::io::las {

void RecordSelection::collect(const std::uint8_t* records, std::size_t count, std::vector<std::uint8_t>& kept) const {
  for (std::size_t i = 0; i < count; ++i, records += stride_) {
    std::int32_t v[3];
    std::memcpy(v, records, sizeof v);
    const Eigen::Vector3d p = offset_ + Eigen::Vector3d(v[0], v[1], v[2]).cwiseProduct(scale_);
    if (bounds_.contains(p)) kept.insert(kept.end(), records, records + stride_);
  }
}

std::uint64_t RecordSelection::append(ColumnBuilder& builder, std::span<const std::vector<std::uint8_t>> kept,
                                      std::uint64_t placed, IntegerBox& box) const {
  std::vector<std::uint64_t> first;
  for (const auto& records : kept) {
    first.push_back(placed);
    placed += records.size() / stride_;
  }
  builder.resize(placed);
  std::vector<IntegerBox> boxes(kept.size());
  tbb::parallel_for(std::size_t{0}, kept.size(), [&](std::size_t i) {
    if (!kept[i].empty()) boxes[i] = builder.decode(kept[i].data(), kept[i].size() / stride_, first[i]);
  });
  for (const auto& b : boxes) box.add(b);
  if (!first.empty()) builder.leave(first.front(), placed - first.front());
  return placed;
}

}  // namespace bole::io::las
