#include "features/pictures/pictures.h"

#include <QDockWidget>
#include <QHeaderView>
#include <QTableView>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "features/pictures/picture_panel.h"
#include "panels/table_model.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr double picture_share = 0.4, picture_tall = 0.6;  // of the window

const pipeline::StageNode* view_stage(const pipeline::PipelineDocument& document) {
  for (const auto& node : document.stages()) {
    const auto gives = [](const auto& port) { return port.kind == DataKind::views; };
    if (node.type->inputs.empty() && std::ranges::any_of(node.type->outputs, gives) && !node.skipped()) return &node;
  }
  return nullptr;
}

// Columns of `tracking` that a list of views takes over.
constexpr const char* tracking_numbers[] = {"matches", "inliers", "residual_px", "residual_depth_mm"};

}  // namespace

std::shared_ptr<const Table> view_table(const ViewSource& views, const Trajectory* poses, const Table* tracking) {
  std::vector<std::int64_t> number;
  std::vector<std::string> name, state;
  std::vector<double> time_s;
  std::map<std::string, std::size_t> rows;  // of tracking, by name
  if (tracking != nullptr && tracking->has("name") && tracking->has("state"))
    for (std::size_t i = 0; i < tracking->rows(); ++i) rows.emplace(tracking->text("name", i), i);
  std::vector<std::optional<std::size_t>> row;
  for (std::size_t i = 0; i < views.size(); ++i) {
    number.push_back(static_cast<std::int64_t>(i) + 1);
    name.push_back(views.name(i));
    time_s.push_back(views.time_s(i));
    const auto it = rows.find(name.back());
    row.push_back(it == rows.end() ? std::nullopt : std::optional(it->second));
    const bool placed = poses != nullptr && pose_of_view(*poses, time_s.back()).has_value();
    state.push_back(row.back() ? tracking->text("state", *row.back()) : placed ? "pose" : "no pose");
  }
  auto table = std::make_shared<Table>();
  table->set("view", number);
  table->set("name", name);
  table->set("time_s", time_s);
  table->set("state", state);
  for (const char* column : tracking_numbers) {
    if (rows.empty() || !tracking->has(column)) continue;
    const auto from = tracking->numbers(column);
    std::vector<double> values;
    for (const auto& r : row) values.push_back(r ? from[*r] : std::numeric_limits<double>::quiet_NaN());
    const bool whole = std::ranges::all_of(values, [](double v) { return v == std::round(v); });
    if (whole)
      table->set(column, std::vector<std::int64_t>(values.begin(), values.end()));
    else
      table->set(column, values);
  }
  return table;
}

Pictures::Pictures(Workbench& bench) : QObject(&bench), bench_(bench), reader_(new PictureReader(this)) {
  make_docks();
  make_commands();
  auto& session = bench_.session();
  connect(&session, &Session::document_replaced, this, &Pictures::open_views);
  connect(&session, &Session::option_changed, this, &Pictures::open_views);
  connect(&bench_, &Workbench::survey_shown, this, &Pictures::show_survey);
  connect(&bench_.selection(), &Selection::view_changed, this, &Pictures::follow_selection);
  connect(reader_, &PictureReader::opened, this, &Pictures::take_views);
  connect(reader_, &PictureReader::failed, this, [this](const QString& text) {
    panel_->show_failure(text);
    bench_.complain(text);
  });
  connect(reader_, &PictureReader::picture_read, this, [this](const std::shared_ptr<const Picture>& picture) {
    if (bench_.selection().view() != picture->index) return;
    panel_->show_picture(picture);
    bench_.scene().show_picture(picture->index, picture->view.color);
  });
  connect(panel_, &PicturePanel::partner_changed, this, &Pictures::ask);
  connect(panel_, &PicturePanel::view_wanted, this,
          [this](int view) { bench_.selection().select_view(static_cast<std::size_t>(view)); });
}

void Pictures::make_docks() {
  model_ = new TableModel(this);
  list_ = new QTableView(&bench_);
  list_->setObjectName("view_list");
  list_->setModel(model_);
  list_->setSelectionBehavior(QAbstractItemView::SelectRows);
  list_->setSelectionMode(QAbstractItemView::SingleSelection);
  list_->setAlternatingRowColors(true);
  list_->verticalHeader()->hide();
  list_->verticalHeader()->setDefaultSectionSize(list_->fontMetrics().height() + 6);
  panel_ = new PicturePanel(&bench_);
  bench_.docks().add("views", tr("Views"), list_, Qt::BottomDockWidgetArea, "stems");
  bench_.docks().add("picture", tr("Picture"), panel_, Qt::RightDockWidgetArea, "slice");
  for (const char* id : {"views", "picture"}) bench_.docks().find(id)->hide();  // until there are views
  connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
    if (!following_ && current.isValid()) bench_.selection().select_view(static_cast<std::size_t>(current.row()));
  });
}

