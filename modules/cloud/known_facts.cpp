#include "cloud/known_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/option.h"
#include "base/option_text.h"
#include "cloud/core/height_facts.h"
#include "cloud/core/laser_facts.h"
#include "cloud/core/whole/whole_cloud.h"
#include "cloud/core/whole/whole_size.h"
#include "cloud/first_sight.h"

namespace bole {
inline namespace cloud {
namespace {

Error damaged_fact(const FactInfo& info, const std::string& text, const std::string& needed) {
  return bad_input(fmt::format("the data say '{}' for '{}'", text.substr(0, 40), info.key), needed,
                   "Set the option that stands for this fact, or correct the data");
}

// Throws where a known fact has a value that it cannot have.
void check(const Facts& facts, const FactInfo& info) {
  if (&info == &facts::poses) pose_origin(facts);
  if (!info.unit.empty()) fact_number(facts, info);
}

}  // namespace

std::span<const FactInfo* const> known_facts() {
  static constexpr std::array all{&facts::sensor,
                                  &facts::beam_divergence,
                                  &facts::beam_divergence_sd,
                                  &facts::beam_aperture,
                                  &facts::range_noise,
                                  &facts::lasers,
                                  &facts::clock,
                                  &facts::poses,
                                  &facts::level_sigma,
                                  &facts::breast_height,
                                  &facts::kind,
                                  &facts::height_reference,
                                  &facts::terrain,
                                  &facts::whole_origin,
                                  &facts::whole_low,
                                  &facts::whole_spacing,
                                  &facts::whole_points,
                                  &facts::axes,
                                  &facts::crs};
  return all;
}

std::optional<std::string> fact_text(const Facts& facts, const FactInfo& info) {
  const auto it = facts.find(info.key);
  return it == facts.end() ? std::nullopt : std::optional(it->second);
}

std::optional<double> fact_number(const Facts& facts, const FactInfo& info) {
  const auto text = fact_text(facts, info);
  if (!text) return std::nullopt;
  const auto number = number_from_text(*text);
  if (!number || !(*number >= info.min && *number <= info.max))
    throw damaged_fact(
        info, *text,
        "a number from " + number_text(info.min) + " to " + number_text(info.max) + " " + std::string(info.unit));
  return number;
}

std::optional<PoseOrigin> pose_origin(const Facts& facts) {
  const auto text = fact_text(facts, facts::poses);
  if (!text) return std::nullopt;
  try {
    return choice_from_name<PoseOrigin>(*text);
  } catch (const Error&) {
    throw damaged_fact(facts::poses, *text, "given or estimated");
  }
}

void set_fact(Facts& facts, const FactInfo& info, std::string_view text) {
  facts.insert_or_assign(std::string(info.key), std::string(text));
}
void set_fact(Facts& facts, const FactInfo& info, double number) {
  set_fact(facts, info, fmt::format("{:.9g}", number));
}
void set_fact(Facts& facts, PoseOrigin origin) { set_fact(facts, facts::poses, choice_name(origin)); }
void set_fact(Facts& facts, Clock clock) { set_fact(facts, facts::clock, choice_name(clock)); }

std::string facts_to_json(const Facts& facts) {
  return nlohmann::json(facts).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

Facts facts_from_json(std::string_view text, std::vector<std::string>& warnings) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) {
    warnings.emplace_back("the facts of the file are damaged (no JSON object) and were left out");
    return {};
  }
  Facts facts;
  for (const auto& [key, value] : json.items()) {
    if (value.is_string())
      facts.emplace(key, value.get<std::string>());
    else
      warnings.push_back(fmt::format("the fact '{}' of the file is no text and was left out", key.substr(0, 40)));
  }
  for (const auto* info : known_facts()) try {
      check(facts, *info);
    } catch (const Error& e) {
      warnings.push_back(fmt::format("the fact '{}' of the file was left out: {}", info->key, e.what()));
      facts.erase(facts.find(info->key));
    }
  return facts;
}

}  // namespace cloud
}  // namespace bole
