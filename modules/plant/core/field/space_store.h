// The space of a field as numbers and facts, so that it can be kept.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/error.h"
#include "plant/core/field/field_space.h"

namespace bole::plant {

// For whatever a stored field has that cannot be.
Error damaged_field(const std::string& what);

// Numbers one after another, each checked.
class StoredNumbers {
 public:
  explicit StoredNumbers(std::vector<double> values) : values_(std::move(values)) {}
  // Throws damaged_field() where they end, or one is not in [min, max].
  double next(double min, double max);
  std::size_t left() const { return values_.size() - at_; }

 private:
  std::vector<double> values_;
  std::size_t at_ = 0;
};

// Sets `origin`, `step` and `boxes` of `facts`, and appends three numbers per sampled block: its place and the two
// halves of its cells.
void store_space(const FieldSpace& space, nlohmann::json& facts, std::vector<double>& values);
// Throws damaged_field(), or what the JSON library throws for facts that are missing.
std::shared_ptr<const FieldSpace> load_space(const nlohmann::json& facts, StoredNumbers& numbers);

}  // namespace bole::plant
