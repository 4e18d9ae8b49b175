#include "features/view_tools/view_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "features/view_tools/range_slider.h"
#include "look/array_words.h"
#include "look/scrolled_page.h"
#include "render/draw/color_maps.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

QDoubleSpinBox* number_box(const char* id, const QString& tip, double step, int decimals, const QString& unit) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(id);
  box->setToolTip(tip);
  box->setRange(-1e8, 1e8);
  box->setSingleStep(step);
  box->setDecimals(decimals);
  box->setSuffix(unit);
  box->setKeyboardTracking(false);
  box->setMinimumWidth(box->fontMetrics().horizontalAdvance("000000.00 m"));  // not that of the widest number
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return box;
}

QCheckBox* check(const char* id, const QString& text, const QString& tip) {
  auto* box = new QCheckBox(text);
  box->setObjectName(id);
  box->setToolTip(tip);
  return box;
}

QWidget* row_of(std::initializer_list<QWidget*> widgets) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  for (auto* widget : widgets) layout->addWidget(widget);
  return row;
}

QPushButton* button(const char* id, const QString& text, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(id);
  made->setToolTip(tip);
  return made;
}

constexpr double percent = 100;

const auto changed = QOverload<double>::of(&QDoubleSpinBox::valueChanged);

}  // namespace

template <class Change>
void ViewPanel::change(Change change) {
  if (following_) return;
  auto settings = scene_.settings();
  change(settings);
  scene_.set_settings(settings);
  Q_EMIT scene_.settings_changed();  // this panel and the menu show it
}

ViewPanel::ViewPanel(SceneView& scene, QWidget* parent) : QWidget(parent), scene_(scene) {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  make_color_rows(form);
  make_height_rows(form);
  make_clip_rows(form);
  make_switches(form);
  fill_with_scrolled(*this, page);
  connect(&scene_, &SceneView::settings_changed, this, &ViewPanel::show_state);
  connect(&scene_, &SceneView::index_built, this, &ViewPanel::show_state);
  show_state();
}

void ViewPanel::make_color_rows(QFormLayout* form) {
  color_ = new QComboBox;
  color_->setObjectName("view_color");
  color_->setToolTip(tr("The array of the cloud that gives points their colour"));
  color_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(color_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { scene_.color_by(color_->currentData().toString().toStdString()); });
  form->addRow(tr("Colour"), color_);
  map_ = new QComboBox;
  map_->setObjectName("view_map");
  map_->setToolTip(tr("The colours of numbers; the legend shows them"));
  map_->addItem(tr("Usual"), QString());
  const QString titles[] = {tr("Green to yellow (viridis)"), tr("Blue to yellow (cividis)"), tr("Rainbow (turbo)"),
                            tr("Grey"), tr("Blue to red (diverging)")};
  const auto names = render::color_map_names();
  for (std::size_t k = 0; k < names.size(); ++k)
    map_->addItem(titles[k], QString::fromUtf8(names[k].data(), static_cast<int>(names[k].size())));
  map_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(map_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { change([this](auto& s) { s.color_map = map_->currentData().toString().toStdString(); }); });
  form->addRow(tr("Colour map"), map_);
  range_lo_ = number_box("view_range_lo", tr("Takes the first colour of the map"), 0.5, 2, {});
  range_hi_ = number_box("view_range_hi", tr("Takes the last colour of the map"), 0.5, 2, {});
  auto* automatic = button("view_range_auto", tr("Auto"), tr("The range of the middle 96 % of the values"));
  for (auto* box : {range_lo_, range_hi_}) connect(box, changed, this, &ViewPanel::take_range);
  connect(automatic, &QPushButton::clicked, this, [this] { change([](auto& s) { s.color_range.reset(); }); });
  form->addRow(tr("Range"), row_of({range_lo_, range_hi_, automatic}));
  point_size_ = number_box("view_point_size", tr("Size of a point on the screen"), 1, 0, tr(" px"));
  point_size_->setRange(1, 12);
  connect(point_size_, changed, this, [this](double px) { change([px](auto& s) { s.point_size_px = px; }); });
  form->addRow(tr("Point size"), point_size_);
}

void ViewPanel::make_height_rows(QFormLayout* form) {
  heights_ = new RangeSlider;
  heights_->setObjectName("view_heights");
  heights_->setToolTip(tr("Heights above ground that are drawn; drag the middle to move the layer"));
  height_lo_ = number_box("view_height_lo", tr("Minimum height above ground that is drawn"), 0.1, 2, tr(" m"));
  height_hi_ = number_box("view_height_hi", tr("Maximum height above ground that is drawn"), 0.1, 2, tr(" m"));
  auto* all = button("view_heights_all", tr("All"), tr("Draws all heights"));
  connect(heights_, &RangeSlider::dragged, this,
          [this](const render::Interval& range) { take_heights(range.lo, range.hi); });
  for (auto* box : {height_lo_, height_hi_})
    connect(box, changed, this, [this] { take_heights(height_lo_->value(), height_hi_->value()); });
  connect(all, &QPushButton::clicked, this, &ViewPanel::reset_heights);
  form->addRow(tr("Heights"), heights_);
  form->addRow(QString(), row_of({height_lo_, height_hi_, all}));
}

