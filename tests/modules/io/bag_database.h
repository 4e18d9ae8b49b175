// Recordings of ROS 2 in a database, for tests.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "bag_files.h"

namespace bole::testing_bags {

inline void write_database(const std::filesystem::path& path, const std::vector<Message>& messages,
                           const Compress& compress = {}) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  sqlite3_exec(database,
               "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT, "
               "offered_qos_profiles TEXT);"
               "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB);BEGIN",
               nullptr, nullptr, nullptr);
  std::map<std::string, int> ids;
  for (const auto& m : messages) {
    sqlite3_stmt* statement = nullptr;
    if (ids.try_emplace(m.topic, static_cast<int>(ids.size()) + 1).second) {
      const std::string sql =
          "INSERT INTO topics VALUES(" + std::to_string(ids[m.topic]) + ",'" + m.topic + "','" + m.type + "','cdr','')";
      sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr);
    }
    sqlite3_prepare_v2(database, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?,?,?)", -1, &statement,
                       nullptr);
    const auto bytes = compress ? compress(m.bytes) : m.bytes;
    sqlite3_bind_int(statement, 1, ids[m.topic]);
    sqlite3_bind_int64(statement, 2, m.time_ns);
    sqlite3_bind_blob(statement, 3, bytes.data(), static_cast<int>(bytes.size()), SQLITE_TRANSIENT);
    EXPECT_EQ(sqlite3_step(statement), SQLITE_DONE);
    sqlite3_finalize(statement);
  }
  sqlite3_exec(database, "COMMIT", nullptr, nullptr, nullptr);
  sqlite3_close(database);
}

}  // namespace bole::testing_bags
