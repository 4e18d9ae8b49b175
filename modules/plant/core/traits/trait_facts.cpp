#include "plant/core/traits/trait_facts.h"

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace bole::plant {
namespace {

constexpr const char* key = "plant_trait_options";

}  // namespace

void put_trait_options(Facts& facts, const TraitOptions& options) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (const auto& spec : option_table(static_cast<const TraitOptions*>(nullptr)).specs)
    object[spec.name] = option_text(spec.get(&options));
  facts[key] = object.dump();
}

TraitOptions trait_options_of(const Facts& facts) {
  const auto it = facts.find(key);
  if (it == facts.end())
    throw bad_input("the table of traits does not tell how it was measured", "the output 'traits' of plant.traits");
  OptionSet set(option_table(static_cast<const TraitOptions*>(nullptr)));
  const auto object = nlohmann::json::parse(it->second, nullptr, false);
  if (!object.is_object()) throw bad_input("the fact '" + std::string(key) + "' is damaged", "a JSON object");
  for (const auto& [name, value] : object.items())
    if (value.is_string() && set.table().find(name) != nullptr) set.set_text(name, value.get<std::string>());
  return set.as<TraitOptions>();
}

}  // namespace bole::plant
