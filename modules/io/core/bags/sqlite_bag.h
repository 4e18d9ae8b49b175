// Files of ROS 2 with messages in an SQLite database (.db3).
#pragma once

#include "io/core/bags/bag.h"

struct sqlite3;
struct sqlite3_stmt;

namespace bole::io {

class SqliteBag : public Bag {
 public:
  // Throws Error{bad_input} where the database cannot be opened or holds no recording.
  SqliteBag(const std::filesystem::path& path, const Run& run);
  SqliteBag(Bytes file, const std::string& name, const Run& run);

  std::vector<BagMessage> index(std::size_t topic, const Run& run) const override;
  // Messages that were compressed one by one are decompressed.
  Bytes read(const BagMessage& message) const override;

 private:
  struct CloseDatabase {
    void operator()(sqlite3* database) const;
  };
  struct CloseStatement {
    void operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, CloseStatement>;

  Statement prepare(const char* sql) const;
  void accept_cut_file(Bytes head, std::uint64_t file_bytes);
  void protect() const;
  void read_tables(const Run& run);

  std::string name_;
  std::unique_ptr<sqlite3, CloseDatabase> database_;
  Statement read_message_;
  std::vector<std::vector<BagMessage>> messages_;  // by topic
  mutable std::vector<std::uint8_t> decompressed_;
};

}  // namespace bole::io
