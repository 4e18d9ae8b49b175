// The messages of a ROS 2 recording. The database itself is SQLite's; what it hands over may be anything.
#include "fuzz_bag.h"

namespace {

// Two scans and a unit: the first byte says of which kind the messages are, the next two where the first one ends.
class Messages : public bole::io::Bag {
 public:
  Messages(const std::uint8_t* data, std::size_t size) {
    constexpr const char* types[] = {"sensor_msgs/msg/PointCloud2", "livox_ros_driver/CustomMsg",
                                     "velodyne_msgs/msg/VelodyneScan", "livox_ros_driver2/msg/CustomMsg"};
    const auto encoding = (data[0] & 4) != 0 ? bole::io::MessageEncoding::ros1 : bole::io::MessageEncoding::cdr;
    const auto cut = std::min<std::size_t>(data[1] + 256U * data[2], size - 3);
    first_ = {data + 3, cut};
    second_ = {data + 3 + cut, size - 3 - cut};
    count(topic_of("/scan", types[data[0] & 3], encoding), 2, 0, 1);
    count(topic_of("/imu", "sensor_msgs/msg/Imu", encoding), 2, 0, 1);
  }
  std::vector<bole::io::BagMessage> index(std::size_t, const bole::Run&) const override {
    return {{0, 0, 0, 0}, {100'000'000, 0, 0, 1}};
  }
  bole::io::Bytes read(const bole::io::BagMessage& message) const override {
    return message.offset == 0 ? first_ : second_;
  }

 private:
  bole::io::Bytes first_, second_;
};

}  // namespace

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  using testing_bags::Wire;
  const auto seed = [&](const char* name, char kind, const std::string& a, const std::string& b) {
    write_seed(folder, name,
               std::string{kind, static_cast<char>(a.size() & 255), static_cast<char>(a.size() >> 8)} + a + b);
  };
  const auto clouds = bag_messages(Wire::cdr_little, false), big = bag_messages(Wire::cdr_big, false),
             old = bag_messages(Wire::ros1, false), livox = bag_messages(Wire::cdr_little, true);
  seed("clouds", '\0', clouds[1].bytes, clouds[3].bytes);
  seed("big", '\0', big[1].bytes, big[3].bytes);
  seed("ros1", '\4', old[1].bytes, old[3].bytes);
  seed("livox", '\1', livox[1].bytes, livox[3].bytes);
  seed("imu", '\0', clouds[0].bytes, clouds[2].bytes);
  const std::string packet = "\xFF\xEE" + std::string(1203, '\1') + "\x22";
  seed("velodyne", '\2', velodyne_message(Wire::cdr_little, 1, {{1, packet}, {2, packet}}),
       velodyne_message(Wire::cdr_little, 2, {{3, packet}}));
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  bole::fuzz::allow_bad_input([&] { bole::fuzz::read_bag(std::make_shared<const Messages>(data, size)); });
  return 0;
}
