#include "features/field_check/field_list.h"

#include <QRegularExpression>
#include <QString>
#include <algorithm>

#include "document/stage_operations.h"
#include "document/stage_roles.h"

namespace bole::desktop {
namespace {

constexpr const char* field_port = "reference_stems";  // of the evaluation
constexpr const char* sections_port = "sections";      // of stages that measure diameters; rows have stems without

struct Pattern {
  std::string name;
  QString words;  // a regular expression
};

const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> list{{"tree_id", "^(tree[_ ]?(id|nr|no)?|id|nr|no|number|baum.*|树号|编号|株号)$"},
                                         {"dbh_cm", "^(dbh|bhd|d ?1[.,]3|diam.*|d|胸径)\\b|^dbh|胸径"},
                                         {"height_m", "^(h|ht|height|h(ö|oe)he|树高)\\b|^height|树高"},
                                         {"azimuth_deg", "^(azimuth|azi|bearing|方位角)\\b|^azimuth"},
                                         {"distance_m", "^(dist(ance)?|距离)\\b|^distance"},
                                         {"x_m", "^(x|e|east(ing)?|rechtswert|东)\\b|^x_m$|^x坐标"},
                                         {"y_m", "^(y|n|north(ing)?|hochwert|北)\\b|^y_m$|^y坐标"}};
  return list;
}

std::string unit_in(const QString& column, const FieldColumn& wanted) {
  for (const auto& unit : wanted.units)
    if (column.contains(QRegularExpression("[_ (\\[]" + QString::fromStdString(unit) + "[)\\]]?$"))) return unit;
  return wanted.units.empty() ? std::string() : wanted.units.front();
}

pipeline::StageNode& in(pipeline::PipelineDocument& document, const std::string& id) {
  return *std::ranges::find(document.stages(), id, &pipeline::StageNode::id);
}

void put(pipeline::StageNode& node, const std::string& option, const OptionValue& value) {
  node.options.set(option, value);
  node.given.insert(option);
}

}  // namespace

const std::vector<FieldColumn>& field_columns() {
  static const std::vector<std::string> lengths{"m", "cm", "ft"};
  static const std::vector<FieldColumn> list{
      {"x_m", lengths, true}, {"y_m", lengths, true}, {"dbh_cm", {"cm", "mm", "m", "in"}, true},
      {"height_m", lengths},  {"tree_id", {}},        {"azimuth_deg", {"deg", "gon"}},
      {"distance_m", lengths}};
  return list;
}

std::string FieldMapping::text() const {
  std::string text;
  for (const auto& entry : entries) {
    const bool same = entry.name == entry.source && (entry.unit.empty() || entry.name.ends_with("_" + entry.unit));
    if (entry.source.empty() || same) continue;
    text += (text.empty() ? "" : ", ") + entry.name + "=" + entry.source + (entry.unit.empty() ? "" : ":" + entry.unit);
  }
  return text;
}

FieldMapping guess_mapping(const Table& list) {
  FieldMapping mapping;
  std::vector<std::string> taken;
  for (const auto& wanted : field_columns()) {
    FieldMapping::Entry entry{wanted.name, {}, wanted.units.empty() ? std::string() : wanted.units.front()};
    const auto pattern = std::ranges::find(patterns(), wanted.name, &Pattern::name);
    const QRegularExpression words(
        pattern->words, QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    for (const auto& column : list.columns()) {
      auto name = QString::fromStdString(column.name).trimmed();
      const bool free = std::ranges::find(taken, column.name) == taken.end();
      if (!entry.source.empty() || !free) continue;
      if (column.name == wanted.name || QString(name).replace('_', ' ').contains(words)) {
        entry.source = column.name;
        entry.unit = unit_in(name, wanted);
        taken.push_back(column.name);
      }
    }
    mapping.entries.push_back(entry);
  }
  return mapping;
}

pipeline::PipelineDocument with_field_list(const pipeline::PipelineDocument& document, const std::string& file,
                                           const FieldMapping& mapping, const std::string& align) {
  pipeline::PipelineDocument after = document;
  if (stage_with_input(after, field_port) == nullptr) {
    if (stage_with_output(after, sections_port) == nullptr)
      throw bad_input("the pipeline measures no stems", "a stage that measures stems",
                      "Add one before you load field measurements");
    after = with_stage(after, type_with_input(field_port)).document;
  }
  const auto evaluate = stage_with_input(after, field_port)->id;
  const auto joint = in(after, evaluate).inputs.find(field_port);
  // The reader of the list: the one that the evaluation takes from, else a new one in front of it.
  std::string reader =
      joint == in(after, evaluate).inputs.end() ? std::string() : pipeline::parse_source(joint->second).id;
  if (reader.empty() || after.at(reader).type != &table_reader()) {
    const auto& stages = after.stages();
    const auto place = std::ranges::find(stages, evaluate, &pipeline::StageNode::id) - stages.begin();
    auto added =
        with_stage(after, table_reader(), place > 0 ? stages[static_cast<std::size_t>(place) - 1].id : std::string());
    after = std::move(added.document);
    reader = added.id;
    in(after, reader).optional = true;
    in(after, evaluate).inputs[field_port] = reader + ".table";
  }
  put(in(after, reader), "file", file);
  put(in(after, evaluate), "reference_columns", mapping.text());
  put(in(after, evaluate), "align_stems", align);
  return after;
}

}  // namespace bole::desktop
