// A share of a cloud, for programs that deal a file out to several processes.
#pragma once

namespace bole {
inline namespace cloud {

struct Piece {
  int index = 0;
  int count = 1;

  bool is_whole() const { return count <= 1; }
  bool operator==(const Piece&) const = default;
};

}  // namespace cloud
}  // namespace bole
