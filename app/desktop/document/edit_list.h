// Edits that a person makes are a list in the option `edits` of a stage of the document.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "cloud/core/regions/point_edits.h"
#include "document/session.h"
#include "document/survey.h"
#include "plant/core/edits/plant_edits.h"
#include "rows/core/edits/row_edits.h"
#include "slam/core/edits/loop_edits.h"
#include "stems/core/edits/stem_edits.h"

namespace bole::desktop {

// Adds edits to the list as one step of undo. Edits without author and time get those of now. Throw bole::Error when
// the document has no stage that takes such edits, and when an edit is not valid.
void add_edits(Session& session, const std::vector<stems::StemEdit>& edits);
void add_edits(Session& session, const std::vector<rows::RowEdit>& edits);
void add_edits(Session& session, const std::vector<plant::PlantEdit>& edits);
void add_edits(Session& session, const std::vector<slam::LoopEdit>& edits);
void add_edits(Session& session, const std::vector<PointEdit>& edits);

// One edit that the document holds.
struct EditEntry {
  std::string port;                      // of the stage that applies it: "stems", "rows", "point_edits", ...
  std::size_t index = 0;                 // in the list of that stage
  QString what;                          // in words
  std::optional<Eigen::Vector2d> stem;   // the place of the stem that is meant, metres in the axes of the stems
  std::optional<Eigen::Vector3d> place;  // of the points that are meant, metres in world axes
  QString author, time, reason;
  std::optional<bool> applied;  // by the run that tell_outcomes() was given; none when it did not have the edit
  QString message;              // of the stage: why it was not, or what it did
};

// Of all stages, each list in the order in which it is applied.
std::vector<EditEntry> listed_edits(const Session& session);
// What became of each in a run, by the logs of the stages that apply edits: an edit is known by author, time and place.
void tell_outcomes(std::vector<EditEntry>& entries, const Results& results);
// Takes edits out of their lists, as one step of undo.
void remove_edits(Session& session, const std::vector<EditEntry>& entries);

// Throw bole::Error when the document has no stage that takes such edits.
void check_stems_can_be_edited(const Session& session);
void check_rows_can_be_edited(const Session& session);

bool plant_can_be_edited(const Session& session);
bool points_can_be_edited(const Session& session);

}  // namespace bole::desktop
