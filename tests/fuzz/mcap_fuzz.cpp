// An MCAP file from memory.
#include "fuzz_bag.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  testing_bags::McapWriter writer;
  write_seed(folder, "clouds", writer.write(bag_messages(testing_bags::Wire::cdr_little, false)));
  writer.message_indices = false;
  write_seed(folder, "plain", writer.write(bag_messages(testing_bags::Wire::cdr_big, false)));
  writer.summary = false;
  write_seed(folder, "open", writer.write(bag_messages(testing_bags::Wire::cdr_little, true)));
  writer.messages_per_chunk = 0;
  writer.encoding = "ros1";
  write_seed(folder, "loose", writer.write(bag_messages(testing_bags::Wire::ros1, true)));
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (!bole::io::is_mcap({data, size})) return 0;
  bole::fuzz::allow_bad_input([&] { bole::fuzz::read_bag(bole::io::open_bag({data, size}, "fuzz")); });
  return 0;
}