void ViewPanel::make_clip_rows(QFormLayout* form) {
  clip_ = check("view_clip", tr("Clip box"), tr("Draws only what lies within a box"));
  handles_ = check("view_clip_handles", tr("Handles"), tr("Drag the faces of the box in the view"));
  auto* reset = button("view_clip_reset", tr("Reset"), tr("The box around the whole cloud"));
  connect(clip_, &QCheckBox::toggled, this, [this](bool on) {
    if (!following_) set_clip(on);
  });
  connect(handles_, &QCheckBox::toggled, this, [this](bool on) {
    if (!following_) scene_.show_clip_handles(on);
  });
  connect(reset, &QPushButton::clicked, this, &ViewPanel::reset_clip);
  form->addRow(row_of({clip_, handles_, reset}));
  const char* const ids[] = {"view_west", "view_east", "view_south", "view_north", "view_foot", "view_top"};
  const QString tips[] = {tr("Minimum x"), tr("Maximum x"), tr("Minimum y"),
                          tr("Maximum y"), tr("Minimum z"), tr("Maximum z")};
  for (std::size_t k = 0; k < box_.size(); ++k) {
    box_[k] = number_box(ids[k], tips[k], 0.5, 2, tr(" m"));
    connect(box_[k], changed, this, &ViewPanel::take_clip);
  }
  form->addRow(tr("x"), row_of({box_[0], box_[1]}));
  form->addRow(tr("y"), row_of({box_[2], box_[3]}));
  form->addRow(tr("z"), row_of({box_[4], box_[5]}));
}

void ViewPanel::make_switches(QFormLayout* form) {
  bool ViewSettings::*const members[] = {&ViewSettings::eye_dome,  &ViewSettings::grid,  &ViewSettings::legend,
                                         &ViewSettings::scale_bar, &ViewSettings::north, &ViewSettings::trees};
  switches_ = {
      check("view_eye_dome", tr("Eye-dome shading"), tr("Darkens hollows when the view rests: shapes stand out")),
      check("view_grid", tr("Grid"), tr("A grid in metres at the foot of the cloud")),
      check("view_legend", tr("Legend"), tr("What the colours mean")),
      check("view_scale", tr("Scale bar"), tr("In metres; holds everywhere in parallel projection")),
      check("view_north_arrow", tr("North arrow"), {}),
      check("view_trees", tr("Tree numbers"), tr("With symbols for the quality of the diameter and what was decided"))};
  for (std::size_t k = 0; k < switches_.size(); ++k) {
    connect(switches_[k], &QCheckBox::toggled, this,
            [this, member = members[k]](bool on) { change([=](auto& s) { s.*member = on; }); });
    form->addRow(switches_[k]);
  }
  terrain_ = check("view_terrain", tr("Terrain with contour lines"), {});
  connect(terrain_, &QCheckBox::toggled, this, [this](bool on) { change([on](auto& s) { s.terrain = on; }); });
  form->addRow(terrain_);
  make_map_row(form);
}

void ViewPanel::make_map_row(QFormLayout* form) {
  ground_ = check("view_ground", tr("Map behind"), {});
  ground_opacity_ =
      number_box("view_ground_opacity", tr("Opacity of the map; less lets the background through"), 5, 0, tr(" %"));
  ground_opacity_->setRange(5, percent);
  connect(ground_, &QCheckBox::toggled, this, [this](bool on) { change([on](auto& s) { s.map = on; }); });
  connect(ground_opacity_, changed, this, [this](double v) { change([v](auto& s) { s.map_opacity = v / percent; }); });
  form->addRow(row_of({ground_, ground_opacity_}));
  on_terrain_ = check("view_on_terrain", tr("Map on the terrain"), {});
  connect(on_terrain_, &QCheckBox::toggled, this,
          [this](bool on) { change([on](auto& s) { s.map_on_terrain = on; }); });
  form->addRow(on_terrain_);
}

void ViewPanel::show_terrain() {
  const bool there = scene_.survey().terrain != nullptr;
  terrain_->setEnabled(there);
  terrain_->setChecked(there && scene_.settings().terrain);
  terrain_->setToolTip(
      there ? tr("The terrain model as a surface, with the tints of the report; holes stay open. Over a map that "
                 "follows the terrain, the contour lines alone")
            : tr("The survey has no terrain model yet."));
}

