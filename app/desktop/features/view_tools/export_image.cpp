#include "features/view_tools/export_image.h"

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QSpinBox>

#include "look/last_folder.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int min_width_px = 64, max_width_px = 12000, usual_scale = 2, export_section = 2;

void save_picture(Workbench* b, int width_px, bool transparent) {
  const QString path = note_folder(
      "export", QFileDialog::getSaveFileName(b, Workbench::tr("Save as picture"), in_last_folder("export", "view.png"),
                                             Workbench::tr("Pictures (*.png *.jpg *.tif)")));
  if (path.isEmpty()) return;
  if (!b->scene().picture(width_px, transparent).save(path))
    throw failure("the picture could not be written to " + path.toStdString(), "a folder that can be written, .png",
                  "Choose another place");
  b->say(Workbench::tr("Wrote %1").arg(path));
}

// The height follows from the shape of the view.
void ask_for_picture(Workbench* b) {
  QDialog dialog(b);
  dialog.setObjectName("picture_dialog");
  dialog.setWindowTitle(Workbench::tr("Save as picture"));
  auto* width = new QSpinBox;
  width->setRange(min_width_px, max_width_px);
  width->setSuffix(Workbench::tr(" px"));
  width->setValue(std::min(max_width_px, usual_scale * b->scene().width()));
  auto* transparent = new QCheckBox(Workbench::tr("Transparent background"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* form = new QFormLayout(&dialog);
  form->addRow(Workbench::tr("Width"), width);
  form->addRow(transparent);
  form->addRow(buttons);
  if (dialog.exec() == QDialog::Accepted) save_picture(b, width->value(), transparent->isChecked());
}

}  // namespace

void add_image_export(Workbench& bench) {
  auto* b = &bench;
  bench.commands().add(
      {.id = "view.export_image",
       .text = Workbench::tr("Save as picture…"),
       .key = QKeySequence("Ctrl+Shift+P"),
       .places = {in_menu(Menu::file, export_section), in_tool_bar("view_bar", 2), in_context("scene", 2)},
       .act = [b] { ask_for_picture(b); },
       .enabled_when = {[b] { return b->scene().has_survey(); },
                        Workbench::tr("Open a scan or a point cloud first.")}});
}

}  // namespace bole::desktop
