#include "cloud/large_cloud.h"

#include <fmt/format.h>

#include <algorithm>

namespace bole {
inline namespace cloud {
namespace {

// The pages go first, then the memory that they describe.
struct OwnColumn {
  Column column;
  FilePages pages;
};
struct SharedColumn {
  std::shared_ptr<const Column> column;
  FilePages pages;
};

template <class F>
auto with_bytes(const Column& column, F&& f) {
  return std::visit([&](const auto& values) { return f(values.data(), sizeof(values[0])); }, column);
}

bool should_move(const Column& column) {
  return column_bytes(column) >= min_file_bytes &&
         !with_bytes(column, [&](const void* data, std::size_t) { return lies_on_file(data, column_bytes(column)); });
}

}  // namespace

std::size_t column_bytes(const Column& column) {
  return with_bytes(column, [&](const void*, std::size_t each) { return each * column_size(column); });
}

std::size_t columns_bytes(const PointCloud& cloud) {
  std::size_t bytes = 0;
  for (const auto& [name, column] : cloud.columns()) bytes += column_bytes(*column);
  return bytes;
}

std::shared_ptr<const Column> column_with_pages(Column column, FilePages pages) {
  auto own = std::make_shared<OwnColumn>(OwnColumn{std::move(column), std::move(pages)});
  const Column* const shown = &own->column;
  return {std::move(own), shown};
}

std::size_t lay_columns_on_file(PointCloud& cloud, const std::vector<std::filesystem::path>& folders,
                                std::size_t most_bytes) {
  if (columns_bytes(cloud) <= most_bytes) return 0;
  std::size_t left = 0;
  const auto columns = cloud.columns();
  for (const auto& [name, column] : columns) {
    if (!should_move(*column)) continue;
    // The values stay what they are; only the pages under them are others.
    auto pages = with_bytes(*column, [&, bytes = column_bytes(*column)](const void* data, std::size_t) {
      return lay_on_file(const_cast<void*>(data), bytes, Content::keep, folders);  // NOLINT
    });
    if (!pages) {
      left += column_bytes(*column);
      continue;
    }
    auto shared = std::make_shared<SharedColumn>(SharedColumn{column, std::move(pages)});
    const Column* const shown = shared->column.get();
    cloud.share_column(name, std::shared_ptr<const Column>(std::move(shared), shown));
  }
  return left;
}

std::string no_room_for_scratch(std::size_t bytes) {
  return fmt::format(
      "{:.1f} GB of columns stay in memory: no folder for temporary files has room for them. Free room on the disk, or "
      "set TMPDIR to a folder that has it",
      1e-9 * static_cast<double>(bytes));
}

void leave_memory(const Column& column, std::size_t first, std::size_t count) {
  with_bytes(column, [&](const void* data, std::size_t each) {
    count = std::min(count, column_size(column) - std::min(first, column_size(column)));
    base::leave_memory(static_cast<const std::byte*>(data) + each * first, each * count);
  });
}

void leave_memory(const PointCloud& cloud, std::size_t first, std::size_t count) {
  for (const auto& [name, column] : cloud.columns()) leave_memory(*column, first, count);
}

}  // namespace cloud
}  // namespace bole
