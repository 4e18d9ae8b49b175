#include "pipeline/old_survey.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/markup.h"
#include "pipeline/result_folder.h"

namespace bole::pipeline {
namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr std::string_view banner_begin = "<!-- bole: a later run failed -->";
constexpr std::string_view banner_end = "<!-- bole: end -->\n";
constexpr const char* no_time = "an unknown time";

std::string page_text(const fs::path& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(text).str();
}

std::string now_text() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now())); }

// The headline of the old verdict is struck out: green must not be what is seen first.
std::string banner(const std::string& why, const std::string& when, const std::string& finished_at) {
  return std::string(banner_begin) +
         "<style>.verdict { border-color: #b93a32 !important; background: #fbeceb !important; } .verdict h2 { color: "
         "#5b666e !important; text-decoration: line-through; }</style>\n<div role=\"alert\" style=\"background: "
         "#b93a32; color: #fff; padding: 1rem 1.5rem; font: 1.05rem/1.5 sans-serif\"><strong style=\"font-size: "
         "1.35rem\">Do not sign: a later run into this folder failed</strong><br>The run of " +
         escaped(when) + " failed: " + escaped(why) +
         "<br>The values on this page are of the run before, finished at " + escaped(finished_at) + ".</div>\n" +
         std::string(banner_end);
}

std::string note_text(const std::string& why, const std::string& finished_at) {
  return "The last run into this folder failed:\n\n  " + why +
         "\n\nThe other files here are those of the survey before, finished at " + finished_at +
         ".\nThey do not show what the last run was asked for. What it wrote is in the folder " + failed_run_folder +
         ", unless the disk was full.\n";
}

void mark_summary(ordered_json& summary, const std::string& why, const std::string& when) {
  summary["later_run_failed"] = why;
  summary["later_run_failed_at"] = when;
  if (summary.value("verdict", std::string()) == "sign") summary["verdict"] = "look";
  auto findings = ordered_json::array();
  findings.push_back({{"code", "older_survey"},
                      {"severity", "look"},
                      {"text", "a later run failed (" + why + "): this is the survey before it, finished at " +
                                   summary.value("finished_at", std::string(no_time))}});
  if (summary.contains("findings") && summary["findings"].is_array())
    for (const auto& finding : summary["findings"])
      if (finding.value("code", std::string()) != "older_survey") findings.push_back(finding);
  summary["findings"] = std::move(findings);
}

// Words for a file that could not be written.
std::string reason(const fs::path& folder, const Error& error) {
  std::error_code ignored;
  constexpr std::uintmax_t hardly_any = 1 << 20;
  const auto space = fs::space(folder, ignored);
  return !ignored && space.available < hardly_any ? std::string("the disk is full") : std::string(error.what());
}

}  // namespace

std::string without_banner(std::string html) {
  for (auto begin = html.find(banner_begin); begin != std::string::npos; begin = html.find(banner_begin, begin)) {
    const auto end = html.find(banner_end, begin);
    if (end == std::string::npos) break;
    html.erase(begin, end + banner_end.size() - begin);
  }
  return html;
}

void mark_page(const fs::path& page, const std::string& why, const std::string& when, const std::string& finished_at) {
  constexpr std::string_view start = "<!DOCTYPE html>", body = "<body>\n";
  auto html = without_banner(page_text(page));
  const auto at = html.find(body);
  if (!html.starts_with(start) || at == std::string::npos) return;
  html.insert(at + body.size(), banner(why, when, finished_at));
  write_text_file(page, html);
}

void unmark_page(const fs::path& page) {
  const auto html = page_text(page);
  if (auto plain = without_banner(html); plain.size() != html.size()) write_text_file(page, plain);
}

std::string mark_survey(const fs::path& folder, const std::set<std::string>& files, const std::string& why) {
  std::string not_marked;
  const auto attempt = [&](const std::string& name, const auto& mark) {
    try {
      mark(folder / name);
    } catch (const Error& e) {
      not_marked += (not_marked.empty() ? "" : "; ") + name + ": " + reason(folder, e);
    }
  };
  const auto when = now_text();
  auto summary = ordered_json::parse(page_text(folder / "summary.json"), nullptr, false);
  if (!summary.is_object()) return "summary.json: it cannot be read";
  const auto finished_at = summary.value("finished_at", std::string(no_time));
  mark_summary(summary, why, when);
  // The page is what a person opens, the summary what programs read.
  for (const auto& name : files)
    if (name.ends_with(".html")) attempt(name, [&](const auto& path) { mark_page(path, why, when, finished_at); });
  attempt("summary.json", [&](const auto& path) {
    write_text_file(path, summary.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
  });
  attempt(failed_run_note, [&](const auto& path) { write_text_file(path, note_text(why, finished_at)); });
  return not_marked;
}

}  // namespace bole::pipeline
