// Writes what the plugin's build and tests need of the declarations: the proxies as ParaView's server-manager XML, and
// the same stages as JSON.
#include <fmt/format.h>

#include <cstdio>

#include "base/atomic_file.h"
#include "pipeline/paraview_xml.h"
#include "pipeline/printing.h"
#include "pipeline/register_all_stages.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: bole_paraview_proxies PROXIES.xml STAGES.json\n");
    return 2;
  }
  try {
    auto& registry = bole::pipeline::StageRegistry::global();
    bole::pipeline::register_all_stages(registry);
    bole::write_text_file(argv[1], bole::pipeline::paraview_xml(registry));
    bole::write_text_file(argv[2], bole::pipeline::stages_json(registry));
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
