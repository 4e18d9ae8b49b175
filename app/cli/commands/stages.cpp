#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/atomic_file.h"
#include "commands.h"
#include "documents/opened_files.h"
#include "documents/stage_example.h"
#include "pipeline/paraview_xml.h"
#include "pipeline/printing.h"

namespace bole::cli {
namespace {

namespace fs = std::filesystem;

std::string page(const pipeline::StageType& type) {
  return pipeline::stage_markdown(type, documents::stage_example(type));
}

std::map<std::string, std::string> pages(const pipeline::StageRegistry& registry) {
  std::map<std::string, std::string> by_file{{"README.md", pipeline::stages_index_markdown(registry)},
                                             {"arrays.md", pipeline::arrays_markdown()}};
  for (const auto* type : registry.all()) by_file[type->name + ".md"] = page(*type);
  return by_file;
}

std::string read_text(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_pages(const fs::path& folder, const std::map<std::string, std::string>& by_file) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".md" && !by_file.contains(entry.path().filename().string()))
      fs::remove(entry.path());
  for (const auto& [name, text] : by_file) write_text_file(folder / name, text);
}

// The committed pages against what is printed; the pages that differ, are missing or belong to no stage.
std::vector<std::string> stale_pages(const fs::path& folder, const std::map<std::string, std::string>& by_file) {
  std::vector<std::string> stale;
  for (const auto& [name, text] : by_file)
    if (read_text(folder / name) != text) stale.push_back(name);
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (!by_file.contains(entry.path().filename().string())) stale.push_back(entry.path().filename().string());
  return stale;
}

// What a run of the stage uses with a preset and single options.
void print_values(const pipeline::StageRegistry& registry, const std::string& type_name, const std::string& preset,
                  const std::vector<std::string>& settings) {
  if (type_name.empty())
    throw bad_input("--preset or --set without a stage", "a stage type", "bole stages slam.run ...");
  const auto& type = registry.at(type_name);
  OptionSet options(*type.options);
  if (!preset.empty()) options.set_text("preset", preset);
  for (const auto& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos) throw bad_input("--set " + setting, "OPTION=VALUE");
    options.set_text(setting.substr(0, equals), std::string_view(setting).substr(equals + 1));
  }
  options.check_all();
  fmt::print("{}", pipeline::values_in_force_text(type, options));
}

}  // namespace

void add_stages(Program& program) {
  struct Arguments {
    std::string type, out, check, preset;
    std::vector<std::string> settings;
    bool json = false, markdown = false, paraview_xml = false, schema = false;
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand("stages", "List the stages, or print everything about them");
  command->add_option("type", args->type, "One stage: its ports and options");
  auto* preset = command->add_option("--preset", args->preset, "With a stage: the values in force with this preset")
                     ->type_name("NAME");
  auto* set = command->add_option("--set", args->settings, "With a stage: the values in force with these options")
                  ->type_name("OPTION=VALUE");
  auto* forms = command->add_option_group("form");
  forms->add_flag("--json", args->json, "All declarations as JSON");
  forms->add_flag("--markdown", args->markdown, "Manual pages");
  forms->add_flag("--paraview-xml", args->paraview_xml, "ServerManager XML for a ParaView plugin");
  forms->add_flag("--schema", args->schema, "JSON schema of pipeline documents");
  forms->require_option(0, 1);
  forms->excludes(preset);
  forms->excludes(set);
  command->add_option("--out", args->out, "With --markdown: write the pages into this folder")->type_name("DIR");
  command->add_option("--check", args->check, "With --markdown: fail when a page in this folder is not current")
      ->type_name("DIR");
  command->callback([args, &program] {
    const auto& registry = pipeline::StageRegistry::global();
    if (args->json) return fmt::print("{}", pipeline::stages_json(registry));
    if (args->schema) return fmt::print("{}", pipeline::document_schema(registry));
    if (args->paraview_xml) return fmt::print("{}", pipeline::paraview_xml(registry, documents::opened_files()));
    if (args->markdown && !args->out.empty()) return write_pages(args->out, pages(registry));
    if (args->markdown && !args->check.empty()) {
      for (const auto& page : stale_pages(args->check, pages(registry))) {
        fmt::print(stderr, "{} is not what the program prints. Run ./do docs\n",
                   (fs::path(args->check) / page).string());
        program.exit_code = 1;
      }
      return;
    }
    if (!args->preset.empty() || !args->settings.empty())
      return print_values(registry, args->type, args->preset, args->settings);
    if (!args->type.empty()) return fmt::print("{}", page(registry.at(args->type)));
    if (args->markdown) {
      for (const auto& [name, text] : pages(registry)) fmt::print("{}\n", text);
      return;
    }
    for (const auto* type : registry.all()) fmt::print("{:<24} {}\n", type->name, type->title);
  });
}

}  // namespace bole::cli
