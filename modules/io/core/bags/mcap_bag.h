// MCAP files with ROS messages.
#pragma once

#include <map>

#include "io/core/bags/bag.h"
#include "io/core/bags/chunk_store.h"

namespace bole::io {

// The summary at the end of the file gives the chunks and the number of messages of each channel. The index behind each
// chunk is read when the messages of a topic are wanted. A file without a summary is gone through record by record.
class McapBag : public Bag {
 public:
  // Throws Error{bad_input} where the bytes are no MCAP file. `file` must outlive the bag.
  McapBag(Bytes file, const std::string& name, const Run& run);

  std::vector<BagMessage> index(std::size_t topic, const Run& run) const override;
  Bytes read(const BagMessage& message) const override;

 private:
  struct Record {
    std::uint8_t operation = 0;
    Bytes data;
    std::size_t end = 0;
    bool whole = false;
  };
  struct Chunk {
    std::uint32_t part = 0;
    std::vector<std::uint16_t> channels;  // with messages in it
    std::size_t index_at = 0, index_end = 0;
    bool indexed = false;
  };
  // The end of the file is as it should be, with or without the summary.
  enum class Ending { missing, whole };

  static Record record_at(Bytes bytes, std::size_t at);
  bool read_summary();
  bool overlapping_indices() const;
  bool count_by_index(Chunk& chunk);
  void add_chunk_index(Bytes data);
  void add_schema(Bytes data);
  void add_channel(Bytes data);
  bool add_statistics(Bytes data);
  bool open_chunk(const Record& record, Chunk& chunk);
  void scan(const Run& run);
  void scan_chunk(Chunk& chunk);
  void count_message(std::uint16_t channel, std::int64_t time_ns);
  template <class Visit>
  bool visit_index(const Chunk& chunk, Visit&& visit) const;
  template <class Visit>
  void visit_records(Bytes bytes, std::uint32_t part, Visit&& visit) const;

  Bytes file_;
  std::string name_;
  ChunkStore store_;
  Ending ending_ = Ending::missing;
  mutable std::vector<std::uint8_t> decompressed_;
  std::vector<Chunk> chunks_;
  std::map<std::uint16_t, std::string> schemas_;  // their names
  std::map<std::uint16_t, std::size_t> topic_of_channel_;
  std::map<std::uint16_t, std::vector<BagMessage>> loose_;  // messages outside of chunks
};

}  // namespace bole::io
