#include "features/point_edit/point_editor.h"

#include <QDockWidget>
#include <QVariant>

#include "document/edit_list.h"
#include "features/point_edit/point_panel.h"
#include "features/point_edit/selected_points.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

const std::string selection_layer = "point_selection";
constexpr int points_section = 2;     // of the menu Tools
constexpr double stroke_step = 0.25;  // of the radius: places of a stroke that are closer say nothing new

// A tenth of a millimetre: edits stay short texts, and the region that is shown is the one that is kept.
Eigen::Vector3d rounded_place(const Eigen::Vector3d& place) { return (place * 1e4).array().round() / 1e4; }

}  // namespace

PointEditor::PointEditor(Workbench& bench) : QObject(&bench), bench_(bench) {
  make_commands();
  panel_ = new PointPanel(bench_.commands(), &bench_);
  dock_ = bench_.docks().add("points", tr("Edit points"), panel_, Qt::RightDockWidgetArea, "profile");
  dock_->hide();  // until a tool is taken
  auto& scene = bench_.scene();
  connect(&scene, &SceneView::outline_taken, this, &PointEditor::take_outline);
  connect(&scene, &SceneView::stroke_taken, this, &PointEditor::take_stroke);
  connect(&scene, &SceneView::stroke_ended, this, &PointEditor::select_again);
  connect(&scene, &SceneView::place_taken, this, [this](const Eigen::Vector3d& place, const QVariant&) {
    if (tool_ == Tool::box) take_place(place);
  });
  connect(&scene, &SceneView::place_taker_changed, this, [this](const QObject* taker) {
    if (taker == this || !tool_) return;
    tool_.reset();
    drop();
    bench_.hint({});
  });
  connect(panel_, &PointPanel::changed, this, [this] {
    if (tool_ == Tool::box && box_at_) put_box();
    for (auto& region : regions_)
      if (region.kind == PointRegion::Kind::brush) region.radius = panel_->brush_radius_m();
    select_again();
  });
  connect(&bench_.selection(), &Selection::changed, this, &PointEditor::select_again);
  connect(&bench_, &Workbench::document_opened, this, [this] {
    stop();
    drop();
  });
  connect(&bench_, &Workbench::survey_shown, this, &PointEditor::select_again);
}

bool PointEditor::ready() const {
  return points_can_be_edited(bench_.session()) && bench_.runner().survey().points != nullptr;
}

void PointEditor::make_commands() {
  auto& commands = bench_.commands();
  commands.add_submenu(
      {.id = "points.menu", .title = tr("Edit points"), .place = in_menu(Menu::tools, points_section)});
  const When can{[this] { return ready(); },
                 tr("Run a pipeline first that has points and a stage that takes edits of them.")};
  const When with_selection{[this] { return !regions_.empty(); }, tr("Select points first.")};
  const auto add_tool = [&](const char* id, const QString& text, const QString& short_text, const char* key, Tool tool,
                            const QString& tip) {
    commands
        .add({.id = id,
              .text = text,
              .key = QKeySequence(key),
              .places = {in_submenu("points.menu"), in_tool_bar("measure_bar", 1), in_context("scene", 1)},
              .turn = [this, tool](bool on) { on ? start(tool) : stop(); },
              .enabled_when = can,
              .checked_when = [this, tool] { return tool_ == tool; },
              .tip = tip})
        ->setIconText(short_text);
  };
  add_tool("points.brush", tr("Select points with a brush"), tr("Brush"), "Shift+U", Tool::brush,
           tr("Paint over points with the left mouse button. Enter applies, Escape ends."));
  add_tool("points.polygon", tr("Select points with a polygon"), tr("Polygon"), "Shift+P", Tool::polygon,
           tr("Click the corners, or draw around the points. All that is seen within is selected, at any depth; in the "
              "cross-section as deep as it is wide."));
  add_tool("points.box", tr("Select points with a box"), tr("Box"), "Shift+O", Tool::box,
           tr("Click its middle; sizes and turn stand in the form."));
  const auto add = [&](const char* id, const QString& text, const QString& short_text, const QKeySequence& key,
                       const std::function<void()>& act) {
    commands
        .add({.id = id,
              .text = text,
              .key = key,
              .places = {in_submenu("points.menu", 1)},
              .act = act,
              .enabled_when = with_selection})
        ->setIconText(short_text);
  };
  add("points.apply", tr("Apply to the selected points"), tr("Apply"), Qt::Key_Return, [this] { apply(); });
  add("points.drop", tr("Drop the selection of points"), tr("Drop"), QKeySequence(), [this] { drop(); });
}

