#pragma once

namespace bole::inline base {

// The most memory that this process has held so far, in MiB.
double peak_resident_mib();

}  // namespace bole::inline base
