// Records on disk, sorted by cubes of an octree: what does not fit into memory.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace bole::io::copc {

// Places among the 2^level cubes of each axis.
using Cube = std::array<int, 3>;

class RecordBins {
 public:
  // Files go to `folder`, which must be there, and are removed with this object. Records wait in memory until they take
  // `max_bytes`.
  RecordBins(std::filesystem::path folder, std::string name, std::size_t record_length, std::size_t max_bytes)
      : folder_(std::move(folder)), name_(std::move(name)), record_length_(record_length), max_bytes_(max_bytes) {}
  ~RecordBins();
  RecordBins(const RecordBins&) = delete;
  RecordBins& operator=(const RecordBins&) = delete;

  // Throws Error{failed} when the disk is full.
  void put(const Cube& cube, const std::uint8_t* record);

  std::vector<Cube> cubes() const;
  std::uint64_t count(const Cube& cube) const;

  // Calls f(records, count) for the records of a cube in the order in which they came, some at a time.
  template <class F>
  void for_each(const Cube& cube, F&& f) {
    constexpr std::size_t at_once = 1 << 17;
    std::vector<std::uint8_t> records;
    for (std::uint64_t first = 0; first < count(cube); first += at_once) {
      read(cube, first, at_once, records);
      f(records.data(), records.size() / record_length_);
    }
  }
  std::vector<std::uint8_t> take_all(const Cube& cube);  // and forgets them
  void forget(const Cube& cube);

 private:
  struct Bin {
    std::vector<std::uint8_t> waiting;
    std::uint64_t on_file = 0;  // records
  };
  std::filesystem::path file_of(const Cube& cube) const;
  void spill();
  void read(const Cube& cube, std::uint64_t first, std::size_t most, std::vector<std::uint8_t>& records);

  std::filesystem::path folder_;
  std::string name_;
  std::size_t record_length_, max_bytes_, waiting_bytes_ = 0;
  std::map<Cube, Bin> bins_;
  std::pair<Cube, Bin*> last_{{}, nullptr};  // points that follow one another mostly lie in the same cube
};

}  // namespace bole::io::copc
