// bole campaign: thousands of plots by one command. The engine is Python (app/python/bole_campaign): here its options
// are declared, so that help, completion and the manual page know them, and handed over as JSON.
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/resources.h"
#include "base/user_path.h"
#include "base/version.h"
#include "commands.h"

namespace bole::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* python_variable = "BOLE_PYTHON";

// The one that was asked for, that of an active virtual environment, that of the build, or the first in the PATH.
std::string python_program() {
  if (const char* set = std::getenv(python_variable); set != nullptr && *set != '\0') return set;
  std::error_code ignored;
  if (const char* active = std::getenv("VIRTUAL_ENV"); active != nullptr && *active != '\0')
    if (const auto program = fs::path(active) / "bin" / "python3"; fs::exists(program, ignored)) return program;
  return fs::exists(BOLE_PYTHON_PROGRAM, ignored) ? BOLE_PYTHON_PROGRAM : "python3";
}

// Beside the resources: python in an installation, app/python in the source tree.
fs::path engine_script() {
  const auto share = resource_dir().parent_path();
  std::error_code ignored;
  for (const auto* folder : {"python", "app/python"})
    if (auto script = share / folder / "bole_campaign" / "start.py"; fs::is_regular_file(script, ignored))
      return script;
  throw failure("the campaign engine is not in '" + (share / "python").string() + "'", "bole_campaign/start.py",
                "Install the package bole again");
}

// This program becomes the engine: signals, terminal and exit code are its own.
[[noreturn]] void become_engine(nlohmann::ordered_json request) {
  std::error_code ignored;
  request["program"] = fs::read_symlink("/proc/self/exe", ignored).string();
  request["version"] = std::string(version());
  const std::vector<std::string> words{python_program(), engine_script().string(), request.dump()};
  std::vector<char*> arguments;
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments.front(), arguments.data());
  throw failure("cannot start '" + words.front() + "': " + std::strerror(errno), "Python 3.9 or later",
                std::string("Install python3, or give the program with ") + python_variable + "=PATH");
}

struct CampaignArguments {
  std::string campaign, out, scheduler, engine = "auto";
  int workers = 0, task = -1;
  double memory = 0;
  bool retry = false, json = false;
};
using Shared = std::shared_ptr<CampaignArguments>;

void add_document(CLI::App& command, const Shared& args) {
  command.add_option("campaign", args->campaign, "Campaign document (JSON): pipeline and inputs")
      ->type_name("FILE")
      ->required();
  command.add_option("--out", args->out, "Folder of the campaign")->type_name("DIR")->required();
  command.add_flag("--retry", args->retry, "Run inputs again whose work failed before (bad input is left alone)");
}

void add_folder(CLI::App& command, const Shared& args) {
  command.add_option("folder", args->out, "Folder of the campaign")->type_name("DIR")->required();
}

nlohmann::ordered_json request_of(const CampaignArguments& args, const char* verb) {
  nlohmann::ordered_json request{{"verb", verb}, {"out", expand_home(args.out)}};
  if (!args.campaign.empty()) request["campaign"] = expand_home(args.campaign);
  return request;
}

void add_plan(CLI::App& parent) {
  const auto args = std::make_shared<CampaignArguments>();
  auto* command = parent.add_subcommand("plan", "Print what would run, and why. Runs nothing");
  add_document(*command, args);
  command->add_flag("--json", args->json, "Print JSON");
  command->callback([args] {
    auto request = request_of(*args, "plan");
    request["retry"] = args->retry;
    request["json"] = args->json;
    become_engine(std::move(request));
  });
}

void add_run_of_all(CLI::App& parent) {
  const auto args = std::make_shared<CampaignArguments>();
  auto* command = parent.add_subcommand("run", "Run what is missing or changed, then put the tables together");
  add_document(*command, args);
  auto* workers = command
                      ->add_option("--workers", args->workers,
                                   "Inputs that run at the same time on this machine. Default: as many as fit into "
                                   "its processors and memory")
                      ->type_name("N")
                      ->check(CLI::Range(1, 4096).description(""));
  auto* scheduler = command
                        ->add_option("--scheduler", args->scheduler,
                                     std::string("Run on the Dask cluster with this scheduler (tcp://HOST:8786, or the "
                                                 "path of its scheduler file). Needs Dask.distributed (package "
                                                 "python3-distributed, or a Python that has it: ") +
                                         python_variable + "=PATH)")
                        ->type_name("ADDRESS");
  auto* task = command
                   ->add_option("--task", args->task,
                                "Run one input alone, by its number in the plan: a job array. Arrays may count from 0 "
                                "or from 1")
                   ->type_name("K")
                   ->check(CLI::NonNegativeNumber.description(""));
  auto* engine = command
                     ->add_option("--engine", args->engine,
                                  "What runs the inputs on this machine: a Dask cluster of its own, worker processes "
                                  "without Dask, or (auto) Dask where it is installed")
                     ->type_name("auto|dask|local")
                     ->check(CLI::IsMember({"auto", "dask", "local"}).description(""));
  auto* memory =
      command
          ->add_option("--memory", args->memory,
                       "Memory for all workers of this machine together, GiB. Default: what is free, less a reserve")
          ->type_name("GIB")
          ->check(CLI::Range(0.1, 65536.0).description(""));
  scheduler->excludes(workers)->excludes(task)->excludes(memory)->excludes(engine);
  task->excludes(workers)->excludes(engine);
  command->callback([args] {
    auto request = request_of(*args, "run");
    request["retry"] = args->retry;
    request["engine"] = args->engine;
    if (args->workers > 0) request["workers"] = args->workers;
    if (!args->scheduler.empty()) request["scheduler"] = args->scheduler;
    if (args->task >= 0) request["task"] = args->task;
    if (args->memory > 0) request["memory_gib"] = args->memory;
    become_engine(std::move(request));
  });
}

void add_status(CLI::App& parent) {
  const auto args = std::make_shared<CampaignArguments>();
  auto* command = parent.add_subcommand("status", "Print the state of every input, the worst first");
  add_folder(*command, args);
  command->add_flag("--json", args->json, "Print JSON");
  command->callback([args] {
    auto request = request_of(*args, "status");
    request["json"] = args->json;
    become_engine(std::move(request));
  });
}

void add_merge(CLI::App& parent) {
  const auto args = std::make_shared<CampaignArguments>();
  auto* command =
      parent.add_subcommand("merge", "Write stems.csv, campaign.gpkg and campaign.html from what is done so far");
  add_folder(*command, args);
  command->callback([args] { become_engine(request_of(*args, "merge")); });
}

}  // namespace

void add_campaign(Program& program) {
  auto* command = program.app.add_subcommand("campaign", "Run a pipeline on many inputs, on one machine or a cluster");
  command->require_subcommand(1);
  add_plan(*command);
  add_run_of_all(*command);
  add_status(*command);
  add_merge(*command);
}

}  // namespace bole::cli
