#pragma once

namespace bole {
inline namespace base {

// The most memory that this process has held so far, in MiB.
double peak_resident_mib();

}  // namespace base
}  // namespace bole
