// A bag of ROS 1 from memory.
#include "fuzz_bag.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  testing_bags::Ros1Writer writer;
  write_seed(folder, "clouds", writer.write(bag_messages(testing_bags::Wire::ros1, false)));
  writer.closed = false;
  write_seed(folder, "open", writer.write(bag_messages(testing_bags::Wire::ros1, true)));
  writer.chunk_indices = false;
  write_seed(folder, "plain", writer.write(bag_messages(testing_bags::Wire::ros1, true)));
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (!bole::io::is_ros1_bag({data, size})) return 0;
  bole::fuzz::allow_bad_input([&] { bole::fuzz::read_bag(bole::io::open_bag({data, size}, "fuzz")); });
  return 0;
}
