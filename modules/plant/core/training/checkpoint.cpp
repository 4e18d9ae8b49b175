#include "plant/core/training/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/content_hash.h"
#include "base/error.h"
#include "plant/core/field/space_store.h"

namespace bole::plant {
namespace {

using nlohmann::json;

// A line with this mark, a line of facts as JSON, the numbers, and the hash of all that as 32 digits.
constexpr std::string_view mark = "bole training 1\n";
constexpr std::size_t hash_digits = 32;

Error damaged_checkpoint(const std::filesystem::path& path, const std::string& what) {
  return bad_input("the checkpoint " + path.string() + " is damaged: " + what, "a file that a training has written",
                   "Delete it to train from the start");
}

json facts_of(const std::string& key, const TrainingState& state) {
  const auto& p = state.progress;
  return {{"key", key},
          {"step", state.step},
          {"reshaped", state.reshaped},
          {"loss", state.loss},
          {"decayed", state.decayed},
          {"seconds", state.seconds},
          {"progress", {{"step", p.step}, {"loss", p.loss}, {"psnr_db", p.psnr_db}, {"seconds", p.seconds}}}};
}

// JSON has no NaN: the PSNR of a training without views kept back becomes null.
std::vector<double> numbers_or_nan(const json& values) {
  std::vector<double> out;
  for (const auto& v : values) out.push_back(v.is_null() ? std::nan("") : v.get<double>());
  return out;
}

void take_facts(const json& facts, TrainingState& state) {
  state.step = facts.at("step");
  state.reshaped = facts.at("reshaped");
  state.loss = facts.at("loss");
  state.decayed = facts.at("decayed");
  state.seconds = facts.at("seconds");
  const auto& p = facts.at("progress");
  state.progress.step = p.at("step").get<std::vector<std::int64_t>>();
  state.progress.loss = numbers_or_nan(p.at("loss"));
  state.progress.psnr_db = numbers_or_nan(p.at("psnr_db"));
  state.progress.seconds = numbers_or_nan(p.at("seconds"));
}

// Throws where the file is not as it was written.
void check_hash(const std::filesystem::path& path, std::ifstream& in, std::size_t size) {
  ContentHash hash;
  std::vector<char> buffer(1U << 20U);
  for (std::size_t left = size - hash_digits; left > 0;) {
    const auto part = std::min(left, buffer.size());
    if (!in.read(buffer.data(), static_cast<std::streamsize>(part)))
      throw failure("the checkpoint " + path.string() + " cannot be read");
    hash.add_bytes(std::as_bytes(std::span(buffer).first(part)));
    left -= part;
  }
  std::string digits(hash_digits, '0');
  in.read(digits.data(), hash_digits);
  if (hash.hex() != digits) throw damaged_checkpoint(path, "its content has changed or is cut off");
  in.seekg(0);
}

// The stream stands at the numbers then.
json read_facts(const std::filesystem::path& path, std::ifstream& in) {
  std::string line(mark.size(), ' ');
  in.read(line.data(), static_cast<std::streamsize>(line.size()));
  if (!in || line != mark) throw damaged_checkpoint(path, "it begins with something else");
  std::getline(in, line);
  return json::parse(line);
}

}  // namespace

std::string training_key(const FieldOptions& options, const Region& region, const std::vector<FieldView>& views) {
  ContentHash hash;
  hash.add_text(options.region + text_of(region));
  hash.add_value(options.encoder);
  hash.add_value(options.extent);
  hash.add_value(options.background);
  for (const double v : {options.voxel, options.depth_weight, options.depth_sigma, options.min_share})
    hash.add_value(v);
  for (const int v : {options.steps, options.rays, options.max_width, options.hold_out, options.max_memory_mib,
                      options.seed, options.paper_layers, options.paper_width, options.paper_frequencies})
    hash.add_value(v);
  for (const bool v : {options.exposure, options.refine_poses, options.paper_integrated}) hash.add_value(v);
  for (const auto& view : views) {
    hash.add_text(view.name);
    hash.add_value(view.held_out);
    hash.add_bytes(std::as_bytes(std::span(view.color.values)));
    hash.add_bytes(std::as_bytes(std::span(view.depth.values)));
    hash.add_bytes(std::as_bytes(std::span(view.T_world_camera.matrix().data(), 16)));
    for (const double v : {view.camera.fx, view.camera.fy, view.camera.cx, view.camera.cy}) hash.add_value(v);
    for (const double v : view.camera.distortion) hash.add_value(v);
  }
  return hash.hex();
}

void write_checkpoint(const std::filesystem::path& path, const std::string& key, TrainingState& state) {
  auto facts = facts_of(key, state);
  std::vector<double> space;
  store_space(*state.model.space, facts["space"], space);
  facts["space_numbers"] = space.size();
  AtomicFile file(path);
  ContentHash hash;
  const auto write = [&](std::span<const std::byte> bytes) {
    hash.add_bytes(bytes);
    file.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  const std::string head = std::string(mark) + facts.dump() + '\n';
  write(std::as_bytes(std::span(head)));
  write(std::as_bytes(std::span(space)));
  visit_learnt(state, write);
  visit_moments(state, write);
  file.stream() << hash.hex();
  file.commit();
}

void read_checkpoint(const std::filesystem::path& path, const std::string& key, const FieldOptions& options,
                     bool has_depth, TrainingState& state) {
  std::ifstream in(path, std::ios::binary);
  const auto size = in ? static_cast<std::size_t>(std::filesystem::file_size(path)) : 0;
  if (size < mark.size() + hash_digits) throw damaged_checkpoint(path, fmt::format("it has {} bytes", size));
  check_hash(path, in, size);
  try {
    const auto facts = read_facts(path, in);
    if (facts.at("key") != key)
      throw bad_input("the checkpoint " + path.string() + " belongs to another training",
                      "one with the same options, region, pictures and poses",
                      "Delete it, or give this training a checkpoint of its own");
    std::size_t left = size - hash_digits - static_cast<std::size_t>(in.tellg());
    const auto take = [&](std::span<std::byte> bytes) {
      if (bytes.size() > left) throw damaged_checkpoint(path, "it ends early");
      in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
      left -= bytes.size();
    };
    const auto space_numbers = facts.at("space_numbers").get<std::size_t>();
    if (space_numbers > left / sizeof(double)) throw damaged_checkpoint(path, "it ends early");
    std::vector<double> values(space_numbers);
    take(std::as_writable_bytes(std::span(values)));
    StoredNumbers numbers(std::move(values));
    state.model.space = load_space(facts.at("space"), numbers);
    state.model.encoder = make_encoder(options, state.model.space, has_depth);
    take_facts(facts, state);
    visit_learnt(state, take);
    visit_moments(state, take);
    state.poses.move_views(state.views);
    if (left != 0) throw damaged_checkpoint(path, fmt::format("{} bytes are left over", left));
  } catch (const json::exception& e) {
    throw damaged_checkpoint(path, e.what());
  }
}

}  // namespace bole::plant