void Pictures::make_commands() {
  constexpr int section = 2;  // of the menu View
  const When with_views{[this] { return views_ != nullptr; }, tr("Open a folder of views first.")};
  const auto add = [&](const char* id, const QString& text, const char* key, const std::function<void()>& act) {
    bench_.commands().add({.id = id,
                           .text = text,
                           .key = QKeySequence(key),
                           .places = {in_menu(Menu::view, section), in_context("view")},
                           .act = act,
                           .enabled_when = with_views});
  };
  add("picture.next", tr("Next view"), "Alt+Right", [this] { step(1); });
  add("picture.previous", tr("Previous view"), "Alt+Left", [this] { step(-1); });
  add("picture.fit", tr("Whole picture"), "", [this] { panel_->canvas().fit(); });
  bench_.commands().give_context_menu(*list_, "view");
}

void Pictures::step(int by) {
  if (!views_ || views_->size() == 0) return;
  const auto last = static_cast<std::ptrdiff_t>(views_->size()) - 1;
  const auto here = static_cast<std::ptrdiff_t>(bench_.selection().view().value_or(0));
  bench_.selection().select_view(static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(here + by, 0, last)));
}

// Not before something of the stage that reads views has changed: options of other stages change often.
void Pictures::open_views() {
  const auto* node = view_stage(bench_.session().document());
  std::string wanted = bench_.session().path().toStdString();
  if (node)
    for (const auto& spec : node->type->options->specs) wanted += "\n" + option_text(node->options.get(spec.name));
  else
    wanted.clear();
  if (wanted == opened_) return;
  opened_ = wanted;
  views_.reset();
  panel_->clear();
  model_->show(nullptr);
  bench_.scene().set_cameras({});
  bench_.selection().select_view({});
  reader_->open(node);
  if (!node) return;
  bench_.docks().raise("views");
  bench_.docks().raise("picture");
  bench_.resizeDocks({bench_.docks().find("picture")}, {static_cast<int>(picture_share * bench_.width())},
                     Qt::Horizontal);
  bench_.resizeDocks({bench_.docks().find("picture")}, {static_cast<int>(picture_tall * bench_.height())},
                     Qt::Vertical);
}

void Pictures::take_views(const std::shared_ptr<const ViewSource>& views) {
  views_ = views;
  panel_->set_views(views);
  follow();
  bench_.commands().update();
}

void Pictures::show_survey(const Survey& survey) {
  // Poses of the data and those that are estimated may have other axes, and the first points may be those of a room.
  const bool first = survey.poses && !survey_.poses;
  const bool more = survey.points && survey.points != survey_.points && !bench_.scene().camera_moved();
  survey_ = survey;
  if (!views_) return;
  follow();
  if (first || more) bench_.scene().reset_camera();
}

const Trajectory* Pictures::poses() const {
  if (survey_.poses && !survey_.poses->empty()) return survey_.poses.get();
  return views_ && !views_->given_poses().empty() ? &views_->given_poses() : nullptr;
}

void Pictures::follow() {
  const auto* path = poses();
  following_ = true;
  model_->show(view_table(*views_, path, survey_.tracking.get()));
  list_->resizeColumnsToContents();
  following_ = false;
  std::vector<render::CameraShape> cameras;
  for (std::size_t i = 0; path != nullptr && i < views_->size(); ++i)
    if (const auto pose = pose_of_view(*path, views_->time_s(i)))
      cameras.push_back({i, *pose, views_->camera(i).color});
  bench_.scene().set_cameras(std::move(cameras));
  panel_->set_tables(survey_.view_matches, survey_.contours);
  if (!bench_.selection().view() && views_->size() > 0) return bench_.selection().select_view(0);
  follow_selection();
}

void Pictures::follow_selection() {
  const auto view = bench_.selection().view();
  following_ = true;
  if (view && static_cast<int>(*view) < model_->rowCount()) {
    list_->selectRow(static_cast<int>(*view));
    list_->scrollTo(model_->index(static_cast<int>(*view), 0));
  } else {
    list_->clearSelection();
  }
  following_ = false;
  if (!view || !views_ || *view >= views_->size()) return;
  panel_->show_view(*view);
  ask();
}

void Pictures::ask() {
  const auto view = bench_.selection().view();
  if (!view || !views_ || *view >= views_->size()) return;
  PictureWish wish{.index = *view, .other = panel_->partner(), .T_world_camera = {}, .cloud = survey_.points};
  if (const auto* path = poses()) wish.T_world_camera = pose_of_view(*path, views_->time_s(*view));
  reader_->ask(std::move(wish));
}

void install_pictures(Workbench& bench) { new Pictures(bench); }

}  // namespace bole::desktop
