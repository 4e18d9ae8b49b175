#include "io/core/bags/sqlite_bag.h"

#include <sqlite3.h>

#include <algorithm>
#include <map>

#include "base/error.h"
#include "io/core/bags/chunk_store.h"

namespace bole::io {
namespace {

// The path as SQLite's address: characters with a meaning there are written as numbers.
std::string address(const std::filesystem::path& path, bool immutable) {
  std::string out = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    if (c == '?' || c == '#' || c == '%')
      out += {'%', digits[byte / 16], digits[byte % 16]};
    else
      out += c;
  }
  return out + "?mode=ro" + (immutable ? "&immutable=1" : "");
}

std::string_view column_text(sqlite3_stmt* statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
  return text == nullptr ? std::string_view{} : text;
}

}  // namespace

bool is_sqlite(Bytes file) {
  return std::string_view(reinterpret_cast<const char*>(file.data()), file.size())
      .starts_with(std::string_view("SQLite format 3\0", 16));
}

void SqliteBag::CloseDatabase::operator()(sqlite3* database) const { sqlite3_close_v2(database); }
void SqliteBag::CloseStatement::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

SqliteBag::SqliteBag(const std::filesystem::path& path, const Run& run) : name_(path.filename().string()) {
  // A log beside the file holds messages that are not in it yet. Without one nothing is locked or written beside it.
  std::error_code ignored;
  const auto log_bytes = std::filesystem::file_size(path.string() + "-wal", ignored);
  bool has_log = !ignored && log_bytes > 0;
  sqlite3* database = nullptr;
  int status =
      sqlite3_open_v2(address(path, !has_log).c_str(), &database, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  database_.reset(database);
  protect();
  if (status == SQLITE_OK && has_log && !prepare("SELECT 1 FROM messages LIMIT 1")) {
    note_damage(
        "the log '" + path.filename().string() +
        "-wal' cannot be read: its messages are missing. Copy the recording to a folder that may be written to");
    status = sqlite3_open_v2(address(path, true).c_str(), &database, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    database_.reset(database);
    protect();
    has_log = false;
  }
  if (status != SQLITE_OK)
    throw bad_input("'" + path.string() + "' cannot be opened: " + sqlite3_errstr(status), "an SQLite database",
                    "Copy it to a folder of your own that may be read");
  // The log may hold pages that the file lacks.
  if (!has_log) {
    const MappedFile file(path);
    accept_cut_file(file.bytes(), file.bytes().size());
  }
  read_tables(run);
}

SqliteBag::SqliteBag(Bytes file, const std::string& name, const Run& run) : name_(name) {
  sqlite3* database = nullptr;
  const int opened = sqlite3_open_v2(":memory:", &database, SQLITE_OPEN_READWRITE, nullptr);
  database_.reset(database);
  const auto size = static_cast<sqlite3_int64>(file.size());
  if (opened != SQLITE_OK || sqlite3_deserialize(database, "main", const_cast<std::uint8_t*>(file.data()), size, size,
                                                 SQLITE_DESERIALIZE_READONLY) != SQLITE_OK)
    throw bad_input("'" + name + "' is no SQLite database", "an SQLite database");
  protect();
  accept_cut_file(file, file.size());
  read_tables(run);
}

SqliteBag::Statement SqliteBag::prepare(const char* sql) const {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database_.get(), sql, -1, &statement, nullptr) != SQLITE_OK) return {};
  return Statement(statement);
}

// SQLite refuses a file that is shorter than its header says, unless it is told to make the best of it.
void SqliteBag::accept_cut_file(Bytes head, std::uint64_t file_bytes) {
  constexpr std::size_t page_bytes_at = 16, pages_at = 28;
  if (head.size() < pages_at + 4) return;
  const auto big_endian = [&](std::size_t at, int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | head[at + static_cast<std::size_t>(i)];
    return value;
  };
  const auto page_bytes = big_endian(page_bytes_at, 2) == 1 ? 65536 : big_endian(page_bytes_at, 2);
  const auto declared = page_bytes * big_endian(pages_at, 4);
  if (declared <= file_bytes) return;
  lost_share_ = 1 - static_cast<double>(file_bytes) / static_cast<double>(declared);
  sqlite3_exec(database_.get(), "PRAGMA writable_schema=ON", nullptr, nullptr, nullptr);
}

// A database that somebody made up must not run its own code, nor give rows without end.
void SqliteBag::protect() const {
  if (!database_) return;
  sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
}

void SqliteBag::read_tables(const Run& run) {
  const auto topics = prepare("SELECT id, name, type, serialization_format FROM topics ORDER BY id");
  const auto messages = prepare("SELECT id, topic_id, timestamp FROM messages");
  read_message_ = prepare("SELECT data FROM messages WHERE id = ?");
  if (!topics || !messages || !read_message_)
    throw bad_input("'" + name_ + "' is no recording of ROS 2 (" + sqlite3_errmsg(database_.get()) + ")",
                    "a database with the tables topics and messages");
  std::map<std::int64_t, std::size_t> topic_of_id;
  while (sqlite3_step(topics.get()) == SQLITE_ROW) {
    const auto format = column_text(topics.get(), 3);
    const auto encoding = format == "cdr" ? MessageEncoding::cdr : MessageEncoding::other;
    topic_of_id[sqlite3_column_int64(topics.get(), 0)] =
        topic_of(column_text(topics.get(), 1), column_text(topics.get(), 2), encoding);
  }
  messages_.resize(topics_.size());
  std::int64_t rows = 0;
  int status = SQLITE_ROW;
  while ((status = sqlite3_step(messages.get())) == SQLITE_ROW) {
    if (++rows % 4096 == 0) run.check_cancel();
    const auto topic = topic_of_id.find(sqlite3_column_int64(messages.get(), 1));
    if (topic == topic_of_id.end()) continue;
    const auto time_ns = sqlite3_column_int64(messages.get(), 2);
    count(topic->second, 1, time_ns, time_ns);
    messages_[topic->second].push_back(
        {time_ns, 0, 0, static_cast<std::uint64_t>(sqlite3_column_int64(messages.get(), 0))});
  }
  if (status != SQLITE_DONE)
    note_damage("the database is cut off or damaged (" + std::string(sqlite3_errmsg(database_.get())) +
                "): " + std::to_string(rows) + " messages are read");
  for (auto& list : messages_) std::ranges::stable_sort(list, {}, &BagMessage::time_ns);
}

std::vector<BagMessage> SqliteBag::index(std::size_t topic, const Run&) const { return messages_[topic]; }

Bytes SqliteBag::read(const BagMessage& message) const {
  auto* statement = read_message_.get();
  sqlite3_reset(statement);
  sqlite3_bind_int64(statement, 1, static_cast<sqlite3_int64>(message.offset));
  if (sqlite3_step(statement) != SQLITE_ROW)
    throw bad_input("a message of '" + name_ + "' cannot be read: " + sqlite3_errmsg(database_.get()),
                    "a whole database");
  const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement, 0));
  const Bytes bytes(data, data == nullptr ? 0 : static_cast<std::size_t>(sqlite3_column_bytes(statement, 0)));
  return whole_message(bytes, name_, decompressed_);
}

}  // namespace bole::io
