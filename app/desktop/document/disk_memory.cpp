#include "document/disk_memory.h"

#include <QSettings>
#include <algorithm>

namespace bole::desktop {
namespace {

const char* const setting = "memory_for_points_mib";

}  // namespace

int disk_memory_mib() { return std::clamp(QSettings().value(setting, default_disk_memory_mib).toInt(), 16, 1 << 20); }

void save_disk_memory_mib(int mib) { QSettings().setValue(setting, mib); }

}  // namespace bole::desktop
