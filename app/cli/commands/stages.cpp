#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "commands.h"
#include "pipeline/paraview_xml.h"
#include "pipeline/printing.h"

namespace bole::cli {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> pages(const pipeline::StageRegistry& registry) {
  std::map<std::string, std::string> by_file{{"README.md", pipeline::stages_index_markdown(registry)},
                                             {"arrays.md", pipeline::arrays_markdown()}};
  for (const auto* type : registry.all()) by_file[type->name + ".md"] = pipeline::stage_markdown(*type);
  return by_file;
}

std::string read_text(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_pages(const fs::path& folder, const std::map<std::string, std::string>& by_file) {
  fs::create_directories(folder);
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".md" && !by_file.contains(entry.path().filename().string()))
      fs::remove(entry.path());
  for (const auto& [name, text] : by_file) std::ofstream(folder / name) << text;
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

}  // namespace

void add_stages(Program& program) {
  struct Arguments {
    std::string type, out, check;
    bool json = false, markdown = false, paraview_xml = false, schema = false;
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand("stages", "List the stages, or print everything about them");
  command->add_option("type", args->type, "One stage: its ports and options");
  auto* forms = command->add_option_group("form");
  forms->add_flag("--json", args->json, "All declarations as JSON");
  forms->add_flag("--markdown", args->markdown, "Manual pages");
  forms->add_flag("--paraview-xml", args->paraview_xml, "ServerManager XML for a ParaView plugin");
  forms->add_flag("--schema", args->schema, "JSON schema of pipeline documents");
  forms->require_option(0, 1);
  command->add_option("--out", args->out, "With --markdown: write the pages into this folder")->type_name("DIR");
  command->add_option("--check", args->check, "With --markdown: fail when a page in this folder is not current")
      ->type_name("DIR");
  command->callback([args, &program] {
    const auto& registry = pipeline::StageRegistry::global();
    if (args->json) return fmt::print("{}", pipeline::stages_json(registry));
    if (args->schema) return fmt::print("{}", pipeline::document_schema(registry));
    if (args->paraview_xml) return fmt::print("{}", pipeline::paraview_xml(registry));
    if (args->markdown && !args->out.empty()) return write_pages(args->out, pages(registry));
    if (args->markdown && !args->check.empty()) {
      for (const auto& page : stale_pages(args->check, pages(registry))) {
        fmt::print(stderr, "{} is not what the program prints. Run ./do docs\n",
                   (fs::path(args->check) / page).string());
        program.exit_code = 1;
      }
      return;
    }
    if (!args->type.empty()) return fmt::print("{}", pipeline::stage_markdown(registry.at(args->type)));
    if (args->markdown) {
      for (const auto& [name, text] : pages(registry)) fmt::print("{}\n", text);
      return;
    }
    for (const auto* type : registry.all()) fmt::print("{:<24} {}\n", type->name, type->title);
  });
}

}  // namespace bole::cli
