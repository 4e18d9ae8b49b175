#include "vtkbridge/stage_execution.h"

#include <spdlog/spdlog.h>

#include "base/content_hash.h"
#include "base/core/path_list.h"
#include "base/option_text.h"
#include "base/verdict.h"
#include "base/version.h"
#include "cloud/large_cloud.h"

namespace bole::vtkbridge {
namespace {

// Hashes what it is given and keeps nothing.
class HashingStore : public BlobStore {
 public:
  std::string put(std::span<const std::byte> bytes) override { return content_hash(bytes); }
  std::size_t size(const std::string&) const override { return 0; }
  void get(const std::string&, std::span<std::byte>) const override {}
};

void leave_memory(const DataSet& data) {
  for (const auto& [port, value] : data.all())
    if (const auto* cloud = std::get_if<std::shared_ptr<const PointCloud>>(&value); cloud && *cloud)
      leave_memory(**cloud);
}

// What a stage added to a large cloud goes to where the rest of it is.
void lay_clouds_on_file(pipeline::StageResult& result, const Run& run) {
  std::size_t without_room = 0;
  const auto outputs = result.outputs.all();
  for (const auto& [port, value] : outputs) {
    const auto* cloud = std::get_if<std::shared_ptr<const PointCloud>>(&value);
    if (!cloud || !*cloud || columns_bytes(**cloud) <= large_columns_bytes) continue;
    PointCloud on_file = **cloud;
    without_room += lay_columns_on_file(on_file, scratch_folders(run));
    result.outputs.set(port, std::move(on_file));
  }
  if (without_room > 0) result.report.warn(no_room_for_scratch(without_room));
}

pipeline::StageResult run_now(const pipeline::StageType& type, const OptionSet& options, const PortData& inputs,
                              const Run& run) {
  DataSet data;
  for (const auto& [port, lazy] : inputs)
    if (lazy) data.set(port, lazy->get());
  const auto given = data.all().find(given_port);
  pipeline::StageResult result = given == data.all().end() ? pipeline::run_stage(type, data, options, run)
                                                           : pipeline::take_data(type, given->second, options, run);
  lay_clouds_on_file(result, run);
  leave_memory(data), leave_memory(result.outputs);
  return result;
}

// A result that lies in the cache. Should it prove damaged, the stage is run once for all its outputs.
class StoredResult {
 public:
  StoredResult(std::shared_ptr<ResultCache> cache, std::string key, std::function<DataSet()> run_again)
      : cache_(std::move(cache)), key_(std::move(key)), run_again_(std::move(run_again)) {}

  Data load(const std::string& port, const std::string& stored) {
    const std::lock_guard lock(mutex_);
    try {
      return cache_->load(stored, [&](const std::string&) { return again().all().at(port); });
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::failed) throw;
      spdlog::warn("{}; running the stage again", e.what());
      cache_->remove(key_);
      return again().all().at(port);
    }
  }

 private:
  const DataSet& again() {
    if (!outputs_) outputs_ = run_again_();
    return *outputs_;
  }
  std::mutex mutex_;
  std::shared_ptr<ResultCache> cache_;
  std::string key_;
  std::function<DataSet()> run_again_;
  std::optional<DataSet> outputs_;
};

std::function<DataSet()> repeat(const pipeline::StageType& type, const OptionSet& options, const PortData& inputs,
                                const Run& run) {
  Run silent = run;
  silent.progress = nullptr, silent.preview = nullptr;
  return [&type, options, inputs, silent] { return run_now(type, options, inputs, silent).outputs; };
}

// The paths that files have once they were moved from one folder to another.
void move_paths(std::vector<WrittenFile>& files, const std::filesystem::path& from, const std::filesystem::path& to) {
  for (auto& file : files) file.path = (to / std::filesystem::path(file.path).lexically_relative(from)).string();
}

std::string output_key(const std::string& key, const std::string& port) { return key.empty() ? key : key + "." + port; }

}  // namespace

