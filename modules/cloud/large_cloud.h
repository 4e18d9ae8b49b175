// Clouds whose columns are larger than memory should hold: they lie in scratch files (base/file_pages.h) and are in
// memory only where somebody works on them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/file_pages.h"
#include "cloud/point_cloud.h"

namespace bole {
inline namespace cloud {

// Clouds with more bytes of columns than this lie on file, each column of at least min_file_bytes. Positions do not
// count: every stage goes through them again and again, and they always stay in memory.
inline constexpr std::size_t large_columns_bytes = std::size_t{1} << 30;

std::size_t columns_bytes(const PointCloud& cloud);
std::size_t column_bytes(const Column& column);

// A column and the pages that it lies on, as a column that clouds share.
std::shared_ptr<const Column> column_with_pages(Column column, FilePages pages);

// Lays the columns of a cloud with more than `most_bytes` of them on file, in one of the folders (scratch_folders()).
// Their addresses and values do not change; other clouds that share them gain as well. The bytes
// that should lie on file and for which there was no room.
std::size_t lay_columns_on_file(PointCloud& cloud, const std::vector<std::filesystem::path>& folders,
                                std::size_t most_bytes = large_columns_bytes);

// What to tell a person then.
std::string no_room_for_scratch(std::size_t bytes);

// Lets the points [first, first + count) of all columns leave memory, as far as they lie on file.
void leave_memory(const PointCloud& cloud, std::size_t first, std::size_t count);
inline void leave_memory(const PointCloud& cloud) { leave_memory(cloud, 0, cloud.size()); }
void leave_memory(const Column& column, std::size_t first, std::size_t count);

}  // namespace cloud
}  // namespace bole
