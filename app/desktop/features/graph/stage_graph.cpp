#include "features/graph/stage_graph.h"

#include <algorithm>
#include <map>

#include "document/stage_words.h"

namespace bole::desktop {
namespace {

QString kind_words(DataKind kind) {
  switch (kind) {
    case DataKind::cloud:
      return StageGraph::tr("point cloud");
    case DataKind::table:
      return StageGraph::tr("table");
    case DataKind::raster:
      return StageGraph::tr("raster");
    case DataKind::trajectory:
      return StageGraph::tr("trajectory");
    case DataKind::frames:
      return StageGraph::tr("frames");
    case DataKind::views:
      return StageGraph::tr("views");
    case DataKind::none:
      break;
  }
  return {};
}

// Of clouds and tables.
std::optional<std::size_t> arrays_in(const Results& results, const std::string& stage, const std::string& port) {
  const auto outputs = results.find(stage);
  if (outputs == results.end()) return {};
  const auto data = outputs->second.all().find(port);
  if (data == outputs->second.all().end()) return {};
  if (const auto* cloud = std::get_if<std::shared_ptr<const PointCloud>>(&data->second))
    return (*cloud)->columns().size();
  if (const auto* table = std::get_if<std::shared_ptr<const Table>>(&data->second)) return (*table)->columns().size();
  return {};
}

}  // namespace

StageGraph StageGraph::of(const pipeline::PipelineDocument& document) {
  StageGraph graph;
  std::map<std::string, std::size_t> numbers;
  for (const auto& node : document.stages()) {
    numbers[node.id] = graph.stages.size();
    Stage stage{QString::fromStdString(node.id), stage_title(document, node), stage_description(node), {}, {}};
    for (const auto& port : node.type->outputs) stage.outputs.push_back(&port);
    graph.stages.push_back(std::move(stage));
  }
  for (const auto& node : document.stages()) {
    const std::size_t to = numbers.at(node.id);
    for (const auto& port : node.type->inputs) {
      const auto joined = node.inputs.find(port.name);
      const std::string text = joined == node.inputs.end() ? std::string() : joined->second;
      const auto dot = std::min(text.find('.'), text.size());
      const auto from = numbers.find(text.substr(0, dot));
      const std::string output = text.substr(std::min(dot + 1, text.size()));
      const bool found = from != numbers.end() && std::ranges::any_of(graph.stages[from->second].outputs,
                                                                      [&](const auto* p) { return p->name == output; });
      if (!found) {
        if (!port.optional) graph.stages[to].missing << QString::fromStdString(port.name);
        continue;
      }
      auto join =
          std::ranges::find_if(graph.joins, [&](const auto& j) { return j.from == from->second && j.to == to; });
      if (join == graph.joins.end()) join = graph.joins.insert(join, {from->second, to, {}});
      join->joints.push_back({output, port.name});
    }
  }
  return graph;
}

QString StageGraph::words(const Join& join, const Results& results) const {
  const auto& from = stages[join.from];
  QStringList lines{QString("%1 → %2").arg(from.title, stages[join.to].title)};
  for (const auto& [output, input] : join.joints) {
    const auto* port = *std::ranges::find(from.outputs, output, &pipeline::Port::name);
    QString line =
        QString::fromStdString(output == input ? output : output + " → " + input) + ": " + kind_words(port->kind);
    if (const auto count = arrays_in(results, from.id.toStdString(), output))
      line += ", " + tr("%n array(s)", nullptr, static_cast<int>(*count));
    else if (!port->arrays.empty())
      line += ", " + tr("adds %n array(s)", nullptr, static_cast<int>(port->arrays.size()));
    lines << line;
  }
  return lines.join('\n');
}

}  // namespace bole::desktop
