#include "features/traits/traits.h"

#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "features/traits/plant_editor.h"
#include "features/traits/plant_form.h"
#include "features/traits/trait_drawings.h"
#include "panels/table_model.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int max_needed_px = 400;  // of the width of a laptop
const std::string traits_layer = "traits";

QString text_of(const Table& table, const char* column) {
  return table.has(column) ? QString::fromStdString(table.text(column, 0)) : QString();
}

}  // namespace

Traits::Traits(Workbench& bench) : QObject(&bench), bench_(bench) {
  make_dock();
  editor_ = new PlantEditor(bench_, *form_);
  connect(&bench_, &Workbench::document_opened, this, [this] { raised_ = false; });
  connect(&bench_, &Workbench::survey_shown, this, &Traits::show_survey);
  bench_.commands().add({.id = "traits.draw",
                         .text = tr("Draw traits on the plant"),
                         .places = {in_menu(Menu::view, 2)},
                         .turn =
                             [this](bool on) {
                               drawn_ = on;
                               show_survey(bench_.runner().survey());
                             },
                         .checked_when = [this] { return drawn_; }});
}

void Traits::make_dock() {
  tabs_ = new QTabWidget(&bench_);
  tabs_->setObjectName("trait_tabs");
  tabs_->setDocumentMode(true);
  const auto add = [this](const char* name, const QString& title, const std::vector<QWidget*>& below = {}) {
    auto* model = new TableModel(this);
    auto* table = new QTableView(tabs_);
    table->setObjectName(name);
    table->setModel(model);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setAlternatingRowColors(true);
    table->verticalHeader()->hide();
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 6);
    models_.push_back(model);
    if (below.empty()) {
      tabs_->addTab(table, title);
      return;
    }
    auto* both = new QWidget(tabs_);
    auto* layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(table, 1);
    for (auto* widget : below) layout->addWidget(widget);
    auto* scroll = new QScrollArea(tabs_);  // the form is large: a laptop shows a part of it
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(both);
    const int whole_px = both->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width();
    scroll->setMinimumWidth(std::min(whole_px, max_needed_px));
    tabs_->addTab(scroll, title);
  };
  how_ = new QLabel(tabs_);
  how_->setObjectName("trait_notes");
  how_->setContentsMargins(6, 2, 6, 4);
  how_->setWordWrap(true);
  form_ = new PlantForm(tabs_);
  add("trait_table", tr("Traits"), {how_, form_});
  add("leaf_table", tr("Leaves"));
  add("internode_table", tr("Internodes"));
  add("stem_sections", tr("Sections of the stem"));
  add("plant_edits", tr("Edits"));
  bench_.docks().add("traits", tr("Traits"), tabs_, Qt::RightDockWidgetArea, "profile");
  bench_.docks().find("traits")->hide();  // until there are traits
}

void Traits::show_survey(const Survey& survey) {
  models_[0]->show(trait_rows(survey.traits.get()));
  models_[1]->show(survey.leaves);
  models_[2]->show(survey.internodes);
  models_[3]->show(survey.stem);
  models_[4]->show(survey.traits ? survey.edit_log : nullptr);
  for (int i = 1; i < tabs_->count(); ++i)
    tabs_->setTabEnabled(i, models_[static_cast<std::size_t>(i)]->rowCount() > 0);
  QStringList notes;
  if (survey.traits && survey.traits->rows() > 0) {
    if (const QString method = text_of(*survey.traits, "stem_method"); !method.isEmpty())
      notes << tr("Stem measured by: %1").arg(method);
    if (text_of(*survey.traits, "scale") == "unknown") notes << tr("The scale is not known: sizes are relative.");
  }
  how_->setText(notes.join("   "));
  how_->setVisible(!notes.isEmpty());
  bench_.scene().set_drawings(traits_layer, drawn_ ? trait_drawings(survey) : std::vector<SceneDrawing>());
  if (survey.traits && !std::exchange(raised_, true)) bench_.docks().raise("traits");
}

void install_traits(Workbench& bench) { new Traits(bench); }

}  // namespace bole::desktop
