// A recording of ROS 2 as a folder: metadata.yaml and one or more files, the later ones continuing the earlier.
#pragma once

#include "io/core/bags/bag.h"

namespace bole::io {

class BagFolder : public Bag {
 public:
  // Throws Error{bad_input} where the folder holds no file of a recording, or none that can be opened.
  BagFolder(const std::filesystem::path& folder, const Run& run);

  std::vector<BagMessage> index(std::size_t topic, const Run& run) const override;
  Bytes read(const BagMessage& message) const override;

 private:
  struct File {
    std::filesystem::path name;
    std::unique_ptr<Bag> bag;
    std::vector<std::size_t> topics;  // of this bag, by the topic of the file
  };
  void open(const std::filesystem::path& folder, const std::filesystem::path& name, const Run& run);
  void refuse_separate_walks(const std::filesystem::path& folder) const;
  void forward_damage(const File& file) const;

  std::vector<File> files_;
  double expected_bytes_ = 0, lost_bytes_ = 0;
};

// The files that a metadata.yaml lists, in its order, and the number of messages that it declares (-1: none).
struct BagMetadata {
  std::vector<std::string> files;
  std::int64_t messages = -1;
};
BagMetadata parse_bag_metadata(std::string_view text);

}  // namespace bole::io
