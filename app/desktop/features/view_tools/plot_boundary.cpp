#include "features/view_tools/plot_boundary.h"

#include <cmath>

#include "document/stage_roles.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

const std::string boundary_layer = "boundary";
constexpr const char *plot_port = "plot", *centre_options[] = {"x", "y"};
constexpr int boundary_section = 1;  // of the menu Tools
constexpr double centimetres_per_metre = 100;

}  // namespace

PlotBoundary::PlotBoundary(Workbench& bench) : QObject(&bench), bench_(bench) {
  make_commands();
  connect(&bench_, &Workbench::document_opened, this, [this] { edited_ = false; });
  connect(&bench_, &Workbench::survey_shown, this, &PlotBoundary::show_survey);
  connect(&bench_.scene(), &SceneView::grip_dragged, this,
          [this](const QString& layer, int, int, const Eigen::Vector3d& at, bool released) {
            if (layer.toStdString() != boundary_layer) return;
            if (released)
              bench_.guarded([&] { move_to(at.head<2>()); });
            else
              draw(at.head<2>());
          });
}

void PlotBoundary::make_commands() {
  bench_.commands().add({.id = "plot.boundary",
                         .text = tr("Move the plot boundary"),
                         .places = {in_menu(Menu::tools, boundary_section)},
                         .turn = [this](bool on) { edit(on); },
                         .enabled_when = {[this] { return area_ && stage() != nullptr; },
                                          tr("Run a pipeline with a stage that gives the plot its boundary.")},
                         .checked_when = [this] { return edited_; },
                         .tip = tr("Drag its centre; shape and size are options of the stage")});
}

const pipeline::StageNode* PlotBoundary::stage() const {
  if (!bench_.session().has_document()) return nullptr;
  const auto* found = stage_with_output(bench_.session().document(), plot_port);
  if (found == nullptr) return nullptr;
  for (const char* option : centre_options)
    if (found->type->options->find(option) == nullptr) return nullptr;
  return found;
}

void PlotBoundary::show_survey(const Survey& survey) {
  area_.reset();
  if (survey.plot && survey.plot->facts.contains("shape")) {
    const auto rule = counting_rule(*survey.plot);
    if (rule.area.shape != PlotArea::Shape::none) area_ = rule.area;
  }
  bench_.commands().update();
  draw();
}

void PlotBoundary::edit(bool on) {
  edited_ = on;
  draw();
  if (on) bench_.hint(tr("Drag the centre of the plot."));
}

void PlotBoundary::move_to(const Eigen::Vector2d& centre) {
  const auto* node = stage();
  if (node == nullptr || !area_)
    throw bad_input("the plot has no boundary", "a stage that gives it one, and a run", "Press Run");
  if (area_->shape == PlotArea::Shape::polygon) {
    draw();
    throw bad_input("the boundary is a polygon from a file", "a rectangle or a circle",
                    "Change its vertices in the file");
  }
  if ((centre - area_->centre).norm() < 1 / centimetres_per_metre) return draw();
  auto after = bench_.session().document();
  for (auto& other : after.stages())
    for (int axis = 0; other.id == node->id && axis < 2; ++axis) {
      const double rounded = std::round(centre[axis] * centimetres_per_metre) / centimetres_per_metre;
      other.options.set(centre_options[axis], rounded);
      other.given.insert(centre_options[axis]);
    }
  bench_.session().change(tr("move the plot boundary"), std::move(after));
  bench_.refresh();
}

void PlotBoundary::draw(const std::optional<Eigen::Vector2d>& centre) {
  std::vector<SceneDrawing> drawings;
  if (area_) {
    const double z = bench_.scene().whole().lo.z();
    const Eigen::Vector2d shift = centre ? Eigen::Vector2d(*centre - area_->centre) : Eigen::Vector2d::Zero();
    SceneDrawing d;
    d.id = boundary_layer;
    d.lines.emplace_back();
    for (const auto& p : area_->outline()) d.lines.back().emplace_back(p.x() + shift.x(), p.y() + shift.y(), z);
    if (!d.lines.back().empty()) d.lines.back().push_back(d.lines.back().front());
    d.strong = edited_;
    d.grips = {{area_->centre.x() + shift.x(), area_->centre.y() + shift.y(), z}};
    drawings.push_back(std::move(d));
  }
  bench_.scene().set_drawings(boundary_layer, std::move(drawings));
}

}  // namespace bole::desktop
