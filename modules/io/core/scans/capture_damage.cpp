#include "io/core/scans/capture_damage.h"

#include <string>

#include "base/verdict.h"
#include "io/core/scans/beside_capture.h"

namespace bole::io {

void note_damage(const DatagramReader& reader, std::int64_t data_packets, Report& report) {
  constexpr double whole_enough = 0.99;
  if (reader.fragments() > 0)
    report.warn(plural(reader.fragments(), "IP fragment") + " of datagrams that are not whole were skipped");
  if (reader.trouble().empty()) return;
  const auto text = "the capture is cut off or damaged after " + plural(data_packets, "data packet") + " (" +
                    reader.trouble() + "): the frames before that are read";
  const double share = reader.end() > 0 ? static_cast<double>(reader.trouble_at()) / reader.end() : 1;
  if (share >= whole_enough) return report.find(Severity::look, "input_damaged", text);
  report.find(Severity::refused, finding_code::input_incomplete,
              text + " (" + std::to_string(static_cast<int>(100 * share)) + " % of the file)");
}

}  // namespace bole::io
