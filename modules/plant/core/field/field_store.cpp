#include "plant/core/field/field_store.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "plant/core/field/grid_encoder.h"
#include "plant/core/field/grid_reshape.h"
#include "plant/core/field/hash_encoder.h"
#include "plant/core/field/paper_encoder.h"
#include "plant/core/field/space_store.h"

namespace bole::plant {
namespace {

using nlohmann::json;

constexpr float max_raw = 12;
constexpr std::uint64_t steps = 4095;  // of a packed value: four of 12 bits make a whole number below 2^48

double pack(const Eigen::Array4f& value) {
  std::uint64_t bits = 0;
  for (int k = 0; k < 4; ++k) {
    const float share = std::clamp((value(k) + max_raw) / (2 * max_raw), 0.0F, 1.0F);
    bits = bits << 12 | static_cast<std::uint64_t>(std::lround(share * static_cast<float>(steps)));
  }
  return static_cast<double>(bits);
}

Eigen::Array4f unpack(double number) {
  auto bits = static_cast<std::uint64_t>(number);
  Eigen::Array4f value;
  for (int k = 3; k >= 0; --k) {
    value(k) = (static_cast<float>(bits & steps) / static_cast<float>(steps) * 2 - 1) * max_raw;
    bits >>= 12;
  }
  return value;
}

json camera_json(const CameraModel& c) {
  return {{"width", c.width}, {"height", c.height},        {"fx", c.fx}, {"fy", c.fy}, {"cx", c.cx},
          {"cy", c.cy},       {"distortion", c.distortion}};
}

void read_parameters(FieldEncoder& encoder, StoredNumbers& numbers) {
  if (encoder.parameter_count() > numbers.left()) throw damaged_field("it ends early");
  encoder.visit_parameters([&](std::span<float> p) {
    for (float& v : p) v = static_cast<float>(numbers.next(-1e6, 1e6));
  });
}

}  // namespace

Table store_field(const FieldModel& field, const FieldView& first_view) {
  json facts{{"version", 1}, {"background", choice_name(field.background)}, {"camera", camera_json(first_view.camera)}};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) facts["pose"].push_back(first_view.T_world_camera.matrix()(r, c));
  std::vector<double> values;
  if (const auto* grid = dynamic_cast<const GridEncoder*>(field.encoder.get())) {
    facts["encoder"] = "grid";
    // Empty space is not kept: a cell whose density lets 99 % of the light through.
    const auto space =
        std::make_shared<const FieldSpace>(with_cells(*field.space, solid_cells(*grid, *field.space, -5)));
    const auto kept = resampled(*grid, *field.space, space);
    store_space(*space, facts, values);
    for (std::size_t b = 0; b < space->boxes.size(); ++b)
      for (std::size_t i = 0; i < space->boxes[b].places.size() * FieldBox::block_voxels; ++i)
        values.push_back(pack(kept->value_at(b, i)));
  } else if (const auto* hash = dynamic_cast<const HashEncoder*>(field.encoder.get())) {
    facts["encoder"] = "hash";
    const auto& s = hash->settings();
    facts["hash"] = {
        {"levels", s.levels}, {"table_bits", s.table_bits}, {"width", s.width}, {"base_cells", s.base_cells}};
    store_space(*field.space, facts, values);
    field.encoder->visit_parameters([&](std::span<float> p) { values.insert(values.end(), p.begin(), p.end()); });
  }
  if (const auto* paper = dynamic_cast<const PaperEncoder*>(field.encoder.get())) {
    facts["encoder"] = "paper";
    const auto& s = paper->settings();
    facts["paper"] = {{"layers", s.layers},
                      {"width", s.width},
                      {"color_width", s.color_width},
                      {"frequencies", s.frequencies},
                      {"integrated", s.integrated}};
    store_space(*field.space, facts, values);
    field.encoder->visit_parameters([&](std::span<float> p) { values.insert(values.end(), p.begin(), p.end()); });
  }
  for (const auto& c : field.environment.values())
    for (int k = 0; k < 3; ++k) values.push_back(c(k));
  Table table;
  table.set("value", std::move(values));
  table.facts["field"] = facts.dump();
  return table;
}

StoredField load_field(const Table& table) {
  const auto fact = table.facts.find("field");
  if (fact == table.facts.end() || !table.has("value"))
    throw damaged_field("it has no fact 'field' or no column 'value'");
  StoredField out;
  try {
    const auto facts = json::parse(fact->second);
    StoredNumbers numbers(table.numbers("value"));
    out.model.background = choice_from_name<Background>(facts.at("background").get<std::string>());
    out.model.environment = Environment(out.model.background);
    const auto& c = facts.at("camera");
    out.camera.width = c.at("width"), out.camera.height = c.at("height");
    out.camera.fx = c.at("fx"), out.camera.fy = c.at("fy"), out.camera.cx = c.at("cx"), out.camera.cy = c.at("cy");
    for (std::size_t k = 0; k < 5; ++k) out.camera.distortion[k] = c.at("distortion").at(k);
    out.camera.check();
    for (int i = 0; i < 12; ++i)
      out.T_world_camera.matrix()(i / 4, i % 4) = facts.at("pose").at(static_cast<std::size_t>(i)).get<double>();
    const auto space = load_space(facts, numbers);
    out.model.space = space;
    if (facts.at("encoder") == "grid") {
      auto grid = std::make_unique<GridEncoder>(space, GridEncoder::Rates{});
      if (grid->parameter_count() / 4 > numbers.left()) throw damaged_field("it ends early");
      for (std::size_t b = 0; b < space->boxes.size(); ++b)
        for (std::size_t block = 0; block < space->boxes[b].places.size(); ++block)
          for (std::size_t v = 0; v < FieldBox::block_voxels; ++v)
            grid->value(b, block, v) = unpack(numbers.next(0, 0x1p48));
      out.model.encoder = std::move(grid);
    } else if (facts.at("encoder") == "paper") {
      PaperEncoder::Settings s;
      const auto& h = facts.at("paper");
      s.layers = std::clamp(h.at("layers").get<int>(), 1, 32);
      s.width = std::clamp(h.at("width").get<int>(), 1, 2048);
      s.color_width = std::clamp(h.at("color_width").get<int>(), 1, 2048);
      s.frequencies = std::clamp(h.at("frequencies").get<int>(), 1, 32);
      s.integrated = h.at("integrated").get<bool>();
      out.model.encoder = std::make_unique<PaperEncoder>(space, s);
      read_parameters(*out.model.encoder, numbers);
    } else {
      HashEncoder::Settings s;
      const auto& h = facts.at("hash");
      s.levels = std::clamp(h.at("levels").get<int>(), 1, 32);
      s.table_bits = std::clamp(h.at("table_bits").get<int>(), 4, 24);
      s.width = std::clamp(h.at("width").get<int>(), 1, 1024);
      s.base_cells = std::clamp(h.at("base_cells").get<int>(), 1, 1024);
      out.model.encoder = std::make_unique<HashEncoder>(space, s);
      read_parameters(*out.model.encoder, numbers);
    }
    for (auto& value : out.model.environment.values())
      for (int k = 0; k < 3; ++k) value(k) = static_cast<float>(numbers.next(-1e3, 1e3));
  } catch (const json::exception& e) {
    throw damaged_field(e.what());
  }
  out.model.exposures = Exposures(0);
  return out;
}

}  // namespace bole::plant
