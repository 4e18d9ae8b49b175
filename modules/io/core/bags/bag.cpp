#include "io/core/bags/bag.h"

#include <sys/mman.h>

#include <algorithm>

#include "base/error.h"
#include "io/core/bags/bag_folder.h"
#include "io/core/bags/mcap_bag.h"
#include "io/core/bags/ros1_bag.h"
#include "io/core/bags/scratch_copy.h"
#include "io/core/bags/sqlite_bag.h"

namespace bole::io {
namespace {

// "sensor_msgs/msg/PointCloud2" of ROS 2 as "sensor_msgs/PointCloud2".
std::string short_type(std::string_view type) {
  std::string out(type);
  if (const auto at = out.find("/msg/"); at != std::string::npos) out.erase(at, 4);
  return out;
}

// A bag together with the mapped file that it reads.
template <class Inner>
class MappedBag : public Bag {
 public:
  MappedBag(std::unique_ptr<MappedFile> file, const std::string& name, const Run& run)
      : file_(prepared(std::move(file))), inner_(file_->bytes(), name, run) {
    topics_ = inner_.topics();
    lost_share_ = inner_.lost_share();
    for (const auto& text : inner_.damage()) note_damage(text);
  }
  std::vector<BagMessage> index(std::size_t topic, const Run& run) const override {
    auto out = inner_.index(topic, run);
    for (const auto& text : inner_.damage()) note_damage(text);
    return out;
  }
  Bytes read(const BagMessage& message) const override {
    const auto bytes = inner_.read(message);
    for (const auto& text : inner_.damage()) note_damage(text);
    return bytes;
  }

 private:
  // Chunks lie far apart, and only their heads are read at first: reading far ahead would read most of the file.
  static std::unique_ptr<MappedFile> prepared(std::unique_ptr<MappedFile> file) {
    const auto bytes = file->bytes();
    if (!bytes.empty()) ::madvise(const_cast<std::uint8_t*>(bytes.data()), bytes.size(), MADV_NORMAL);
    return file;
  }
  std::unique_ptr<MappedFile> file_;
  Inner inner_;
};

}  // namespace

std::size_t Bag::topic_of(std::string_view name, std::string_view type, MessageEncoding encoding) {
  const auto wanted = short_type(type);
  const auto found = std::ranges::find_if(
      topics_, [&](const BagTopic& t) { return t.name == name && t.type == wanted && t.encoding == encoding; });
  if (found != topics_.end()) return static_cast<std::size_t>(found - topics_.begin());
  topics_.push_back({std::string(name), wanted, encoding, 0, 0, 0});
  return topics_.size() - 1;
}

void Bag::count(std::size_t topic, std::int64_t messages, std::int64_t first_ns, std::int64_t last_ns) {
  auto& t = topics_[topic];
  if (messages <= 0) return;
  t.first_ns = t.messages == 0 ? first_ns : std::min(t.first_ns, first_ns);
  t.last_ns = t.messages == 0 ? last_ns : std::max(t.last_ns, last_ns);
  t.messages += messages;
}

void Bag::note_damage(const std::string& text) const {
  if (std::ranges::find(damage_, text) == damage_.end()) damage_.push_back(text);
}

void Bag::note_loss(double share, const std::string& text) {
  lost_share_ = std::max(lost_share_, share);
  note_damage(text);
}

namespace {

// `name` is that of the file that somebody chose, where `path` is its content.
std::unique_ptr<Bag> open_file(const std::filesystem::path& path, const std::string& name, bool compressed,
                               const Run& run) {
  auto file = std::make_unique<MappedFile>(path);
  if (is_sqlite(file->bytes())) {
    file.reset();
    return std::make_unique<SqliteBag>(path, run);
  }
  if (is_zstd(file->bytes())) {
    if (compressed)
      throw bad_input("the content of '" + name + "' is compressed again", "a recording compressed once",
                      "Decompress it with zstd -d");
    const ScratchCopy copy(file->bytes(), name, run);
    file.reset();
    auto bag = open_file(copy.path(), name, true, run);  // holds on to the content when the copy's name goes
    if (!copy.damage().empty()) bag->note_loss(copy.lost_share(), copy.damage());
    return bag;
  }
  if (is_mcap(file->bytes())) return std::make_unique<MappedBag<McapBag>>(std::move(file), name, run);
  return std::make_unique<MappedBag<Ros1Bag>>(std::move(file), name, run);
}

}  // namespace

std::unique_ptr<Bag> open_bag(const std::filesystem::path& path, const Run& run) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return std::make_unique<BagFolder>(path, run);
  return open_file(path, path.filename().string(), false, run);
}

std::unique_ptr<Bag> open_bag(Bytes file, const std::string& name, const Run& run) {
  if (is_sqlite(file)) return std::make_unique<SqliteBag>(file, name, run);
  if (is_mcap(file)) return std::make_unique<McapBag>(file, name, run);
  return std::make_unique<Ros1Bag>(file, name, run);
}

}  // namespace bole::io
