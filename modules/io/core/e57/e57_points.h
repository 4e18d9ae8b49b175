// The points of one scan: data packets, each with a piece of the stream of every field, decoded in blocks of records.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/core/e57/e57_description.h"
#include "io/core/e57/e57_pages.h"

namespace bole::io::e57 {

struct Block {
  std::size_t count = 0;
  std::vector<std::vector<double>> values;  // by field of the scan
  std::vector<std::uint8_t> damaged;        // 1 where a value of the record lies in a damaged page
};

class PointReader {
 public:
  PointReader(Pages& pages, const Scan& scan);

  // The next records; false where there are no more. Streams go on from packet to packet, so that a page with a wrong
  // checksum costs the records in it alone, and a packet whose own header lies in such a page the rest of the scan.
  bool next(Block& block);

  std::uint64_t decoded() const { return decoded_; }
  const std::string& problem() const { return problem_; }  // why it ended early; empty where it did not

 private:
  struct Stream {
    std::vector<std::uint8_t> bytes;                           // from the one with the next bit on
    unsigned bit = 0;                                          // of the next value in the first byte
    unsigned bits = 0;                                         // of a value
    std::uint64_t gone = 0;                                    // bytes of the stream before those
    std::vector<std::pair<std::uint64_t, std::uint64_t>> bad;  // bytes [first, second) of the stream, ascending
  };

  bool open();
  bool read_packet();
  bool take_streams(const std::vector<std::uint8_t>& packet, std::uint64_t begin);
  std::uint64_t ready() const;
  void decode(const Field& field, Stream& stream, std::size_t count, std::vector<double>& values,
              std::vector<std::uint8_t>& damaged);
  bool fail(std::string problem);

  Pages& pages_;
  const Scan& scan_;
  std::vector<Stream> streams_;
  std::uint64_t at_ = 0, end_ = 0;  // logical: next packet, end of the section
  std::uint64_t decoded_ = 0;
  std::string problem_;
};

}  // namespace bole::io::e57