std::string content_key(const Data& data) {
  HashingStore store;
  const std::string text = store_data(data, store);
  return content_hash(std::as_bytes(std::span(text)));
}

std::string stage_key(const pipeline::StageType& type, const OptionSet& options, const PortData& inputs, const Run& run,
                      ResultCache& cache, const std::filesystem::path& final_dir) {
  ContentHash hash;
  hash.add_text(version());
  hash.add_text(type.name);
  hash.add_value(type.version);
  for (const auto& spec : type.options->specs) {
    const OptionValue value = options.get(spec.name);
    const bool is_path = is_input_path(spec, value);
    hash.add_text(spec.name);
    if (!is_path) {
      hash.add_text(option_text(value));
      continue;
    }
    for (const auto& path : input_paths(spec, option_text(value))) {
      hash.add_text(cache.file_key(path, run));
      // The name counts as well: readers tell formats by it. Of a list the folders do too, since results name them.
      hash.add_text(is_path_list(spec) ? path : std::filesystem::path(path).filename().string());
    }
  }
  for (const auto& [port, lazy] : inputs) {
    hash.add_text(port);
    hash.add_text(!lazy ? "none" : lazy->key().empty() ? content_key(lazy->get()) : lazy->key());
  }
  if (type.writes_files)
    hash.add_text(
        std::filesystem::absolute(final_dir.empty() ? run.output_dir : final_dir).lexically_normal().string());
  return hash.hex();
}

StageExecution execute_stage(const pipeline::StageType& type, const OptionSet& options, const PortData& inputs,
                             const Run& run, const std::shared_ptr<ResultCache>& cache,
                             const std::filesystem::path& final_dir) {
  StageExecution execution;
  const std::string key = cache ? stage_key(type, options, inputs, run, *cache, final_dir) : std::string();
  const auto loader = [&] {
    const auto stored = std::make_shared<StoredResult>(cache, key, repeat(type, options, inputs, run));
    return [stored](const std::string& port, const std::string& text) -> std::function<Data()> {
      return [stored, port, text] { return stored->load(port, text); };
    };
  };
  if (cache) {
    if (const auto found = cache->find(key)) {
      const auto load = loader();
      for (const auto& [port, text] : found->outputs) {
        const auto* declared = type.output(port);
        execution.outputs[port] = std::make_shared<LazyData>(declared ? declared->kind : DataKind::none,
                                                             output_key(key, port), load(port, text));
      }
      execution.report = found->report, execution.files = found->files, execution.from_cache = true;
      return execution;
    }
  }
  const auto cache_folder = cache ? cache->folder() : std::filesystem::path();
  const auto before = type.writes_files ? list_files(run.output_dir, cache_folder) : std::vector<WrittenFile>();
  pipeline::StageResult result = run_now(type, options, inputs, run);
  if (type.writes_files) {
    execution.files = changed_files(before, list_files(run.output_dir, cache_folder));
    if (!final_dir.empty()) move_paths(execution.files, run.output_dir, final_dir);
  }
  const bool whole = result.report.status != Status::finished_early && !run.asked_to_finish() &&
                     !has_finding(result.report, finding_code::output_not_written) &&
                     !has_finding(result.report, finding_code::input_not_usable);
  for (const auto& [port, data] : result.outputs.all())
    execution.outputs[port] = std::make_shared<LazyData>(data, whole ? output_key(key, port) : std::string());
  if (cache && whole) {
    try {
      const auto load = loader();
      for (const auto& [port, text] : cache->store(key, type.name, result, execution.files, run))
        execution.outputs.at(port)->set_load(load(port, text));
    } catch (const std::exception& e) {  // a full disk must not cost the result
      run.check_cancel();
      spdlog::warn("{}: the result is not kept in the cache: {}", type.name, e.what());
    }
  }
  execution.report = std::move(result.report);
  return execution;
}

}  // namespace bole::vtkbridge
