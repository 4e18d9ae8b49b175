// What a person changed about the rows of a table: a JSON list of edits, kept beside the pipeline and applied again
// after every run. Stems and plant rows have actions of their own; reading, checking and writing are the same.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.h"
#include "base/option.h"

namespace bole {
inline namespace cloud {

// Who made an edit, when (ISO 8601) and why.
struct EditRecord {
  std::string author, time, reason;
};

// An action by its name in the JSON text, with the keys that it must have and those that it may have.
struct EditAction {
  std::string_view name;
  std::vector<std::string_view> needed, allowed;
};

using EditJson = nlohmann::ordered_json;

// Values of an edit. Each throws Error{bad_input} that names the key, what it holds and what was needed.
double edit_number(const EditJson& value, const std::string& key, double min, double max);
Eigen::Vector2d edit_place(const EditJson& value, const std::string& key);  // [x, y], metres
const EditJson& edit_list(const EditJson& value, const std::string& key, std::size_t min_size);
std::string edit_text(const EditJson& value, const std::string& key);
EditJson edit_json(const Eigen::Vector2d& place);

// Reads a JSON list of edits. `read` gets each edit: the index of its action in `actions` and its keys, of which those
// in `common` (besides action, author, time and reason) are allowed for every action. Throws Error{bad_input} that
// names the edit by its number: text that is no JSON, unknown actions or keys, keys that an action needs and lacks.
void read_edits(std::string_view text, std::span<const EditAction> actions, std::span<const std::string_view> common,
                const std::function<void(std::size_t action, const EditJson& object)>& read);

// The author, time and reason of an edit, from and to its JSON object. Empty texts are left out.
EditRecord edit_record(const EditJson& object);
void put_edit_record(EditJson& object, const EditRecord& record);

// The text of a file with a JSON list of edits. Throws Error{bad_input}.
std::string read_edit_file(const std::string& path);

// The edits in a file (none when the path is empty) and after them those of `text`, both read by `parse`. What is wrong
// with the file names it.
template <class Parse>
auto edits_of(const std::string& path, std::string_view text, const Parse& parse) {
  std::decay_t<decltype(parse(text))> edits;
  if (!path.empty()) {
    const auto content = read_edit_file(path);
    try {
      edits = parse(content);
    } catch (const Error& e) {
      throw e.at(path);
    }
  }
  const auto more = parse(text);
  edits.insert(edits.end(), more.begin(), more.end());
  return edits;
}

// The options of a stage that takes edits, which edits_of() joins. `S` has the members `edits` and `file`, both
// std::string.
template <class S>
Option<S, std::string> edits_option() {
  return {"edits", &S::edits,   TextKind::json,
          {},      Tier::basic, "The edits as a JSON list, applied after those of the file."};
}

template <class S>
Option<S, std::string> edit_file_option() {
  return {"file", &S::file, TextKind::input_path, {}, Tier::basic, "A file with a JSON list of edits."};
}

}  // namespace cloud
}  // namespace bole
