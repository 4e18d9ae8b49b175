// Reads the UDP datagrams of a pcap or pcapng file (libpcap) in order, or from a given record.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "io/core/bytes/mapped_file.h"

struct pcap;

namespace bole::io {

struct Datagram {
  double time_s = 0;                      // capture time, seconds since the Unix epoch
  std::int64_t offset = 0;                // of its record in the file, for PcapReader::seek
  std::uint16_t port = 0;                 // UDP destination port
  std::span<const std::uint8_t> payload;  // valid until the next call
};

class PcapReader {
 public:
  // Throws Error{bad_input} where the file cannot be opened, is not a capture, or has a link type without IP packets.
  explicit PcapReader(const std::filesystem::path& path);
  // The same of a buffer, which must outlive the reader.
  PcapReader(Bytes capture, const std::string& name);

  // The next whole UDP datagram over Ethernet (also with VLAN tags), Linux cooked capture, loopback or raw IP, IPv4 or
  // IPv6. Fragments and other packets are skipped and counted. False at the end and where the file is cut off or
  // damaged; then trouble() gives the reason. `poll` is called with the byte position after every 512 packets, and it
  // may throw.
  bool next(Datagram& datagram, const std::function<void(std::int64_t)>& poll = {});

  // Continues at a record whose offset next() has given.
  void seek(std::int64_t offset);

  std::int64_t position() const;  // bytes read so far
  std::int64_t skipped() const { return skipped_; }
  std::int64_t fragments() const { return fragments_; }
  const std::string& trouble() const { return trouble_; }  // empty when the file ended as it should
  std::int64_t trouble_at() const { return trouble_at_; }  // the place of the first record that cannot be read

 private:
  struct Close {
    void operator()(pcap* handle) const;
  };
  void open(std::FILE* file, const std::string& name);

  std::unique_ptr<pcap, Close> handle_;
  int link_type_ = 0;
  std::int64_t packets_ = 0, skipped_ = 0, fragments_ = 0;
  std::string trouble_;
  std::int64_t trouble_at_ = 0;
};

}  // namespace bole::io
