#include "io/core/bags/bag_folder.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"
#include "io/core/bytes/line_reader.h"

namespace bole::io {
namespace {

namespace fs = std::filesystem;

// ".db3", ".mcap", also with ".zstd" behind it.
bool is_bag_file(const fs::path& path) {
  const auto ending = path.extension() == ".zstd" ? path.stem().extension() : path.extension();
  return ending == ".db3" || ending == ".mcap";
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (is_bag_file(entry.path())) files.push_back(entry.path().filename());
  // A compressed file beside its content is the same one.
  const auto all = files;
  std::erase_if(files, [&all](const fs::path& f) {
    return f.extension() == ".zstd" && std::ranges::find(all, f.stem()) != all.end();
  });
  // x_0, x_1, ... x_10: shorter names first.
  std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
    const auto &m = a.native(), &n = b.native();
    return m.size() != n.size() ? m.size() < n.size() : m < n;
  });
  return files;
}

std::string_view unquoted(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front())
    text = text.substr(1, text.size() - 2);
  return text;
}

}  // namespace

bool is_bag_folder(const fs::path& folder) { return !files_in(folder).empty(); }

BagMetadata parse_bag_metadata(std::string_view text) {
  BagMetadata out;
  LineReader lines(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  std::string_view line;
  bool in_files = false;
  while (lines.next(line)) {
    const auto content = trimmed(line);
    if (in_files && content.starts_with("- ")) {
      out.files.emplace_back(unquoted(content.substr(2)));
      continue;
    }
    in_files = content == "relative_file_paths:";
    // The whole recording's count stands two blanks deep; those of topics and files are deeper.
    if (constexpr std::string_view key = "  message_count:"; line.starts_with(key) && out.messages < 0)
      parse_number(trimmed(line.substr(key.size())), out.messages);
  }
  return out;
}

BagFolder::BagFolder(const fs::path& folder, const Run& run) {
  auto names = files_in(folder);
  BagMetadata metadata;
  std::error_code ignored;
  if (const auto path = folder / "metadata.yaml"; fs::is_regular_file(path, ignored)) {
    const MappedFile file(path);
    metadata = parse_bag_metadata({reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()});
  }
  std::vector<fs::path> listed;
  for (const auto& name : metadata.files) {
    // Older recordings list their files with the folder before them, or without the ending of the compression.
    const auto bare = fs::path(name).filename();
    const auto found = std::ranges::find_if(
        names, [&](const fs::path& n) { return n == bare || n == fs::path(bare.string() + ".zstd"); });
    if (found != names.end())
      listed.push_back(*found);
    else
      note_damage("'" + bare.string() + "' is listed in metadata.yaml and is not in the folder");
  }
  if (!listed.empty()) {
    if (listed.size() < names.size())
      note_damage(std::to_string(names.size() - listed.size()) +
                  " files are not listed in metadata.yaml and are left out");
    names = std::move(listed);
  }
  if (names.empty())
    throw bad_input("the folder '" + folder.string() + "' holds no recording of ROS 2", ".db3 or .mcap files");
  for (const auto& name : names) {
    try {
      open(folder, name, run);
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input || names.size() == 1) throw;
      const auto bytes = fs::file_size(folder / name, ignored);
      expected_bytes_ += static_cast<double>(bytes);
      lost_bytes_ += static_cast<double>(bytes);
      note_damage("'" + name.string() + "' cannot be read: " + e.found());
    }
  }
  if (files_.empty())
    throw bad_input("no file of '" + folder.string() + "' can be read: " + damage().back(), "a recording of ROS 2");
  if (expected_bytes_ > 0) lost_share_ = lost_bytes_ / expected_bytes_;
  std::int64_t messages = 0;
  for (const auto& topic : topics_) messages += topic.messages;
  if (metadata.files.empty() && files_.size() > 1) {
    refuse_separate_walks(folder);
    note_damage("there is no metadata.yaml: the " + std::to_string(files_.size()) +
                " files are read as one recording, in order of time");
  }
  if (metadata.messages <= messages) return;
  lost_share_ = std::max(lost_share_, 1 - static_cast<double>(messages) / static_cast<double>(metadata.messages));
  note_damage(std::to_string(metadata.messages - messages) + " of " + std::to_string(metadata.messages) +
              " messages that metadata.yaml declares are missing");
}

void BagFolder::open(const fs::path& folder, const fs::path& name, const Run& run) {
  File file{name, open_bag(folder / name, run), {}};
  forward_damage(file);
  for (const auto& topic : file.bag->topics()) {
    file.topics.push_back(topic_of(topic.name, topic.type, topic.encoding));
    count(file.topics.back(), topic.messages, topic.first_ns, topic.last_ns);
  }
  constexpr double most = 0.999;
  std::error_code ignored;
  const auto held = static_cast<double>(fs::file_size(folder / name, ignored));
  const double whole = held / (1 - std::min(most, file.bag->lost_share()));
  expected_bytes_ += whole;
  lost_bytes_ += whole - held;
  files_.push_back(std::move(file));
}

// Files that one recorder wrote follow each other.
void BagFolder::refuse_separate_walks(const fs::path& folder) const {
  constexpr std::int64_t hour_ns = 3'600'000'000'000;
  std::vector<std::pair<std::int64_t, std::int64_t>> spans;
  for (const auto& file : files_) {
    std::pair span{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()};
    for (const auto& topic : file.bag->topics())
      if (topic.messages > 0) span = {std::min(span.first, topic.first_ns), std::max(span.second, topic.last_ns)};
    if (span.first <= span.second) spans.push_back(span);
  }
  std::ranges::sort(spans);
  for (std::size_t i = 1; i < spans.size(); ++i)
    if (spans[i].first > spans[i - 1].second && spans[i].first - spans[i - 1].second > hour_ns)
      throw bad_input("the files in '" + folder.string() + "' were recorded hours apart, and there is no metadata.yaml",
                      "a folder with the files of one recording", "Open each file by itself");
}

void BagFolder::forward_damage(const File& file) const {
  for (const auto& text : file.bag->damage()) note_damage("'" + file.name.string() + "': " + text);
}

std::vector<BagMessage> BagFolder::index(std::size_t topic, const Run& run) const {
  std::vector<BagMessage> out;
  for (std::size_t f = 0; f < files_.size(); ++f)
    for (std::size_t t = 0; t < files_[f].topics.size(); ++t) {
      if (files_[f].topics[t] != topic) continue;
      for (auto message : files_[f].bag->index(t, run)) {
        message.file = static_cast<std::uint32_t>(f);
        out.push_back(message);
      }
      forward_damage(files_[f]);
    }
  std::ranges::stable_sort(out, {}, &BagMessage::time_ns);
  return out;
}

Bytes BagFolder::read(const BagMessage& message) const {
  const auto& file = files_[message.file];
  const auto bytes = file.bag->read(message);
  forward_damage(file);
  return bytes;
}

}  // namespace bole::io
