// The names of the files that sinks (report.plot and its like) write, known before a run: a folder that holds foreign
// files of these names is refused before hours of work.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bole::pipeline {

// Files, and folders that hold results only ("figures"), as names in the output folder.
void add_result_names(const std::vector<std::string_view>& names);
bool is_result_name(std::string_view name);

}  // namespace bole::pipeline
