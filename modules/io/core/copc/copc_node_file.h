// A COPC file that is written node by node.
#pragma once

#include <filesystem>
#include <vector>

#include "base/atomic_file.h"
#include "io/core/copc/copc_build.h"
#include "io/core/copc/copc_hierarchy.h"
#include "io/core/laz/laz_chunks.h"

namespace bole::io::copc {

class NodeFile {
 public:
  NodeFile(const std::filesystem::path& path, const RecordStream& stream, const OctreeRoot& root);

  // In any order; the parent of each but the root comes some time. Several are compressed at once. Without records: a
  // node without points.
  struct Node {
    int level = 0;
    Eigen::Vector3i key = Eigen::Vector3i::Zero();
    Bytes records;
  };
  void write(const std::vector<Node>& nodes);

  // Writes the hierarchy and gives the file its name.
  BuiltFile finish();

 private:
  std::vector<std::uint8_t> header(const Hierarchy& hierarchy, std::uint64_t hierarchy_at) const;
  void sort_by_level();
  void put(Bytes bytes);
  void put_number(std::uint64_t number);

  const RecordStream& stream_;
  laz::Packing packing_;
  AtomicFile out_;
  Octree octree_;
  std::vector<laz::Chunk> chunks_;
  las::RecordStatistics statistics_;
  std::uint64_t at_ = 0, first_evlr_ = 0;
};

}  // namespace bole::io::copc
