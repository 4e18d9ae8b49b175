#include "io/core/copc/copc_bins.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "base/error.h"

namespace bole::io::copc {

RecordBins::~RecordBins() {
  std::error_code ignored;
  for (const auto& [cube, bin] : bins_)
    if (bin.on_file > 0) std::filesystem::remove(file_of(cube), ignored);
}

std::filesystem::path RecordBins::file_of(const Cube& cube) const {
  return folder_ / fmt::format("{}_{}_{}_{}.records", name_, cube[0], cube[1], cube[2]);
}

void RecordBins::put(const Cube& cube, const std::uint8_t* record) {
  if (last_.second == nullptr || last_.first != cube) last_ = {cube, &bins_[cube]};
  auto& waiting = last_.second->waiting;
  waiting.insert(waiting.end(), record, record + record_length_);
  waiting_bytes_ += record_length_;
  if (waiting_bytes_ >= max_bytes_) spill();
}

void RecordBins::spill() {
  for (auto& [cube, bin] : bins_) {
    if (bin.waiting.empty()) continue;
    std::ofstream out(file_of(cube), std::ios::binary | (bin.on_file > 0 ? std::ios::app : std::ios::trunc));
    out.write(reinterpret_cast<const char*>(bin.waiting.data()), static_cast<std::streamsize>(bin.waiting.size()));
    out.close();
    if (!out)
      throw failure(fmt::format("'{}' cannot be written: the disk may be full", file_of(cube).string()),
                    "room for all points of the cloud, uncompressed",
                    "Free room, or set TMPDIR to a folder that has it");
    bin.on_file += bin.waiting.size() / record_length_;
    bin.waiting = {};
  }
  waiting_bytes_ = 0;
}

std::vector<Cube> RecordBins::cubes() const {
  std::vector<Cube> out;
  for (const auto& [cube, bin] : bins_)
    if (bin.on_file > 0 || !bin.waiting.empty()) out.push_back(cube);
  return out;
}

std::uint64_t RecordBins::count(const Cube& cube) const {
  const auto it = bins_.find(cube);
  return it == bins_.end() ? 0 : it->second.on_file + it->second.waiting.size() / record_length_;
}

void RecordBins::read(const Cube& cube, std::uint64_t first, std::size_t most, std::vector<std::uint8_t>& records) {
  const auto& bin = bins_.at(cube);
  records.clear();
  if (first < bin.on_file) {
    const std::uint64_t number = std::min<std::uint64_t>(most, bin.on_file - first);
    records.resize(number * record_length_);
    std::ifstream in(file_of(cube), std::ios::binary);
    in.seekg(static_cast<std::streamoff>(first * record_length_));
    in.read(reinterpret_cast<char*>(records.data()), static_cast<std::streamsize>(records.size()));
    if (!in)
      throw failure(fmt::format("'{}' cannot be read", file_of(cube).string()), "the file that was written just now",
                    "Build the index again");
    if (number == most) return;
  }
  const std::uint64_t skip = first < bin.on_file ? 0 : first - bin.on_file;
  const std::uint64_t there = bin.waiting.size() / record_length_ - skip;
  const std::uint64_t number = std::min<std::uint64_t>(most - records.size() / record_length_, there);
  const auto* from = bin.waiting.data() + skip * record_length_;
  records.insert(records.end(), from, from + number * record_length_);
}

std::vector<std::uint8_t> RecordBins::take_all(const Cube& cube) {
  std::vector<std::uint8_t> records;
  read(cube, 0, count(cube), records);
  forget(cube);
  return records;
}

void RecordBins::forget(const Cube& cube) {
  const auto it = bins_.find(cube);
  if (it == bins_.end()) return;
  waiting_bytes_ -= it->second.waiting.size();
  std::error_code ignored;
  if (it->second.on_file > 0) std::filesystem::remove(file_of(cube), ignored);
  bins_.erase(it);
  last_ = {{}, nullptr};
}

}  // namespace bole::io::copc
