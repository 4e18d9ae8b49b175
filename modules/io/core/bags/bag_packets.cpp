#include "io/core/bags/bag_packets.h"

#include <algorithm>

#include "base/error.h"
#include "base/file_pages.h"

namespace bole::io {
namespace {
constexpr int packet_bits = 16;  // of an offset; above them is the number of the message
}

BagPackets::BagPackets(std::shared_ptr<const Bag> bag, const std::vector<std::size_t>& topics, const Run& run)
    : bag_(std::move(bag)) {
  for (const auto topic : topics)
    for (const auto& message : bag_->index(topic, run)) messages_.push_back({message, topic});
  std::ranges::stable_sort(messages_, {}, [](const Place& p) { return p.message.time_ns; });
}

double BagPackets::end() const {
  return static_cast<double>(static_cast<std::int64_t>(messages_.size()) << packet_bits);
}

void BagPackets::seek(std::int64_t offset) {
  const auto message = static_cast<std::size_t>(offset >> packet_bits);
  loaded_ = loaded_ && message == message_;
  message_ = message;
  packet_ = static_cast<std::size_t>(offset & ((1 << packet_bits) - 1));
}

// The content is copied, because a packet must outlive the next call of the bag, which another reader may make.
void BagPackets::load() {
  const auto& place = messages_[message_];
  const auto& topic = bag_->topics()[place.topic];
  const auto bytes = bag_->read(place.message);
  content_.assign(bytes.begin(), bytes.end());
  leave_memory(bytes.data(), bytes.size());
  packets_.clear();
  loaded_ = true;
  if (topic.type == message_type::velodyne)
    parse_velodyne_scan(content_, topic.encoding, packets_);
  else
    packets_.push_back({place.message.time_ns, parse_ouster_packet(content_, topic.encoding)});
}

bool BagPackets::next(Datagram& datagram, const std::function<void(std::int64_t)>& poll) {
  while (message_ < messages_.size()) {
    const auto place = static_cast<std::int64_t>(message_) << packet_bits;
    if (!loaded_) {
      if (poll) poll(place);
      try {
        load();
      } catch (const Error& e) {
        if (e.kind() != ErrorKind::bad_input) throw;
        damage_ = e.found();
        ++damaged_messages_;
        packets_.clear();
      }
    }
    if (packet_ < packets_.size()) {
      const auto& packet = packets_[packet_];
      datagram.time_s = 1e-9 * static_cast<double>(packet.time_ns);
      datagram.offset = place + static_cast<std::int64_t>(packet_);
      datagram.port = 0;
      datagram.payload = packet.bytes;
      ++packet_;
      return true;
    }
    ++message_;
    packet_ = 0;
    loaded_ = false;
  }
  return false;
}

}  // namespace bole::io
