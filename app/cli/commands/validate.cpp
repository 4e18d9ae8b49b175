#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands.h"
#include "documents/new_document.h"
#include "pipeline/document.h"

namespace bole::cli {

void add_validate(Program& program) {
  struct Arguments {
    std::string pipeline;
    std::vector<std::string> sets;
    bool json = false;
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand("validate", "Say whether a pipeline document can run, and if not, why");
  command->add_option("pipeline", args->pipeline, "Pipeline document (JSON), or the name of one that comes with Bole")
      ->required();
  command->add_option("--set", args->sets, "Set an option: STAGE.OPTION=VALUE")->type_name("ASSIGNMENT");
  command->add_flag("--json", args->json, "Print the problems as JSON");
  command->callback([args, &program] {
    auto document = documents::load_pipeline(args->pipeline);
    pipeline::apply_sets(document, args->sets);
    const auto problems = pipeline::validate(document);
    if (args->json) {
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (const auto& p : problems) list.push_back({{"stage", p.stage}, {"message", p.message}});
      fmt::print("{}\n", nlohmann::ordered_json{{"valid", problems.empty()}, {"problems", list}}.dump(2));
    } else {
      for (const auto& p : problems) fmt::print("{}: {}\n", p.stage, p.message);
      if (problems.empty()) fmt::print("{}: can run ({} stages)\n", args->pipeline, document.stages().size());
    }
    if (!problems.empty()) program.exit_code = 2;
  });
}

}  // namespace bole::cli
