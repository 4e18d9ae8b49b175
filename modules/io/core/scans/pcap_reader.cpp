#include "io/core/scans/pcap_reader.h"

#include <pcap/pcap.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>

#include "base/error.h"

namespace bole::io {
namespace {

constexpr std::size_t buffer_bytes = 1 << 18;

// The packet behind the link header, or nothing where it is not IP.
std::optional<Bytes> ip_packet(Bytes frame, int link_type) {
  std::size_t type_at = 0, header = 0;
  switch (link_type) {
    case DLT_EN10MB:
      type_at = 12;
      header = 14;
      break;
    case DLT_LINUX_SLL:
      type_at = 14;
      header = 16;
      break;
    case DLT_LINUX_SLL2:
      type_at = 0;
      header = 20;
      break;
    case DLT_NULL:
    case DLT_LOOP:
      return frame.size() > 4 ? std::optional(frame.subspan(4)) : std::nullopt;
    default:
      return frame;
  }
  if (frame.size() < header) return std::nullopt;
  std::uint16_t type = big16(frame, type_at);
  while ((type == 0x8100 || type == 0x88A8) && frame.size() >= header + 4) {  // VLAN tags
    type = big16(frame, header + 2);
    header += 4;
  }
  if (type != 0x0800 && type != 0x86DD) return std::nullopt;
  return frame.subspan(header);
}

enum class Kind { udp, fragment, fragment_of_ipv6, other };

Kind udp_of(Bytes packet, Bytes& udp) {
  if (packet.size() < 20) return Kind::other;
  const int version = packet[0] >> 4;
  std::size_t header = 40;
  if (version == 4) {
    header = static_cast<std::size_t>(packet[0] & 0x0F) * 4;
    if (header < 20 || packet.size() < header || packet[9] != 17) return Kind::other;
    if ((big16(packet, 6) & 0x3FFF) != 0) {
      udp = packet;
      return Kind::fragment;
    }
    const std::size_t length = big16(packet, 2);
    if (length >= header && length < packet.size()) packet = packet.first(length);  // Ethernet padding
  } else if (version == 6) {
    if (packet.size() < header) return Kind::other;
    if (packet[6] == 44) return Kind::fragment_of_ipv6;
    if (packet[6] != 17) return Kind::other;
  } else {
    return Kind::other;
  }
  udp = packet.subspan(header);
  return udp.size() >= 8 ? Kind::udp : Kind::other;
}

}  // namespace

void PcapReader::Close::operator()(pcap* handle) const { pcap_close(handle); }

PcapReader::PcapReader(const std::filesystem::path& path) {
  // A pipe would make the opening wait for a writer, for ever.
  std::error_code ignored;
  const auto kind = std::filesystem::status(path, ignored);
  if (std::filesystem::exists(kind) && !std::filesystem::is_regular_file(kind))
    throw bad_input("'" + path.string() + "' is not a file", "a pcap file");
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr)
    throw bad_input("'" + path.string() + "' cannot be opened: " + std::strerror(errno),
                    "a pcap file that exists and may be read");
  const auto bytes = std::filesystem::file_size(path, ignored);
  bytes_ = ignored ? 0 : static_cast<double>(bytes);
  open(file, path.string());
}

PcapReader::PcapReader(Bytes capture, const std::string& name) {
  std::FILE* file =
      capture.empty() ? nullptr : ::fmemopen(const_cast<std::uint8_t*>(capture.data()), capture.size(), "rb");
  if (file == nullptr) throw bad_input("'" + name + "' is empty", "a pcap or pcapng capture");
  bytes_ = static_cast<double>(capture.size());
  open(file, name);
}

void PcapReader::open(std::FILE* file, const std::string& name) {
  std::array<char, PCAP_ERRBUF_SIZE> message{};
  std::setvbuf(file, nullptr, _IOFBF, buffer_bytes);
  handle_.reset(pcap_fopen_offline_with_tstamp_precision(file, PCAP_TSTAMP_PRECISION_NANO, message.data()));
  if (!handle_) {
    std::fclose(file);
    throw bad_input("'" + name + "' is not a capture: " + message.data(), "a pcap or pcapng file");
  }
  link_type_ = pcap_datalink(handle_.get());
  constexpr std::array known{DLT_EN10MB, DLT_LINUX_SLL, DLT_LINUX_SLL2, DLT_NULL,
                             DLT_LOOP,   DLT_RAW,       DLT_IPV4,       DLT_IPV6};
  for (const int type : known)
    if (type == link_type_) return;
  const char* description = pcap_datalink_val_to_description(link_type_);
  throw bad_input("'" + name + "' was captured on a link of type " +
                      (description != nullptr ? std::string(description) : std::to_string(link_type_)),
                  "Ethernet, Linux cooked capture, loopback or raw IP");
}

bool PcapReader::next(Datagram& datagram, const std::function<void(std::int64_t)>& poll) {
  constexpr std::int64_t packets_between_polls = 512;
  pcap_pkthdr* header = nullptr;
  const u_char* data = nullptr;
  while (true) {
    datagram.offset = position();
    if (++packets_ % packets_between_polls == 0 && poll) poll(datagram.offset);
    const int outcome = pcap_next_ex(handle_.get(), &header, &data);
    if (outcome != 1) {
      pieces_.drop_all();
      fragments_ = fragments_of_ipv6_ + pieces_.lost();
      if (outcome == PCAP_ERROR_BREAK) return false;  // the end
      trouble_ = pcap_geterr(handle_.get());
      trouble_at_ = datagram.offset;
      return false;
    }
    const auto packet = ip_packet({data, header->caplen}, link_type_);
    Bytes udp;
    const Kind kind = packet ? udp_of(*packet, udp) : Kind::other;
    if (kind == Kind::fragment) {
      auto whole = pieces_.add(udp, datagram.offset);
      fragments_ = fragments_of_ipv6_ + pieces_.lost();
      if (!whole || whole->udp.size() < 8) continue;
      joined_ = std::move(whole->udp);
      datagram.offset = whole->offset;
      udp = joined_;
    } else if (kind != Kind::udp) {
      if (kind == Kind::fragment_of_ipv6) {
        ++fragments_of_ipv6_;
        ++fragments_;
      }
      ++skipped_;
      continue;
    }
    const std::size_t length = big16(udp, 4);
    datagram.port = big16(udp, 2);
    datagram.payload = udp.subspan(8);
    if (length >= 8 && length - 8 < datagram.payload.size()) datagram.payload = datagram.payload.first(length - 8);
    // Nanoseconds, as asked for above.
    datagram.time_s = static_cast<double>(header->ts.tv_sec) + 1e-9 * static_cast<double>(header->ts.tv_usec);
    return true;
  }
}

void PcapReader::seek(std::int64_t offset) {
  pieces_.clear();
  ::fseeko(pcap_file(handle_.get()), offset, SEEK_SET);
}

std::int64_t PcapReader::position() const { return ::ftello(pcap_file(handle_.get())); }

}  // namespace bole::io
