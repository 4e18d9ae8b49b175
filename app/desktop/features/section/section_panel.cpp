// What a person sees and presses of cross-sections: the dock, the commands, the file.
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "base/atomic_file.h"
#include "features/section/section.h"
#include "look/last_folder.h"
#include "look/pixels.h"
#include "views/scene_view.h"
#include "views/section_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr double min_width_m = 0.02, max_width_m = 50, usual_width_m = 1, usual_length_m = 12, max_length_m = 1000;
constexpr double file_dpi = 300;

QDoubleSpinBox* metres_box(const QString& suffix, const QString& tip, double value, double max) {
  auto* box = new QDoubleSpinBox;
  box->setRange(min_width_m, max);
  box->setSingleStep(0.5);
  box->setValue(value);
  box->setSuffix(suffix);
  box->setToolTip(tip);
  box->setKeyboardTracking(false);
  return box;
}

}  // namespace

void SectionTool::make_dock() {
  auto* panel = new QWidget(&bench_);
  width_ = metres_box(tr(" m wide"), tr("Width of the section: points up to half of it before and behind the line"),
                      usual_width_m, max_width_m);
  width_->setObjectName("section_width");
  length_ = metres_box(tr(" m long"), tr("Length of the line"), usual_length_m, max_length_m);
  length_->setObjectName("section_length");
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(4, 2, 4, 0);
  for (const char* id : {"section.draw", "section.previous", "section.next"}) {
    auto* button = new QToolButton;
    button->setDefaultAction(bench_.commands().action(id));
    button->setAutoRaise(true);
    bar->addWidget(button);
  }
  bar->addWidget(width_);
  bar->addWidget(length_);
  where_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a long text takes no room from the views
  bar->addWidget(where_, 1);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addLayout(bar);
  column->addWidget(view_, 1);
  dock_ = bench_.docks().add("section", tr("Cross-section"), panel, Qt::BottomDockWidgetArea, "stems");
  dock_->hide();  // until there is one
  const auto changed = QOverload<double>::of(&QDoubleSpinBox::valueChanged);
  connect(width_, changed, this, [this](double width_m) {
    if (!line_ || width_m == line_->width_m) return;
    line_->width_m = width_m;
    cut_soon();
  });
  connect(length_, changed, this, [this](double length_m) {
    if (!line_ || std::abs(length_m - line_->length_m()) < 0.006) return;  // what the box shows of it
    const Eigen::Vector2d middle = (line_->from + line_->to) / 2, half = length_m / 2 * line_->direction();
    put({middle - half, middle + half, line_->width_m}, false);
  });
}

void SectionTool::make_commands() {
  auto& commands = bench_.commands();
  const When with_line{[this] { return line_.has_value(); }, tr("Draw a cross-section first.")};
  const When with_walk{
      [this] { return bench_.runner().survey().walk && bench_.runner().survey().walk->poses.size() > 1; },
      tr("The survey has no walk.")};
  const When with_points{[this] { return bench_.scene().survey().points != nullptr; },
                         tr("Open a scan or a point cloud first.")};
  commands.add_submenu({.id = "section.menu", .title = tr("Cross-section"), .place = in_menu(Menu::tools, 1)});
  commands.add({.id = "section.draw",
                .text = tr("Draw a cross-section"),
                .key = Qt::Key_X,
                .places = {in_submenu("section.menu"), in_tool_bar("measure_bar"), in_context("scene", 1)},
                .turn = [this](bool on) { draw_line(on); },
                .enabled_when = with_points,
                .checked_when = [this] { return drawing_; }});
  const auto add = [&](const char* id, const QString& text, const char* key, const When& when,
                       const std::function<void()>& act) {
    commands.add({.id = id,
                  .text = text,
                  .key = QKeySequence(key),
                  .places = {in_submenu("section.menu"), in_context("section")},
                  .act = act,
                  .enabled_when = when});
  };
  add("section.next", tr("Next section"), "]", with_line, [this] { step(1); });
  add("section.previous", tr("Previous section"), "[", with_line, [this] { step(-1); });
  add("section.across_walk", tr("Sections across the walk"), "Shift+W", with_walk, [this] { across_walk(); });
  add("section.across_row", tr("Sections across the selected row"), "", bench_.with_row(), [this] { across_row(); });
  add("section.along_row", tr("Section along the selected row"), "", bench_.with_row(), [this] { along_row(); });
  add("section.whole", tr("Whole section"), "", with_line, [this] { view_->show_whole(); });
  add("section.save", tr("Save the section…"), "", with_line, [this] {
    const QString path = note_folder(
        "export", QFileDialog::getSaveFileName(&bench_, tr("Save the section"), in_last_folder("export", "section.png"),
                                               tr("Figures (*.png *.svg *.pdf)")));
    if (path.isEmpty()) return;
    save(path);
    bench_.say(tr("Wrote %1").arg(path));
  });
  add("section.clear", tr("Remove the section"), "", with_line, [this] { clear(); });
  commands.give_context_menu(*view_, "section");
}

void SectionTool::show_where() {
  QString text;
  if (line_ && !path_.empty())
    text = tr("%1 m of %2 m").arg(at_m_, 0, 'f', 1).arg(path_length_m(path_), 0, 'f', 1);
  else if (line_)
    text = tr("(%1, %2) to (%3, %4)")
               .arg(line_->from.x(), 0, 'f', 1)
               .arg(line_->from.y(), 0, 'f', 1)
               .arg(line_->to.x(), 0, 'f', 1)
               .arg(line_->to.y(), 0, 'f', 1);
  if (line_ && view_->section() && view_->section()->found > view_->section()->indices.size())
    text += "   " + tr("%1 of %2 points").arg(view_->section()->indices.size()).arg(view_->section()->found);
  where_->setText(text);
}

void SectionTool::save(const QString& path) const {
  const auto figure = view_->figure(view_->width() * mm_per_px, view_->height() * mm_per_px, file_dpi);
  const QString ending = QFileInfo(path).suffix().toLower();
  write_text_file(path.toStdString(), ending == "svg"   ? render::figure_svg(figure)
                                      : ending == "pdf" ? render::figure_pdf(figure)
                                                        : render::figure_png(figure, file_dpi));
}

}  // namespace bole::desktop
