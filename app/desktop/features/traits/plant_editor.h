// What a person corrects on a plant, in the 3-D view and in a form: base of the stem, height of its measurement, points
// that are not of the plant, values, and whether the plant is accepted. All of it becomes edits of the document.
#pragma once

#include <QObject>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.h"
#include "document/survey.h"
#include "features/traits/trait_drawings.h"
#include "plant/core/edits/plant_edits.h"
#include "views/scene_outline.h"

namespace bole::desktop {

class PlantForm;
class Workbench;

class PlantEditor : public QObject {
  Q_OBJECT

 public:
  PlantEditor(Workbench& bench, PlantForm& form);

  // Each is one step of undo, after which the plant is measured again. Metres in world axes. Throw bole::Error.
  void set_base(const Eigen::Vector3d& base);
  void set_stem_height(double height);  // above the soil
  void cut(const PointRegion& region);
  void give_value(const std::string& trait, double value_mm);
  void decide(plant::PlantEdit::Action action, const std::string& note = {});  // accept, reject, note

  // What the next click, or the next outline, in the view is for.
  enum class Task { base, outline };
  void start(Task task);
  void stop();
  std::optional<Task> task() const { return task_; }

  bool handles_shown() const { return handles_; }
  void show_handles(bool on);

 private:
  void make_commands();
  void add_tool(const char* id, const QString& text, const QString& short_text, const char* key, Task task);
  void show_survey(const Survey& survey);
  void apply_form();
  void ask_for_value();
  void take_outline(const SceneOutline& outline);
  void drag(const QString& id, const Eigen::Vector3d& at, bool released);
  void draw();
  double height_of(const Eigen::Vector3d& place) const;  // above the base
  Eigen::Vector3d stem_at(double height) const;
  Eigen::Vector3d on_soil(const Eigen::Vector3d& place) const;
  double stem_height_mm() const;  // NaN where nothing was measured
  bool measured() const;

  Workbench& bench_;
  PlantForm& form_;
  Survey survey_;
  TraitPlaces places_;
  // Where the handles are: of the survey, or where somebody drags them.
  std::optional<Eigen::Vector3d> base_;
  double height_mm_ = 0;
  std::optional<Task> task_;
  bool handles_ = false;
};

}  // namespace bole::desktop
