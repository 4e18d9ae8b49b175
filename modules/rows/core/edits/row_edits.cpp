#include "rows/core/edits/row_edits.h"

#include <array>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace bole::rows {
namespace {

using Action = RowEdit::Action;

// In the order of RowEdit::Action.
const std::array<EditAction, 7>& actions() {
  static const std::array<EditAction, 7> table{{
      {"move", {"at", "from", "to"}, {}},
      {"add", {"from", "to"}, {"row_id"}},
      {"delete", {"at"}, {}},
      {"split", {"at"}, {}},
      {"merge", {"at", "with"}, {}},
      {"renumber", {"at", "row_id"}, {}},
      {"note", {"at", "text"}, {}},
  }};
  return table;
}

constexpr std::array<std::string_view, 1> common_keys{"was_angle_deg"};

void read_key(RowEdit& edit, const std::string& key, const EditJson& value) {
  if (key == "at") edit.at = edit_place(value, key);
  if (key == "from") edit.from = edit_place(value, key);
  if (key == "to") edit.to = edit_place(value, key);
  if (key == "was_angle_deg") edit.was_angle_deg = edit_number(value, key, -180, 180);
  if (key == "row_id") edit.row_id = value.is_number_integer() ? value.dump() : edit_text(value, key);
  if (key == "with")
    for (const auto& place : edit_list(value, key, 1)) edit.with.push_back(edit_place(place, key));
  if (key == "text") edit.text = edit_text(value, key);
}

void check(const RowEdit& edit) {
  if (edit.from && edit.to && !((*edit.from - *edit.to).norm() > 0.01))
    throw bad_input(std::string(action_name(edit.action)) + " has both ends at one place", "two ends that are apart");
  if (edit.action == Action::renumber && edit.row_id.empty()) throw bad_input("row_id is empty", "the new id");
}

EditJson object_of(const RowEdit& edit) {
  EditJson o{{"action", action_name(edit.action)}};
  if (edit.action != Action::add) o["at"] = edit_json(edit.at);
  if (edit.from) o["from"] = edit_json(*edit.from);
  if (edit.to) o["to"] = edit_json(*edit.to);
  for (const auto& p : edit.with) o["with"].push_back(edit_json(p));
  if (!edit.row_id.empty()) o["row_id"] = edit.row_id;
  if (edit.was_angle_deg) o["was_angle_deg"] = *edit.was_angle_deg;
  if (edit.action == Action::note) o["text"] = edit.text;
  put_edit_record(o, edit);
  return o;
}

}  // namespace

std::string_view action_name(Action action) { return actions()[static_cast<std::size_t>(action)].name; }

std::vector<RowEdit> parse_row_edits(std::string_view text) {
  std::vector<RowEdit> edits;
  read_edits(text, actions(), common_keys, [&](std::size_t action, const EditJson& object) {
    RowEdit edit;
    edit.action = static_cast<Action>(action);
    static_cast<EditRecord&>(edit) = edit_record(object);
    for (const auto& [key, value] : object.items()) read_key(edit, key, value);
    check(edit);
    edits.push_back(std::move(edit));
  });
  return edits;
}

std::string to_json(const std::vector<RowEdit>& edits) {
  EditJson list = EditJson::array();
  for (const auto& edit : edits) list.push_back(object_of(edit));
  return list.dump(2);
}

}  // namespace bole::rows
