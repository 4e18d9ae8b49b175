#include "render/scene/view_point.h"

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace bole::render {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Vector3d vector_of(const Json& view, const char* key) {
  const auto& a = view.at(key);
  return {a.at(0).get<double>(), a.at(1).get<double>(), a.at(2).get<double>()};
}

}  // namespace

std::string views_json(const std::vector<NamedView>& views) {
  Json all = Json::array();
  for (const auto& [name, view] : views)
    all.push_back({{"name", name},
                   {"eye", json_of(view.eye)},
                   {"centre", json_of(view.centre)},
                   {"up", json_of(view.up)},
                   {"parallel", view.parallel},
                   {"half_height_m", view.half_height_m}});
  return all.dump(2) + "\n";
}

std::vector<NamedView> parse_views(std::string_view json) {
  std::vector<NamedView> views;
  try {
    const auto all = Json::parse(json);
    if (!all.is_array()) throw bad_input("the views are no JSON list", "a list of views, as the window writes it");
    for (const auto& v : all) {
      ViewPoint view{vector_of(v, "eye"), vector_of(v, "centre"), vector_of(v, "up"), v.value("parallel", false),
                     v.value("half_height_m", 1.0)};
      if (view.eye != view.centre) views.push_back({v.value("name", std::string()), view});
    }
  } catch (const nlohmann::json::exception& e) {
    throw bad_input(std::string("the views cannot be read: ") + e.what(), "a list of views, as the window writes it",
                    "Bookmark the views again");
  }
  return views;
}

}  // namespace bole::render
