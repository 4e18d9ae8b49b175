// Puts the fragments of IPv4 datagrams together: packets of more than about 1500 bytes (Ouster) travel in pieces.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "io/core/bytes/mapped_file.h"

namespace bole::io {

class IpFragments {
 public:
  struct Whole {
    std::int64_t offset = 0;  // of the record of its first piece in the file
    std::vector<std::uint8_t> udp;
  };

  // Takes an IPv4 packet that is a fragment, from the record at `offset`. Gives the datagram when it is the last piece.
  std::optional<Whole> add(Bytes packet, std::int64_t offset);

  void clear() { partial_.clear(); }
  void drop_all();                             // at the end of the recording
  std::int64_t lost() const { return lost_; }  // fragments of datagrams that never became whole

 private:
  using Key = std::array<std::uint8_t, 11>;  // source, destination, identification, protocol
  struct Partial {
    std::int64_t offset = 0;
    std::size_t total = 0;  // 0 until the last piece is there
    std::map<std::size_t, std::vector<std::uint8_t>> pieces;
  };
  void drop(std::map<Key, Partial>::iterator entry);

  std::map<Key, Partial> partial_;
  std::int64_t lost_ = 0;
};

}  // namespace bole::io
