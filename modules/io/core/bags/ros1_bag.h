// Bags of ROS 1, version 2.0.
#pragma once

#include <map>
#include <optional>

#include "io/core/bags/bag.h"
#include "io/core/bags/chunk_store.h"

namespace bole::io {

// The index at the end of the file gives the chunks and the number of messages in each. The index behind each chunk is
// read when the messages of a topic are wanted. A bag that was not closed has no index at its end; then its records are
// gone through, and only chunks without an index of their own, or with new connections, are decompressed.
class Ros1Bag : public Bag {
 public:
  // Throws Error{bad_input} where the bytes are no bag of this version. `file` must outlive the bag.
  Ros1Bag(Bytes file, const std::string& name, const Run& run);

  std::vector<BagMessage> index(std::size_t topic, const Run& run) const override;
  Bytes read(const BagMessage& message) const override;

 private:
  struct Record {
    Bytes header, data;
    std::size_t begin = 0, end = 0;  // in the bytes that it was read from
    bool whole = false;
  };
  struct Chunk {
    std::uint32_t part = 0;  // in chunks_
    std::size_t begin = 0;
    std::size_t index_at = 0, index_end = 0;         // the records behind it
    std::map<std::uint32_t, std::int64_t> messages;  // by connection
  };

  static Record record_at(Bytes bytes, std::size_t at);
  static Bytes field(Bytes header, std::string_view name);
  template <class T>
  static std::optional<T> number(Bytes header, std::string_view name);
  static int operation(const Record& record);

  bool bound_indices(std::size_t end);
  bool is_unfinished(const Record& record) const;
  bool read_index(std::uint64_t position);
  void scan(const Run& run);
  void scan_chunk(Chunk& chunk);
  std::optional<Chunk> open_chunk(const Record& record);
  void add_connection(const Record& record);
  // Calls visit(connection, message) for each entry of the index behind a chunk, or of its content. False: no index.
  template <class Visit>
  bool visit_index(const Chunk& chunk, Visit&& visit) const;
  template <class Visit>
  void visit_content(const Chunk& chunk, Visit&& visit) const;

  Bytes file_;
  std::string name_;
  ChunkStore store_;
  std::vector<Chunk> chunks_;
  std::map<std::uint32_t, std::size_t> topic_of_connection_;
};

}  // namespace bole::io
