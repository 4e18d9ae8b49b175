// Tables as CSV (RFC 4180: commas, quotes doubled within quotes, LF or CRLF).
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "base/run.h"
#include "cloud/table.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

// The first line names the columns. A column of whole numbers only becomes int64, one of numbers (empty cells: NaN)
// double, anything else text. Lines "# name: value" before the header become facts. Semicolons and tabs
// between the cells are recognised, and with them decimal commas. Throws Error{bad_input} that names the line where
// cells are missing or too many, a quote is not closed, the header is missing or names a column twice.
Table read_table(const std::filesystem::path& path, const Run& run = {});
Table read_table(Bytes file, const std::string& name, const Run& run = {});

// Decimals by column. Other numbers get the shortest text that reads back to the same value.
using Decimals = std::map<std::string, int, std::less<>>;

// Writes a temporary file in the same folder and renames it. NaN becomes an empty cell. Throws Error{failed}.
void write_table(const std::filesystem::path& path, const Table& table, const Decimals& decimals = {});
std::string table_text(const Table& table, const Decimals& decimals = {});

}  // namespace bole::io