// Without a map there is nothing to set.
void ViewPanel::show_map() {
  const bool there = scene_.map() != nullptr;
  ground_->setEnabled(there);
  ground_->setChecked(there && scene_.settings().map);
  ground_->setToolTip(there ? tr("The picture of the place below the survey")
                            : tr("Open a map first: File > Map behind the survey."));
  ground_opacity_->setEnabled(there && scene_.settings().map);
  ground_opacity_->setValue(percent * scene_.settings().map_opacity);
  const bool terrain = scene_.survey().terrain != nullptr;
  on_terrain_->setEnabled(there && scene_.settings().map && terrain);
  on_terrain_->setChecked(scene_.settings().map_on_terrain);
  on_terrain_->setToolTip(terrain
                              ? tr("The map follows hills and hollows. Otherwise it is flat, at the foot of the cloud")
                              : tr("The survey has no terrain model yet."));
}

void ViewPanel::take_range() {
  const render::Interval range{range_lo_->value(), std::max(range_hi_->value(), range_lo_->value() + 1e-3)};
  change([&](auto& s) { s.color_range = range; });
}

void ViewPanel::take_heights(double lo, double hi) {
  change([&](auto& s) { s.filter.height = {std::min(lo, hi), std::max(lo, hi)}; });
}

void ViewPanel::reset_heights() {
  change([](auto& s) { s.filter = {}; });
}

void ViewPanel::set_clip(bool on) {
  change([&](auto& s) { s.clip = on ? std::optional(scene_.whole()) : std::nullopt; });
  scene_.show_clip_handles(on);
  show_state();
}

void ViewPanel::reset_clip() {
  change([&](auto& s) { s.clip = scene_.everything(); });
  scene_.show_clip_handles(true);
  show_state();
}

void ViewPanel::take_clip() {
  render::ClipBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = 2 * static_cast<std::size_t>(axis);
    box.lo[axis] = std::min(box_[k]->value(), box_[k + 1]->value());
    box.hi[axis] = std::max(box_[k]->value(), box_[k + 1]->value());
  }
  change([&](auto& s) { s.clip = box; });
}

void ViewPanel::show_state() {
  const auto& s = scene_.settings();
  following_ = true;
  color_->clear();
  for (const auto& array : scene_.colorable()) color_->addItem(array_words(array), QString::fromStdString(array));
  color_->setCurrentIndex(color_->findData(QString::fromStdString(scene_.paint().array)));
  const bool numbers = scene_.paint().kind == render::PointPaint::Kind::map;
  for (auto* box : {range_lo_, range_hi_}) box->setEnabled(numbers);
  map_->setEnabled(numbers);
  map_->setCurrentIndex(map_->findData(QString::fromStdString(s.color_map)));
  range_lo_->setValue(scene_.paint().range.lo);
  range_hi_->setValue(scene_.paint().range.hi);
  point_size_->setValue(s.point_size_px);
  const auto limits = scene_.heights();
  heights_->set_limits(limits);
  heights_->set_range(s.filter.height);
  height_lo_->setValue(std::max(s.filter.height.lo, limits.lo));
  height_hi_->setValue(std::min(s.filter.height.hi, limits.hi));
  clip_->setChecked(s.clip.has_value());
  handles_->setEnabled(s.clip.has_value());
  handles_->setChecked(scene_.clip_handles_shown());
  const auto box = s.clip ? *s.clip : scene_.whole();
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = 2 * static_cast<std::size_t>(axis);
    box_[k]->setValue(box.lo[axis]);
    box_[k + 1]->setValue(box.hi[axis]);
    box_[k]->setEnabled(s.clip.has_value());
    box_[k + 1]->setEnabled(s.clip.has_value());
  }
  const bool on[] = {s.eye_dome, s.grid, s.legend, s.scale_bar, s.north, s.trees};
  for (std::size_t k = 0; k < switches_.size(); ++k) switches_[k]->setChecked(on[k]);
  show_north();
  show_terrain();
  show_map();
  following_ = false;
}

// What is not drawn is not offered, and the box says why.
void ViewPanel::show_north() {
  auto* north = switches_[north_switch];
  const bool unknown = scene_.survey().points && !scene_.north_known();
  north->setEnabled(!unknown);
  if (unknown) north->setChecked(false);
  north->setToolTip(unknown
                        ? tr("Not drawn: nothing tells where north is in this cloud. The axes of its file or sensor "
                             "are not those of a plot or of a coordinate system.")
                        : tr("Where the axes of the plot are known"));
}

}  // namespace bole::desktop
