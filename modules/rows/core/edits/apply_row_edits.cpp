#include "rows/core/edits/apply_row_edits.h"

#include <fmt/format.h>

#include <algorithm>

#include "rows/core/edits/editable_rows.h"
#include "rows/core/edits/edited_tables.h"

namespace bole::rows {
namespace {

using Action = RowEdit::Action;

struct Log {
  std::vector<std::int64_t> edit;
  std::vector<std::string> action, row_id, outcome, message, author, time, reason;
  std::vector<double> x, y;

  void add(const RowEdit& e, const EditOutcome& what, bool applied) {
    const Eigen::Vector2d at = e.action == Action::add ? *e.from : e.at;
    edit.push_back(std::ssize(edit) + 1);
    action.emplace_back(action_name(e.action));
    row_id.push_back(what.row_id);
    x.push_back(at.x());
    y.push_back(at.y());
    outcome.emplace_back(applied ? "applied" : "conflict");
    message.push_back(what.note);
    author.push_back(e.author);
    time.push_back(e.time);
    reason.push_back(e.reason);
  }

  Table table() && {
    Table t;
    t.set("edit", std::move(edit)), t.set("action", std::move(action)), t.set("row_id", std::move(row_id));
    t.set("x_m", std::move(x)), t.set("y_m", std::move(y));
    t.set("outcome", std::move(outcome)), t.set("message", std::move(message));
    t.set("author", std::move(author)), t.set("time", std::move(time)), t.set("reason", std::move(reason));
    return t;
  }
};

// Rows that an earlier stage of edits changed stay edited.
void set_states(const EditableRows& field, Table& rows) {
  std::vector<std::string> state = rows.has("state") ? rows.texts("state") : std::vector<std::string>(rows.rows());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const auto it = std::ranges::find(field.rows, rows.text("row_id", i), &EditableRow::id);
    if (it != field.rows.end() && it->edited)
      state[i] = "edited";
    else if (state[i].empty())
      state[i] = "auto";
  }
  rows.set("state", std::move(state));
}

}  // namespace

EditedRows apply_row_edits(const FoundRows& found, const std::vector<RowEdit>& edits, const RowEditOptions& options,
                           const Run& run) {
  EditableRows field = editable_rows(found);
  Log log;
  Report warnings;
  std::int64_t applied = 0;
  bool changed = false;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    run.check_cancel();
    const auto warn = [&](const std::string& what) {
      warnings.warn(fmt::format("edit {} ({}){}", i + 1, action_name(edits[i].action), what));
    };
    try {
      const auto outcome = apply_row_edit(field, edits[i], options);
      changed |= edits[i].action != Action::note;
      log.add(edits[i], outcome, true);
      ++applied;
      if (!outcome.note.empty()) warn(": " + outcome.note);
    } catch (const EditConflict& conflict) {
      log.add(edits[i], {"", conflict.why}, false);
      warn(" is not applied: " + conflict.why);
    }
  }
  EditedRows out;
  out.found = changed ? edited_tables(field, found, options, run) : found;
  out.log = std::move(log).table();
  set_states(field, out.found.rows);
  auto& r = out.found.report;
  r.warnings.insert(r.warnings.begin(), warnings.warnings.begin(), warnings.warnings.end());
  if (!r.warnings.empty()) r.status = Status::warning;
  r.counts["edits"] = std::ssize(edits);
  r.counts["applied"] = applied;
  r.counts["conflicts"] = std::ssize(edits) - applied;
  r.counts["rows"] = static_cast<std::int64_t>(out.found.rows.rows());
  r.message = edits.empty() ? "no edits" : fmt::format("{} of {} edits applied", applied, edits.size());
  return out;
}

}  // namespace bole::rows
