#include "io/core/scans/calibration_beside.h"

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "io/core/scans/beside_capture.h"
#include "sensor/core/velodyne_calibration.h"

namespace bole::io {
namespace {

bool is_calibration(const std::filesystem::path& path) {
  return sensor::may_be_velodyne_calibration(path) &&
         sensor::is_velodyne_calibration(small_file_text(path, sensor::max_velodyne_calibration_bytes));
}

// The calibrations that lie beside a capture: the one with its name, or all in its folder.
std::vector<std::filesystem::path> calibrations_beside(const std::filesystem::path& capture) {
  for (const char* ending : {".xml", ".yaml", ".yml"}) {
    auto same_name = capture;
    same_name.replace_extension(ending);
    if (is_calibration(same_name)) return {same_name};
  }
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  if (!std::filesystem::exists(capture, ignored)) return {};
  const auto folder = capture.parent_path().empty() ? std::filesystem::path(".") : capture.parent_path();
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (is_calibration(entry.path())) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

}  // namespace

std::optional<sensor::SensorModel> calibration_beside(const std::filesystem::path& capture,
                                                      const sensor::SensorModel& nominal,
                                                      std::optional<sensor::SensorModel>& foreign) {
  std::optional<sensor::SensorModel> own;
  for (const auto& file : calibrations_beside(capture)) {
    auto model = sensor::load_sensor_model(file.string());
    if (model.id != nominal.id) {
      foreign = std::move(model);
    } else if (own) {
      throw bad_input("several calibrations of a " + nominal.name + " lie beside the capture: '" +
                          own->file.filename().string() + "', '" + file.filename().string() + "'",
                      "one", "Give it the name of the capture, or name it with the option sensor");
    } else {
      own = std::move(model);
    }
  }
  return own;
}

}  // namespace bole::io
