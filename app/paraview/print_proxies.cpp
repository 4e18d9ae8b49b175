// Writes what the plugin's build and tests need of the declarations: the stages as proxies in ParaView's server-manager
// XML, the writers of Bole's formats as proxies, and the stages as JSON.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "base/atomic_file.h"
#include "documents/opened_files.h"
#include "io/core/formats.h"
#include "pipeline/paraview_xml.h"
#include "pipeline/printing.h"
#include "pipeline/register_all_stages.h"

namespace {

using bole::io::FileContent;

std::string written_extensions(FileContent content) {
  std::string extensions;
  for (const auto& format : bole::io::formats())
    if (format.content() == content && format.writable())
      for (const auto ending : format.endings)
        extensions += (extensions.empty() ? "" : " ") + std::string(ending.substr(1));
  return extensions;
}

std::string writer(std::string_view name, std::string_view label, std::string_view input, FileContent content) {
  return fmt::format(R"(    <WriterProxy name="Bole_{}" class="vtkBoleWriter" label="{}" supports_parallel="1">
      <Documentation>Writes the file as bole run writes its results. The ending of the file decides the format. With several processes the first one writes everything.</Documentation>
      <InputProperty name="Input" command="SetInputConnection">
        <ProxyGroupDomain name="groups">
          <Group name="sources"/>
          <Group name="filters"/>
        </ProxyGroupDomain>
        <DataTypeDomain name="input_type">
          <DataType value="{}"/>
        </DataTypeDomain>
      </InputProperty>
      <StringVectorProperty name="FileName" command="SetFileName" number_of_elements="1"/>
      <Hints>
        <Property name="Input" show="0"/>
        <Property name="FileName" show="0"/>
        <WriterFactory extensions="{}" file_description="{}"/>
      </Hints>
    </WriterProxy>
)",
                     name, label, input, written_extensions(content), label);
}

std::string writers() {
  return "<ServerManagerConfiguration>\n  <ProxyGroup name=\"writers\">\n" +
         writer("cloud_writer", "Point cloud (Bole)", "vtkPointSet", FileContent::cloud) +
         writer("table_writer", "Table (Bole)", "vtkTable", FileContent::table) +
         "  </ProxyGroup>\n</ServerManagerConfiguration>\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: bole_paraview_proxies PROXIES.xml WRITERS.xml STAGES.json\n");
    return 2;
  }
  try {
    auto& registry = bole::pipeline::StageRegistry::global();
    bole::pipeline::register_all_stages(registry);
    bole::write_text_file(argv[1], bole::pipeline::paraview_xml(registry, bole::documents::opened_files()));
    bole::write_text_file(argv[2], writers());
    bole::write_text_file(argv[3], bole::pipeline::stages_json(registry));
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