void PointEditor::start(Tool tool) {
  if (!ready()) throw bad_input("no points can be edited", "a run of a pipeline with the stage survey.edit_points");
  using Takes = SceneView::Takes;
  drop();
  tool_ = tool;
  bench_.scene().set_place_taker(this, tool == Tool::brush     ? Takes::strokes
                                       : tool == Tool::polygon ? Takes::corners
                                                               : Takes::places);
  bench_.docks().raise("points");
  bench_.hint(tool == Tool::brush     ? tr("Paint over points with the left mouse button. Enter applies, Escape ends.")
              : tool == Tool::polygon ? tr("Click corners or draw around the points. Enter applies, Escape ends.")
                                      : tr("Click the middle of the box. Enter applies, Escape ends."));
  bench_.commands().update();
}

void PointEditor::stop() {
  if (tool_) bench_.scene().set_place_taker(nullptr);
}

void PointEditor::drop() {
  regions_.clear();
  box_at_.reset();
  bench_.scene().drop_outline();
  select_again();
}

// What the clip box hides is not selected.
PointRegion PointEditor::region(PointRegion::Kind kind) const {
  PointRegion region;
  region.kind = kind;
  if (const auto& clip = bench_.scene().settings().clip)
    region.within = Eigen::AlignedBox3d(rounded_place(clip->lo), rounded_place(clip->hi));
  return region;
}

void PointEditor::take_outline(const SceneOutline& outline) {
  if (tool_ != Tool::polygon) return;
  auto drawn = region(PointRegion::Kind::outline);
  for (const auto& corner : outline.corners) drawn.outline.push_back(rounded_place(corner));
  if (outline.eye) drawn.eye = rounded_place(*outline.eye);
  if (outline.half_depth_m) drawn.depth = Eigen::Vector2d(-*outline.half_depth_m, *outline.half_depth_m);
  const RegionTest test(drawn);
  if (test.flat()) return;
  if (test.crosses_itself()) {
    bench_.say(tr("The outline crosses itself: draw it again."));
    return drop();
  }
  regions_ = {std::move(drawn)};
  select_again();
}

void PointEditor::take_stroke(const Eigen::Vector3d& place, bool begins) {
  if (tool_ != Tool::brush) return;
  if (begins) {
    regions_.push_back(region(PointRegion::Kind::brush));
    regions_.back().radius = panel_->brush_radius_m();
  }
  if (regions_.empty()) return;
  auto& path = regions_.back().path;
  if (!path.empty() && (place - path.back()).norm() < stroke_step * regions_.back().radius) return;
  path.push_back(rounded_place(place));
  draw();
}

void PointEditor::take_place(const Eigen::Vector3d& place) {
  box_at_ = rounded_place(place);
  put_box();
  select_again();
}

void PointEditor::put_box() {
  auto box = region(PointRegion::Kind::box);
  const Eigen::Vector3d half = panel_->box_size_m() / 2;
  box.min = *box_at_ - half;
  box.max = *box_at_ + half;
  box.turn_deg = panel_->box_turn_deg();
  regions_ = {std::move(box)};
}

