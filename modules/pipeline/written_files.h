// What a run wrote, by size and content, so that a file which a person changed since is recognised.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

namespace bole::pipeline {

// The record of a file: its size, and a hash of its content unless it is large. The mark of an old survey
// (old_survey.h) does not count.
nlohmann::ordered_json record_of(const std::filesystem::path& file);

// Names in `records` (an object of name and record) whose files in `folder` are there and differ.
std::set<std::string> changed_files(const std::filesystem::path& folder, const nlohmann::ordered_json& records);

// "stems.changed-2026-11-26T191503Z.csv": the name under which the changed `folder`/`name` is kept, by the time of its
// change. Nothing has that name in `folder`.
std::string name_of_changed(const std::filesystem::path& folder, const std::string& name);

}  // namespace bole::pipeline
