// What a person can do with clouds beside the survey.
#include "features/clouds/cloud_align_page.h"
#include "features/clouds/cloud_difference_page.h"
#include "features/clouds/cloud_jobs.h"
#include "features/clouds/cloud_pairs.h"
#include "features/clouds/cloud_panel.h"
#include "features/clouds/clouds.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int cloud_section = 0;  // of the menu File

}  // namespace

void Clouds::make_commands() {
  auto& commands = bench_.commands();
  const auto chosen = [this] { return panel_ == nullptr ? nullptr : find(panel_->current()); };
  const When with_cloud{[chosen] { return chosen() != nullptr; }, tr("Select a cloud in the panel Clouds first.")};
  const When with_read{[chosen] { return chosen() != nullptr && chosen()->read != nullptr; },
                       tr("Select a cloud in the panel Clouds first.")};
  commands.add({.id = "clouds.add",
                .text = tr("Add a cloud to look at…"),
                .key = QKeySequence("Ctrl+Shift+A"),
                .places = {in_menu(Menu::file, cloud_section), in_context("clouds")},
                .act = [this] { ask_for_files(); },
                .enabled_when = bench_.with_document(),
                .tip = tr("Another point cloud beside the survey: drawn, measured and cut, never computed with")});
  commands.add({.id = "clouds.show",
                .text = tr("Show the cloud"),
                .places = {in_context("clouds")},
                .turn = [this](bool on) { show(panel_->current(), on); },
                .enabled_when = with_cloud,
                .checked_when = [chosen] { return chosen() != nullptr && chosen()->visible; }});
  commands.add({.id = "clouds.in_cuts",
                .text = tr("Clouds in slice and profile"),
                .places = {in_menu(Menu::view, 1), in_context("clouds")},
                .turn = [this](bool on) { show_in_cuts(on); },
                .checked_when = [this] { return in_cuts(); },
                .tip = tr("The points of the clouds that are drawn, in their colours, beside those of the survey")});
  commands.add({.id = "clouds.zoom",
                .text = tr("Zoom to the cloud"),
                .places = {in_context("clouds")},
                .act = [this] { zoom_to(panel_->current()); },
                .enabled_when = {[this, chosen] { return chosen() != nullptr && is_drawn(panel_->current()); },
                                 tr("Select a cloud that is drawn first.")}});
  commands.add({.id = "clouds.move_here",
                .text = tr("Move the cloud to the survey"),
                .places = {in_context("clouds")},
                .act = [this] { move_here(panel_->current()); },
                .enabled_when = with_read,
                .tip = tr("By the coordinate system where both have one, else centre onto centre; its numbers can be "
                          "changed afterwards")});
  commands.add({.id = "clouds.remove",
                .text = tr("Remove the cloud"),
                .places = {in_context("clouds")},
                .act = [this] { remove(panel_->current()); },
                .enabled_when = with_cloud,
                .tip = tr("From the list; its file stays")});
  commands.add({.id = "clouds.cancel",
                .text = tr("Cancel the reading"),
                .places = {in_context("clouds", 1)},
                .act = [this] { cancel_reading(); },
                .enabled_when = {[this] { return reading(); }, tr("No cloud is being read.")}});
}

void Clouds::make_align_commands() {
  auto& commands = bench_.commands();
  const auto current = [this] { return panel_ == nullptr ? 0 : panel_->current(); };
  const auto with_pair = [this, current] { return current() != 0 && panel_->align().selected_pair() >= 0; };
  const When free{[this, current] { return current() != 0 && find(current())->read && !jobs_->busy(); },
                  tr("Select a cloud that was read, and wait until other work on clouds has ended.")};
  commands.add(
      {.id = "clouds.pick_pairs",
       .text = tr("Pick pairs of points"),
       .places = {in_context("clouds", 1)},
       .turn = [this, current](bool on) { on ? pairs_->start(current()) : pairs_->stop(); },
       .enabled_when = {[this, current] { return current() != 0 && is_drawn(current()); },
                        tr("Select a cloud that is drawn first.")},
       .checked_when = [this] { return pairs_->picking(); },
       .tip = tr("Click a point of the cloud and the point of the survey, or of another cloud, that it belongs "
                 "to; three pairs or more")});
  commands.add({.id = "clouds.remove_pair",
                .text = tr("Remove the pair of points"),
                .places = {in_context("clouds", 1)},
                .act = [this, current] { pairs_->remove(current(), panel_->align().selected_pair()); },
                .enabled_when = {with_pair, tr("Select a pair of points in the panel Clouds first.")},
                .tip = tr("From the list; the cloud stays where it is")});
  commands.add(
      {.id = "clouds.clear_pairs",
       .text = tr("Remove all pairs of points"),
       .places = {in_context("clouds", 1)},
       .act = [this, current] { pairs_->clear(current()); },
       .enabled_when = {[this, current] { return !pairs_->of(current()).empty(); }, tr("There is no pair of points.")},
       .tip = tr("From the list; the cloud stays where it is")});
  commands.add({.id = "clouds.move_by_pairs",
                .text = tr("Move the cloud by the pairs of points"),
                .places = {in_context("clouds", 1)},
                .act = [this, current] { pairs_->move(current()); },
                .enabled_when = {[this, current] { return pairs_->solve(current()).fit.has_value(); },
                                 tr("Pick three pairs of points or more that are not on a line.")},
                .tip = tr("Least squares over the ticked pairs; one step that can be undone")});
  commands.add(
      {.id = "clouds.fit_finely",
       .text = tr("Fit the cloud finely"),
       .places = {in_context("clouds", 1)},
       .act = [this, current] { jobs_->register_finely(current(), panel_->align().onto(), panel_->align().reach_m()); },
       .enabled_when = free,
       .tip = tr("From a place that is roughly right: moves and turns the cloud until its points lie on the "
                 "surfaces of the other one. It stays where it is when they do not come to fit")});
  commands.add(
      {.id = "clouds.measure_distances",
       .text = tr("Measure the distances of the cloud"),
       .places = {in_context("clouds", 1)},
       .act = [this,
               current] { jobs_->measure(current(), panel_->difference().from(), panel_->difference().options()); },
       .enabled_when = free,
       .tip = tr("How far each point of the cloud lies from the nearest point of the survey or of another "
                 "cloud; the points are coloured by it")});
  commands.add({.id = "clouds.export_histogram",
                .text = tr("Export the histogram of the distances…"),
                .places = {in_context("clouds", 1)},
                .act =
                    [this, current] {
                      const auto name = histogram_name(*find(current()), panel_->difference().of_height());
                      OfferedFigures::of(bench_).export_one(name);
                    },
                .enabled_when = {[this, current] { return current() != 0 && find(current())->distances; },
                                 tr("Measure the distances of the cloud first.")},
                .tip = tr("As PNG, SVG or PDF, of the size that you choose")});
  commands.add({.id = "clouds.save",
                .text = tr("Save the cloud as it is shown…"),
                .places = {in_context("clouds", 1)},
                .act = [this, current] { ask_where_to_save(current()); },
                .enabled_when = free,
                .tip = tr("Where it is placed, with the distances that were measured; its file stays as it is")});
  commands.add({.id = "clouds.cancel_work",
                .text = tr("Cancel the work on clouds"),
                .places = {in_context("clouds", 1)},
                .act = [this] { jobs_->cancel(); },
                .enabled_when = {[this] { return jobs_->busy(); }, tr("No work on clouds is under way.")},
                .tip = tr("Clouds stay as they are")});
}

}  // namespace bole::desktop
