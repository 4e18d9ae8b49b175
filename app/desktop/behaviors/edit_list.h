// Edits that a person makes are a list in the option `edits` of a stage of the document: those of stems in stems.edit,
// those of rows in rows.edit.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "document/session.h"

namespace bole::desktop {

// The id of the stage of this type. Throws bole::Error when the document has none.
std::string edit_stage(const Session& session, const std::string& type);

// Name of the person and time, as edits carry them.
std::string edit_author();
std::string edit_time();

// Adds edits to the list as one step of undo, signed where they are not. `parse` reads a list and refuses what a file
// of edits would be refused for. Throws bole::Error.
template <class Edit>
void add_edits(Session& session, const std::string& type, std::vector<Edit> (*parse)(std::string_view),
               std::vector<Edit> more) {
  const auto stage = edit_stage(session, type);
  auto edits = parse(std::get<std::string>(session.document().at(stage).options.get("edits")));
  for (auto& edit : more) {
    if (edit.author.empty()) edit.author = edit_author();
    if (edit.time.empty()) edit.time = edit_time();
    edits.push_back(std::move(edit));
  }
  const auto text = stems::to_json(edits);
  parse(text);
  session.set_option(stage, "edits", text);
}

}  // namespace bole::desktop
