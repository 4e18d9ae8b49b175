// What is said of a recording of packets that cannot be read to its end.
#pragma once

#include <cstdint>

#include "base/report.h"
#include "io/core/scans/datagrams.h"

namespace bole::io {

// A recorder that was switched off cuts the last packet; more than that is a damaged file. Fragments that do not become
// whole are said too.
void note_damage(const DatagramReader& reader, std::int64_t data_packets, Report& report);

}  // namespace bole::io
