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
// double, anything else text. Lines "# name: value" before the header become facts. Semicolons or tabs between the
// cells are recognised, with semicolons and tabs also decimal commas. Throws Error{bad_input} naming the line: cells
// missing or too many, an unclosed quote, no header, a column twice.
Table read_table(const std::filesystem::path& path, const Run& run = {});
Table read_table(Bytes file, const std::string& name, const Run& run = {});

// Numbers of a column with as many decimals as said, by default the shortest text that reads back to the same value.
using Decimals = std::map<std::string, int, std::less<>>;

// Writes to a temporary file beside and renames it. NaN becomes an empty cell. Throws Error{failed} when that fails.
void write_table(const std::filesystem::path& path, const Table& table, const Decimals& decimals = {});
std::string table_text(const Table& table, const Decimals& decimals = {});

}  // namespace bole::io