void PointEditor::select_again() {
  const auto& survey = bench_.scene().survey();
  const auto choice = panel_->choice();
  std::optional<std::int32_t> only;
  if (choice == PointChoice::free) only = 0;
  if (choice == PointChoice::selected_tree) only = static_cast<std::int32_t>(bench_.selection().tree().value_or(-1));
  selected_ =
      survey.points && !regions_.empty() ? points_within(*survey.points, regions_, only) : std::vector<std::uint32_t>();
  bench_.scene().mark_points(selected_);
  panel_->show_state(regions_.empty() ? QString() : tr("Points selected: %1").arg(selected_.size()));
  bench_.commands().update();
  draw();
}

void PointEditor::draw() {
  std::vector<SceneDrawing> drawings;
  for (const auto& region : regions_) {
    SceneDrawing d;
    d.lines = lines_of(region);
    d.strong = true;
    drawings.push_back(std::move(d));
  }
  bench_.scene().set_drawings(selection_layer, std::move(drawings));
}

Eigen::Vector2d PointEditor::selected_tree() const {
  const auto tree = bench_.selection().tree();
  const auto& survey = bench_.runner().survey();
  const auto row = tree ? survey.row_of(*tree) : std::nullopt;
  if (!row)
    throw bad_input("no tree is selected", "the one that the points belong to", "Click it in the view or in the table");
  return {survey.stems->numbers("x_m")[*row], survey.stems->numbers("y_m")[*row]};
}

std::vector<PointEdit> PointEditor::edits() const {
  const auto target = panel_->target();
  PointEdit edit;
  edit.action = target == PointTarget::ground    ? PointEdit::Action::to_ground
                : target == PointTarget::noise   ? PointEdit::Action::to_noise
                : target == PointTarget::no_tree ? PointEdit::Action::to_no_tree
                                                 : PointEdit::Action::to_tree;
  if (target == PointTarget::selected_tree) edit.tree = selected_tree();
  if (target == PointTarget::new_tree) edit.tree = stem_among(*bench_.scene().survey().points, selected_);
  edit.only_free = panel_->choice() == PointChoice::free;
  if (panel_->choice() == PointChoice::selected_tree) edit.only_tree = selected_tree();
  std::vector<PointEdit> edits;
  for (const auto& region : regions_) {
    edits.push_back(edit);
    edits.back().region = region;
  }
  return edits;
}

void PointEditor::apply() {
  if (selected_.empty())
    throw bad_input("no point is selected", "points in the brush, the polygon or the box",
                    "Select points that are drawn, or choose other points under Only");
  const auto list = edits();
  const auto changed = selected_;
  if (panel_->target() == PointTarget::new_tree) {
    stems::StemEdit add;
    add.action = stems::StemEdit::Action::add;
    add.at = list.front().tree;
    check_stems_can_be_edited(bench_.session());
    parse_point_edits(to_json(list));  // refuses what cannot be kept before anything is changed
    auto& undo = bench_.session().undo_stack();
    undo.beginMacro(tr("new tree of points"));
    add_edits(bench_.session(), std::vector{add});
    add_edits(bench_.session(), list);
    undo.endMacro();
  } else {
    add_edits(bench_.session(), list);
  }
  bench_.say(tr("Points given: %1").arg(changed.size()));
  drop();
  recolour(list.front(), changed);
}

// At once; the run that follows says the same, and what the trees measure now.
void PointEditor::recolour(const PointEdit& edit, const std::vector<std::uint32_t>& points) {
  auto survey = bench_.scene().survey();
  std::optional<std::int32_t> tree = edit.action == PointEdit::Action::to_tree ? std::nullopt : std::optional(0);
  if (panel_->target() == PointTarget::selected_tree && edit.action == PointEdit::Action::to_tree)
    tree = static_cast<std::int32_t>(*bench_.selection().tree());
  if (panel_->target() == PointTarget::new_tree) tree = free_tree_id(*survey.points);
  survey.points = relabelled(*survey.points, points, tree, edit);
  bench_.scene().show_survey(survey);
}

void install_point_edit(Workbench& bench) { new PointEditor(bench); }

}  // namespace bole::desktop
