#include "pipeline/stage.h"

#include <chrono>

#include "base/memory.h"
#include "base/option_text.h"

namespace bole::pipeline {
namespace {

const Port* find_port(const std::vector<Port>& ports, std::string_view name) {
  for (const auto& p : ports)
    if (p.name == name) return &p;
  return nullptr;
}

void check_inputs(const StageType& type, const DataSet& inputs) {
  for (const auto& port : type.inputs) {
    if (!inputs.has(port.name)) {
      if (port.optional) continue;
      throw bad_input("input '" + port.name + "' is not connected",
                      std::string(data_kind_name(port.kind)) + ": " + port.help);
    }
    const auto& data = inputs.all().find(port.name)->second;
    if (data_kind(data) != port.kind)
      throw bad_input("input '" + port.name + "' is a " + std::string(data_kind_name(data_kind(data))),
                      "a " + std::string(data_kind_name(port.kind)));
    if (port.kind == DataKind::cloud)
      for (const auto& array : port.arrays)
        if (!inputs.cloud(port.name).has(array))
          inputs.cloud(port.name).column(array.name);  // throws with the list of arrays
  }
}

StageResult measured(const StageType& type, const OptionSet& options, const Run& run,
                     const std::function<StageResult()>& work) {
  try {
    const auto start = std::chrono::steady_clock::now();
    options.check_all();
    run.check_cancel();
    StageResult result = work();
    result.report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.report.peak_mib = peak_resident_mib();
    return result;
  } catch (const Error& e) {
    throw e.at(type.name);
  } catch (const std::bad_alloc&) {
    throw failure("out of memory", "less data at once", "Crop or thin the cloud first").at(type.name);
  }
}

}  // namespace

const Port* StageType::input(std::string_view port) const { return find_port(inputs, port); }
const Port* StageType::output(std::string_view port) const { return find_port(outputs, port); }

StageResult run_stage(const StageType& type, const DataSet& inputs, const OptionSet& options, const Run& run) {
  return measured(type, options, run, [&] {
    check_inputs(type, inputs);
    return type.run(inputs, options, run);
  });
}

StageResult take_data(const StageType& type, const Data& given, const OptionSet& options, const Run& run) {
  return measured(type, options, run, [&] {
    if (!type.take) throw bad_input("the stage takes no data from memory", "a file", "Set its option with the path");
    const auto kind = type.outputs.front().kind;
    if (data_kind(given) != kind)
      throw bad_input("a " + std::string(data_kind_name(data_kind(given))) + " was given",
                      "a " + std::string(data_kind_name(kind)));
    return type.take(given, options, run);
  });
}

StageResult run_piece(const StageType& type, const Piece& piece, const OptionSet& options, const Run& run) {
  return measured(type, options, run, [&] {
    if (!type.run_piece) throw bad_input("the stage gives no pieces", "one of the readers that do");
    return type.run_piece(piece, options, run);
  });
}

StageRegistry& StageRegistry::global() {
  static StageRegistry registry;
  return registry;
}

void StageRegistry::add(StageType type) {
  const auto name = type.name;
  if (!types_.try_emplace(name, std::make_unique<StageType>(std::move(type))).second)
    throw failure("there are two stage types '" + name + "'", "a name of its own for each");
}

bool StageRegistry::first_time(std::string_view module) { return modules_.emplace(module).second; }

const StageType* StageRegistry::find(std::string_view name) const {
  const auto it = types_.find(name);
  return it == types_.end() ? nullptr : it->second.get();
}

const StageType& StageRegistry::at(std::string_view name) const {
  if (const auto* type = find(name)) return *type;
  // "stems" asks for one of stems.slice, stems.fit and so on, "fit" for stems.fit.
  std::vector<std::string> names;
  std::string parts;
  for (const auto& [n, t] : types_) {
    names.push_back(n);
    const bool is_part = n.starts_with(std::string(name) + ".") || n.ends_with("." + std::string(name));
    if (is_part && !name.empty()) parts += (parts.empty() ? "Did you mean " : " or ") + n;
  }
  throw bad_input("there is no stage type '" + std::string(name) + "'", "one that `bole stages` lists",
                  parts.empty() ? did_you_mean(name, names) : parts + "?");
}

std::vector<const StageType*> StageRegistry::all() const {
  std::vector<const StageType*> list;
  for (const auto& [n, t] : types_) list.push_back(t.get());
  return list;
}

}  // namespace bole::pipeline
