// The marks on a survey that a later, failed run left in its folder: in FAILED_RUN.txt, in summary.json, and at the top
// of its HTML pages.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace bole::pipeline {

// Puts a banner at the top of a page that Bole wrote, in place of one that is there. `when`: of the run that failed;
// `finished_at`: of the survey. Does nothing where the file is no such page. Throws Error{failed}.
void mark_page(const std::filesystem::path& page, const std::string& why, const std::string& when,
               const std::string& finished_at);
// Removes the banner. Throws Error{failed}.
void unmark_page(const std::filesystem::path& page);
// The text of a page without the banner.
std::string without_banner(std::string html);

// Marks the survey of a folder. `files`: names of its results. Gives what could not be marked and why, as in
// "report.html: no space on the disk"; empty when all was.
std::string mark_survey(const std::filesystem::path& folder, const std::set<std::string>& files,
                        const std::string& why);

}  // namespace bole::pipeline
