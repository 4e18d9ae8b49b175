// LVX and LVX2 files, written from the maker's "LVX Specifications" v1.1 and "LVX2 Specifications" v2.0: the tests do
// not use the tables of the reader.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace bole::testing_lvx {

inline void put(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
}

inline void put_float(std::string& out, float value) {
  char bytes[4];
  std::memcpy(bytes, &value, 4);
  out.append(bytes, 4);
}

struct Device {
  std::uint32_t id = 0;
  int type = 7;  // Avia
  bool placed = false;
  float roll_deg = 0, pitch_deg = 0, yaw_deg = 0, x_m = 0, y_m = 0, z_m = 0;
};

class File {
 public:
  File(bool lvx2, const std::vector<Device>& devices) : lvx2_(lvx2) {
    bytes_ = "livox_tech";
    bytes_.append(6, '\0');
    put(bytes_, lvx2 ? 2 : 1, 1);
    put(bytes_, lvx2 ? 0 : 1, 1);
    put(bytes_, 0, 2);
    put(bytes_, 0xAC0EA767, 4);
    put(bytes_, 50, 4);
    put(bytes_, devices.size(), 1);
    for (const auto& d : devices) {
      bytes_.append(16, 'S');  // serial numbers of the device and the hub
      bytes_.append(16, '\0');
      put(bytes_, d.id, lvx2 ? 4 : 1);
      if (lvx2) put(bytes_, 247, 1);
      put(bytes_, static_cast<std::uint64_t>(d.type), 1);
      put(bytes_, d.placed ? 1 : 0, 1);
      for (const float v : {d.roll_deg, d.pitch_deg, d.yaw_deg, d.x_m, d.y_m, d.z_m}) put_float(bytes_, v);
    }
  }

  // One block of 50 ms from its packages.
  void block(const std::string& packages) {
    const auto at = bytes_.size();
    put(bytes_, at, 8);
    put(bytes_, at + 24 + packages.size(), 8);
    put(bytes_, index_++, 8);
    bytes_ += packages;
  }

  std::string package(std::uint32_t device, std::uint8_t data_type, std::uint64_t time_ns,
                      const std::string& data) const {
    std::string out;
    if (lvx2_) {
      put(out, 0, 1);
      put(out, device, 4);
      put(out, 8, 1);
      put(out, 0, 1);  // no synchronisation
      put(out, time_ns, 8);
      put(out, 5, 2);
      put(out, data_type, 1);
      put(out, data.size(), 4);
      put(out, 0, 1);
      put(out, 0, 4);
    } else {
      put(out, device, 1);
      put(out, 5, 1);
      put(out, 1, 1);
      put(out, 1, 1);
      put(out, 0, 1);
      put(out, 0, 4);
      put(out, 0, 1);
      put(out, data_type, 1);
      put(out, time_ns, 8);
    }
    return out + data;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  bool lvx2_;
  std::string bytes_;
  std::uint64_t index_ = 0;
};

inline std::string cartesian(int x_mm, int y_mm, int z_mm, int reflectivity) {
  std::string out;
  for (const int v : {x_mm, y_mm, z_mm}) put(out, static_cast<std::uint32_t>(v), 4);
  put(out, static_cast<std::uint64_t>(reflectivity), 1);
  return out;
}

inline std::string tagged(const std::string& point, int tag) { return point + static_cast<char>(tag); }

inline std::string times(const std::string& text, int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += text;
  return out;
}

inline std::string inertial(float wx, float wy, float wz, float ax, float ay, float az) {
  std::string out;
  for (const float v : {wx, wy, wz, ax, ay, az}) put_float(out, v);
  return out;
}

}  // namespace bole::testing_lvx
