// cloud_reading FILE [BOUNDS [RESOLUTION]]: reads a cloud as `bole run` does and prints what it took: points, seconds
// on the clock and of the processors, peak memory, and a hash of coordinates and columns to compare programs by. BOUNDS
// as in the option bounds, "-" for all.
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <span>
#include <string>
#include <variant>

#include "base/content_hash.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/core/clouds/cloud_reader.h"

namespace {

using namespace bole;

double processor_s() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Memory of its own that the process has now, without pages of files.
double own_mib() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
    if (line.starts_with("RssAnon:")) return std::stod(line.substr(8)) / 1024;
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2 || argc > 4) {
    std::puts("cloud_reading FILE [BOUNDS [RESOLUTION]]");
    return 2;
  }
  io::CloudReadOptions options;
  if (argc > 2 && std::string(argv[2]) != "-") options.bounds = argv[2];
  if (argc > 3) options.resolution = std::stod(argv[3]);
  const auto start = std::chrono::steady_clock::now();
  const auto reading = io::read_cloud(argv[1], options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const double processor = processor_s(), peak = peak_resident_mib(), own = own_mib();
  const auto& cloud = reading.cloud;
  ContentHash hash;
  hash.add_bytes(std::as_bytes(std::span(cloud.positions())));
  hash.add_bytes(std::as_bytes(std::span(cloud.origin.data(), 3)));
  for (const auto& [name, column] : cloud.columns()) {
    hash.add_text(name);
    std::visit([&](const auto& values) { hash.add_bytes(std::as_bytes(std::span(values))); }, *column);
  }
  fmt::print("{} points, {:.2f} s, processor time {:.2f} s, at most {:.0f} MiB of memory, {:.0f} MiB kept, hash {}\n",
             cloud.size(), seconds.count(), processor, peak, own, hash.hex());
  for (const auto& finding : reading.report.findings) fmt::print("  {}\n", finding.text);
  for (const auto& warning : reading.report.warnings) fmt::print("  {}\n", warning);
  return 0;
} catch (const bole::Error& e) {
  fmt::print(stderr, "cloud_reading: {}\n", e.what());
  return 1;
}
