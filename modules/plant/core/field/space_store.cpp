#include "plant/core/field/space_store.h"

#include <nlohmann/json.hpp>

namespace bole::plant {

using nlohmann::json;

Error damaged_field(const std::string& what) {
  return bad_input("the table is no field: " + what, "the output 'field' of plant.field");
}

double StoredNumbers::next(double min, double max) {
  if (at_ >= values_.size()) throw damaged_field("it ends early");
  const double v = values_[at_++];
  if (!(v >= min && v <= max)) throw damaged_field("value " + std::to_string(at_) + " is " + std::to_string(v));
  return v;
}

void store_space(const FieldSpace& space, json& facts, std::vector<double>& values) {
  facts["origin"] = {space.origin.x(), space.origin.y(), space.origin.z()};
  facts["step"] = space.step;
  for (const auto& box : space.boxes) {
    std::size_t sampled = 0;
    for (const auto mask : box.cells) sampled += mask != 0;
    facts["boxes"].push_back({{"min", {box.min.x(), box.min.y(), box.min.z()}},
                              {"voxel", box.voxel},
                              {"blocks", {box.blocks.x(), box.blocks.y(), box.blocks.z()}},
                              {"sampled", sampled}});
    for (std::size_t i = 0; i < box.places.size(); ++i) {
      if (box.cells[i] == 0) continue;
      values.push_back(static_cast<double>(box.block_index(box.places[i])));
      values.push_back(static_cast<double>(box.cells[i] >> 32));
      values.push_back(static_cast<double>(box.cells[i] & 0xFFFFFFFFU));
    }
  }
}

std::shared_ptr<const FieldSpace> load_space(const json& facts, StoredNumbers& numbers) {
  auto space = std::make_shared<FieldSpace>();
  for (int k = 0; k < 3; ++k) space->origin(k) = facts.at("origin").at(static_cast<std::size_t>(k)).get<double>();
  space->step = facts.at("step").get<float>();
  if (!(space->step > 0.01F && space->step < 100)) throw damaged_field("its step is out of range");
  const auto& boxes = facts.at("boxes");
  if (boxes.empty() || boxes.size() > FieldSpace::max_boxes)
    throw damaged_field("it has " + std::to_string(boxes.size()) + " boxes");
  for (const auto& j : boxes) {
    FieldBox box;
    double places = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      box.min(static_cast<int>(k)) = j.at("min").at(k).get<float>();
      box.blocks(static_cast<int>(k)) = j.at("blocks").at(k).get<int>();
      if (box.blocks(static_cast<int>(k)) < 1) throw damaged_field("a box has no blocks");
      places *= box.blocks(static_cast<int>(k));
    }
    box.voxel = j.at("voxel").get<float>();
    const auto sampled = j.at("sampled").get<std::size_t>();
    if (!(places <= 100e6) || !(box.voxel > 0) || !box.min.allFinite() || sampled * 3 > numbers.left())
      throw damaged_field("a box is larger than its numbers");
    box.block_of.assign(static_cast<std::size_t>(places), -1);
    std::vector<std::uint64_t> masks(box.block_of.size(), 0);
    for (std::size_t i = 0; i < sampled; ++i) {
      const auto place = static_cast<std::size_t>(numbers.next(0, places - 1));
      const auto high = static_cast<std::uint64_t>(numbers.next(0, 4294967295.0));
      masks[place] = high << 32 | static_cast<std::uint64_t>(numbers.next(0, 4294967295.0));
    }
    space->boxes.push_back(std::move(box));
    space->set_cells(space->boxes.size() - 1, masks);
  }
  return space;
}

}  // namespace bole::plant
