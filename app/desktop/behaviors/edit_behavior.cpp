#include "behaviors/edit_behavior.h"

#include <QDateTime>
#include <algorithm>

#include "document/person.h"

namespace bole::desktop {

std::string EditBehavior::edit_stage() const {
  if (!session_.has_document()) throw bad_input("no pipeline is open", "a pipeline with a stage stems.edit");
  const auto& stages = session_.document().stages();
  const auto it = std::ranges::find_if(stages, [](const auto& node) { return node.type->name == "stems.edit"; });
  if (it == stages.end())
    throw bad_input("the pipeline has no stage stems.edit", "one after the stems",
                    "Add it and connect it to the report");
  return it->id;
}

void EditBehavior::apply(std::vector<StemEdit> more) {
  const auto stage = edit_stage();
  auto edits = parse_stem_edits(std::get<std::string>(session_.document().at(stage).options.get("edits")));
  for (auto& edit : more) {
    if (edit.author.empty()) edit.author = person().toStdString();
    if (edit.time.empty()) edit.time = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    edits.push_back(std::move(edit));
  }
  const auto text = to_json(edits);
  parse_stem_edits(text);  // refuses what a file of edits would be refused for
  session_.set_option(stage, "edits", text);
  Q_EMIT applied();
}

}  // namespace bole::desktop
