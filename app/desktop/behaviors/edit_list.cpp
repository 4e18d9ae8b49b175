#include "behaviors/edit_list.h"

#include <QDateTime>
#include <algorithm>

#include "document/person.h"

namespace bole::desktop {

std::string edit_stage(const Session& session, const std::string& type) {
  if (!session.has_document()) throw bad_input("no pipeline is open", "a pipeline with a stage " + type);
  const auto& stages = session.document().stages();
  const auto it = std::ranges::find_if(stages, [&](const auto& node) { return node.type->name == type; });
  if (it == stages.end())
    throw bad_input("the pipeline has no stage " + type, "one after the stage whose results are edited",
                    "Add it in the pipeline panel and connect it");
  return it->id;
}

std::string edit_author() { return person().toStdString(); }

std::string edit_time() { return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString(); }

}  // namespace bole::desktop
