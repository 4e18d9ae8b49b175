// Whether the poses of the scans of a file say where the scanner stood.
#pragma once

#include <string>
#include <vector>

#include "io/core/clouds/cloud_reader.h"
#include "io/core/e57/e57_description.h"

namespace bole::io::e57 {

class ScanPlaces {
 public:
  ScanPlaces(const std::vector<Scan>& scans, ScanPositions choice);

  // Whether all scans may have a known place; then rows have the place of their scan.
  bool known() const { return known_; }

  // A point of a scan, in its own axes.
  void add(std::size_t scan, const Eigen::Vector3d& local);

  // Takes the places away from the cloud where one of them cannot be, and reports. Whether the cloud has them.
  bool judge(CloudReading& reading) const;

 private:
  // The points of a scan in its own axes.
  struct View {
    Eigen::AlignedBox2d box;
    std::size_t points = 0, far = 0;
  };
  std::string objection(std::size_t scan) const;

  const std::vector<Scan>& scans_;
  ScanPositions choice_;
  bool known_ = false;
  std::vector<View> views_;
};

}  // namespace bole::io::e57
