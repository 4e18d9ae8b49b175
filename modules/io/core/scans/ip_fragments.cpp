#include "io/core/scans/ip_fragments.h"

#include <algorithm>

#include "io/core/scans/datagrams.h"

namespace bole::io {
namespace {

constexpr std::size_t max_partial = 16;  // datagrams at a time; each holds 64 KiB at most

}  // namespace

void IpFragments::drop(std::map<Key, Partial>::iterator entry) {
  lost_ += static_cast<std::int64_t>(entry->second.pieces.size());
  partial_.erase(entry);
}

void IpFragments::drop_all() {
  while (!partial_.empty()) drop(partial_.begin());
}

std::optional<IpFragments::Whole> IpFragments::add(Bytes packet, std::int64_t offset) {
  const std::size_t header = static_cast<std::size_t>(packet[0] & 0x0F) * 4;
  const std::size_t declared = big16(packet, 2);
  if (declared > packet.size() || declared <= header) {
    ++lost_;  // cut by the length limit of the capture
    return {};
  }
  const auto piece = packet.subspan(header, declared - header);
  const std::size_t at = (std::size_t{big16(packet, 6)} & 0x1FFF) * 8;
  const bool more = (packet[6] & 0x20) != 0;
  Key key;
  std::copy_n(packet.begin() + 12, 8, key.begin());
  std::copy_n(packet.begin() + 4, 2, key.begin() + 8);
  key[10] = packet[9];

  auto entry = partial_.find(key);
  if (entry != partial_.end() && entry->second.pieces.contains(at)) {  // the number came round again
    drop(entry);
    entry = partial_.end();
  }
  if (entry == partial_.end()) {
    if (partial_.size() == max_partial)
      drop(std::ranges::min_element(partial_, {}, [](const auto& p) { return p.second.offset; }));
    entry = partial_.emplace(key, Partial{offset, 0, {}}).first;
  }
  auto& partial = entry->second;
  partial.pieces[at].assign(piece.begin(), piece.end());
  if (!more) partial.total = at + piece.size();
  if (partial.total == 0) return {};
  std::size_t end = 0;
  for (const auto& [begin, bytes] : partial.pieces) {
    if (begin != end) return {};
    end += bytes.size();
  }
  if (end != partial.total) return {};
  Whole whole{partial.offset, {}};
  whole.udp.reserve(end);
  for (const auto& [begin, bytes] : partial.pieces) whole.udp.insert(whole.udp.end(), bytes.begin(), bytes.end());
  partial_.erase(entry);
  return whole;
}

}  // namespace bole::io
