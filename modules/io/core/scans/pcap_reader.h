// Reads the UDP datagrams of a pcap or pcapng file (libpcap) in order, or from a given record.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "io/core/bytes/mapped_file.h"
#include "io/core/scans/datagrams.h"
#include "io/core/scans/ip_fragments.h"

struct pcap;

namespace bole::io {

class PcapReader : public DatagramReader {
 public:
  // Throws Error{bad_input} where the file cannot be opened, is not a capture, or has a link type without IP packets.
  explicit PcapReader(const std::filesystem::path& path);
  // The same of a buffer, which must outlive the reader.
  PcapReader(Bytes capture, const std::string& name);

  // The next whole UDP datagram over Ethernet (also with VLAN tags), Linux cooked capture, loopback or raw IP, IPv4 or
  // IPv6. Fragments of IPv4 are put together. Those of IPv6, those of datagrams that stay incomplete, and other packets
  // are skipped and counted. False at the end and where the file is cut off or damaged; then trouble() gives the
  // reason. `poll` is called with the byte position after every 512 packets, and it may throw.
  bool next(Datagram& datagram, const std::function<void(std::int64_t)>& poll) override;
  using DatagramReader::next;

  void seek(std::int64_t offset) override;
  double end() const override { return bytes_; }

  std::int64_t position() const;  // bytes read so far

 private:
  struct Close {
    void operator()(pcap* handle) const;
  };
  void open(std::FILE* file, const std::string& name);

  std::unique_ptr<pcap, Close> handle_;
  int link_type_ = 0;
  double bytes_ = 0;
  IpFragments pieces_;
  std::vector<std::uint8_t> joined_;  // the datagram of the last call, where it came in fragments
  std::int64_t packets_ = 0, fragments_of_ipv6_ = 0;
};

}  // namespace bole::io
