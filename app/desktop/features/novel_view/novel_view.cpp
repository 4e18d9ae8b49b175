#include "features/novel_view/novel_view.h"

#include "document/survey.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {

NovelView::NovelView(Workbench& bench) : QObject(&bench), bench_(bench), renderer_(new FieldRenderer(this)) {
  bench_.commands().add({.id = "field.show",
                         .text = tr("Show the trained field"),
                         .key = Qt::Key_F,
                         .places = {in_menu(Menu::view, 2)},
                         .turn = [this](bool on) { show(on); },
                         .enabled_when = {[this] { return bench_.runner().survey().field != nullptr; },
                                          tr("Run a pipeline that trains a field first.")},
                         .checked_when = [this] { return on_; },
                         .tip = tr("Renders the field from where you look, instead of the points")});
  connect(&bench_, &Workbench::survey_shown, this, [this](const Survey& survey) { take_field(survey.field); });
  connect(&bench_.scene(), &SceneView::eye_moved, this, &NovelView::ask);
  connect(renderer_, &FieldRenderer::rendered, this, [this](const std::shared_ptr<const FieldFrame>& frame) {
    if (!on_ || frame->number != number_) return;
    bench_.scene().show_rendering(frame->picture);
    Q_EMIT pictured(frame->coarseness);
  });
  connect(renderer_, &FieldRenderer::failed, this, [this](const QString& text) {
    show(false);
    bench_.complain(text);
  });
}

void NovelView::take_field(const std::shared_ptr<const Table>& field) {
  if (field == field_) return;
  field_ = field;
  renderer_->open(on_ ? field_ : nullptr);
  if (!field_) return show(false);
  if (on_) ask();
}

void NovelView::show(bool on) {
  const bool turned = on != on_;
  on_ = on;
  if (!on) {
    renderer_->cancel();
    bench_.scene().hide_rendering();
  } else {
    if (turned) renderer_->open(field_);
    ask();
  }
  bench_.commands().update();
}

void NovelView::ask() {
  if (!on_ || !field_) return;
  const auto eye = bench_.scene().eye();
  ++number_;
  if (!eye) {
    renderer_->cancel();
    return bench_.hint(tr("The field is shown in perspective. Parallel views show the points."));
  }
  renderer_->ask({.number = number_,
                  .T_world_camera = eye->T_world_camera,
                  .tan_half_height = eye->tan_half_height,
                  .width = eye->width_px,
                  .height = eye->height_px});
}

void install_novel_view(Workbench& bench) { new NovelView(bench); }

}  // namespace bole::desktop
