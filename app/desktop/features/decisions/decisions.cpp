// Every edit that the document holds, in one list: what, where, by whom, when and why, and whether it still fits.
// Single ones are taken back, which the menu Edit cannot do: it goes back step by step.
#include <QHeaderView>
#include <QTreeWidget>

#include "document/edit_list.h"
#include "look/finding_words.h"
#include "running/runner.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr double stem_reach_m = 0.5;
constexpr int outcome_column = 5;

class Decisions : public QTreeWidget {
 public:
  explicit Decisions(Workbench& bench) : QTreeWidget(&bench), bench_(bench) {
    setObjectName("decisions");
    setHeaderLabels({Workbench::tr("Decision"), Workbench::tr("Place"), Workbench::tr("By"), Workbench::tr("At"),
                     Workbench::tr("Reason"), Workbench::tr("Outcome")});
    setRootIsDecorated(false);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    bench_.docks().add("decisions", Workbench::tr("Decisions"), this, Qt::BottomDockWidgetArea, "stems");
    const When chosen{[this] { return !selectedItems().isEmpty(); }, Workbench::tr("Choose decisions in the list.")};
    bench_.commands().add({.id = "decisions.take_back",
                           .text = Workbench::tr("Take back the chosen decisions"),
                           .places = {in_context("decisions")},
                           .act = [this] { remove_edits(bench_.session(), chosen_entries()); },
                           .enabled_when = chosen});
    bench_.commands().add({.id = "decisions.show",
                           .text = Workbench::tr("Go to its place"),
                           .places = {in_context("decisions")},
                           .act = [this] { go_to(chosen_entries().front()); },
                           .enabled_when = chosen});
    bench_.commands().give_context_menu(*this, "decisions");
    connect(&bench_.session().undo_stack(), &QUndoStack::indexChanged, this, &Decisions::fill);
    connect(&bench_.session(), &Session::document_replaced, this, &Decisions::fill);
    connect(&bench_.runner(), &Runner::finished, this, &Decisions::show_outcomes);
    connect(this, &QTreeWidget::itemSelectionChanged, &bench_, [this] { bench_.commands().update(); });
    connect(this, &QTreeWidget::itemDoubleClicked, this,
            [this](QTreeWidgetItem* item) { go_to(entries_[static_cast<std::size_t>(indexOfTopLevelItem(item))]); });
    fill();
  }

 private:
  void fill() {
    clear();
    entries_ = listed_edits(bench_.session());
    for (const auto& entry : entries_)
      new QTreeWidgetItem(this, {entry.what, place_words(entry), entry.author, entry.time, entry.reason});
    show_outcomes();
  }

  // Of the last run. What does not fit stands out, and the choice in the list stays.
  void show_outcomes() {
    tell_outcomes(entries_, bench_.runner().results());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      auto* item = topLevelItem(static_cast<int>(i));
      auto weight = font();
      weight.setBold(entries_[i].applied == false);
      item->setFont(outcome_column, weight);
      item->setText(outcome_column, outcome_words(entries_[i]));
    }
  }

  static QString outcome_words(const EditEntry& entry) {
    if (!entry.applied) return Workbench::tr("not run yet");
    const auto words = *entry.applied ? Workbench::tr("applied") : Workbench::tr("does not fit");
    return entry.message.isEmpty() ? words : words + ": " + finding_words(entry.message);
  }

  static QString place_words(const EditEntry& entry) {
    const auto at = entry.stem    ? entry.stem
                    : entry.place ? std::optional<Eigen::Vector2d>(entry.place->head<2>())
                                  : std::nullopt;
    return at ? QString("%1, %2").arg(at->x(), 0, 'f', 2).arg(at->y(), 0, 'f', 2) : QString();
  }

  std::vector<EditEntry> chosen_entries() const {
    std::vector<EditEntry> chosen;
    for (auto* item : selectedItems()) chosen.push_back(entries_[static_cast<std::size_t>(indexOfTopLevelItem(item))]);
    return chosen;
  }

  // The stem there is selected; a deleted one is gone.
  void go_to(const EditEntry& entry) {
    auto& scene = bench_.scene();
    if (entry.place) return scene.zoom_to(*entry.place);
    if (!entry.stem) return bench_.say(Workbench::tr("This decision has no place."));
    double nearest_m = stem_reach_m;
    std::optional<std::int64_t> tree;
    for (const auto& shape : scene.stem_shapes())
      if (const double d = (shape.breast_height.head<2>() - *entry.stem).norm(); d <= nearest_m) {
        nearest_m = d;
        tree = shape.tree_id;
      }
    if (!tree) return bench_.say(Workbench::tr("No stem stands there any more."));
    const SceneView::Hold one_frame(scene);
    bench_.selection().select(tree);
    scene.zoom_to_tree(*tree);
  }

  Workbench& bench_;
  std::vector<EditEntry> entries_;
};

}  // namespace

void install_decisions(Workbench& bench) { new Decisions(bench); }

}  // namespace bole::desktop
