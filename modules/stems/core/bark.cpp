#include "stems/core/bark.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/resources.h"

namespace bole::stems {
namespace {

constexpr double max_relief_mm = 30;

std::filesystem::path file_of(const std::string& name) {
  if (std::filesystem::path(name).extension() == ".json") return name;
  const auto names = bark_names();
  if (std::ranges::find(names, name) != names.end()) return resource_path("bark/" + name + ".json");
  throw bad_input("there is no bark '" + name + "'",
                  fmt::format("one of {}, or the path of a JSON file", fmt::join(names, ", ")));
}

Bark read_bark(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw bad_input("cannot open '" + path.string() + "'", "a bark description in JSON");
  const auto wrong = [&](const std::string& what) {
    return bad_input("'" + path.string() + "': " + what,
                     fmt::format("title, and relief_mm and relief_sd_mm from 0 to {}", max_relief_mm));
  };
  const auto json = nlohmann::json::parse(file, nullptr, false, true);
  if (!json.is_object()) throw wrong("it is not JSON");
  Bark bark;
  try {
    bark.title = json.at("title").get<std::string>();
    for (auto [key, value] : {std::pair("relief_mm", &bark.relief_m), std::pair("relief_sd_mm", &bark.relief_sd_m)}) {
      const double mm = json.at(key).get<double>();
      if (!(mm >= 0 && mm <= max_relief_mm)) throw wrong(fmt::format("{} is {}", key, mm));
      *value = mm / 1000;
    }
    if (json.contains("species")) bark.species = json.at("species").get<std::vector<std::string>>();
  } catch (const nlohmann::json::exception& e) {
    throw wrong(e.what());
  }
  return bark;
}

}  // namespace

std::vector<std::string> bark_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(resource_path("bark")))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

Bark bark_of(const MeasureOptions& options) {
  auto bark = read_bark(file_of(options.bark));
  if (options.bark_relief) bark.relief_m = *options.bark_relief;
  if (options.bark_relief_sd) bark.relief_sd_m = *options.bark_relief_sd;
  return bark;
}

}  // namespace bole::stems
