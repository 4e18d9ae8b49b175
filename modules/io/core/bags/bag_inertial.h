// The measurements of an inertial unit in a bag (sensor_msgs/Imu).
#pragma once

#include <memory>

#include "base/report.h"
#include "cloud/inertial.h"
#include "io/core/bags/bag.h"

namespace bole::io {

// A few messages are looked at when the bag is opened, to find the unit of the accelerations; all are read when they
// are asked for.
class BagInertial {
 public:
  // Throws Error{bad_input} where none of the sampled messages can be read.
  BagInertial(std::shared_ptr<const Bag> bag, std::size_t topic, const Run& run, Report& report);

  const InertialRecord* record() const;
  double first_s() const { return first_s_; }  // stamp of the first message
  double last_s() const { return last_s_; }

 private:
  InertialSample sample(const BagMessage& message) const;

  std::shared_ptr<const Bag> bag_;
  BagTopic topic_;
  std::vector<BagMessage> messages_;
  bool stamped_ = true;           // else the recording times count
  double acceleration_unit_ = 1;  // m/s2
  double first_s_ = 0, last_s_ = 0;
  mutable std::unique_ptr<InertialRecord> record_;
};

}  // namespace bole::io
