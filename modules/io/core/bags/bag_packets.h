// The packets of topics of a bag, one after the other, as a capture gives them.
#pragma once

#include <memory>
#include <vector>

#include "io/core/bags/bag.h"
#include "io/core/bags/messages.h"
#include "io/core/scans/datagrams.h"

namespace bole::io {

class BagPackets : public DatagramReader {
 public:
  // Of messages of type velodyne_msgs/VelodyneScan, or of the type PacketMsg of the Ouster drivers: those of all the
  // topics, in order of recording.
  BagPackets(std::shared_ptr<const Bag> bag, const std::vector<std::size_t>& topics, const Run& run);

  bool next(Datagram& datagram, const std::function<void(std::int64_t)>& poll) override;
  using DatagramReader::next;
  void seek(std::int64_t offset) override;
  double end() const override;

  // Messages that could not be read so far, and the last reason.
  std::int64_t damaged_messages() const { return damaged_messages_; }
  const std::string& damage() const { return damage_; }

 private:
  struct Place {
    BagMessage message;
    std::size_t topic = 0;
  };
  void load();

  std::shared_ptr<const Bag> bag_;
  std::vector<Place> messages_;
  std::size_t message_ = 0, packet_ = 0;  // the next one
  std::vector<std::uint8_t> content_;     // of that message
  std::vector<StampedPacket> packets_;    // in it
  bool loaded_ = false;
  std::int64_t damaged_messages_ = 0;
  std::string damage_;
};

}  // namespace bole::io
