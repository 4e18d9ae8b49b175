#include "features/traits/plant_form.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "commands/commands.h"

namespace bole::desktop {
namespace {

constexpr double place_reach_m = 1000, place_step_m = 0.001, max_height_mm = 1e4;
constexpr int place_decimals = 4, height_decimals = 1;

QWidget* form_row(QWidget* parent) {
  auto* row = new QWidget(parent);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  return row;
}

QDoubleSpinBox* place_box(const QString& name, const QString& tip, QWidget* parent) {
  auto* made = new QDoubleSpinBox(parent);
  made->setObjectName(name);
  made->setToolTip(tip);
  made->setKeyboardTracking(false);
  made->setMinimumWidth(made->fontMetrics().horizontalAdvance("-0.00000 mm") + 24);
  return made;
}

void command_button(QWidget* row, const Commands& commands, const char* id) {
  auto* button = new QToolButton(row);
  button->setObjectName(QString(id).replace('.', '_'));
  button->setDefaultAction(commands.action(id));
  button->setFocusPolicy(Qt::StrongFocus);
  row->layout()->addWidget(button);
}

}  // namespace

PlantForm::PlantForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
  form_->setContentsMargins(6, 4, 6, 4);
  form_->setVerticalSpacing(4);
  make_place_rows();
  cut_row_ = form_row(this);
  becomes_ = new QComboBox(cut_row_);
  becomes_->setObjectName("cut_becomes");
  becomes_->setToolTip(tr("What the points become that are outlined or lie in the clip box"));
  const auto offer = [this](const QString& text, plant::Part part) { becomes_->addItem(text, static_cast<int>(part)); };
  offer(tr("not of the plant"), plant::Part::other);
  offer(tr("noise"), plant::Part::floater);
  offer(tr("of the plant"), plant::Part::plant);
  cut_row_->layout()->addWidget(becomes_);
  form_->addRow(tr("Points are"), cut_row_);
  decide_row_ = form_row(this);
  form_->addRow(tr("Plant"), decide_row_);
  state_ = new QLabel(this);
  state_->setObjectName("plant_state");
  state_->setWordWrap(true);
  form_->addRow(state_);
  show_places({}, std::nan(""));
}

void PlantForm::make_place_rows() {
  base_row_ = form_row(this);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const QString name(QChar("xyz"[axis]));
    base_[axis] = place_box("base_" + name, tr("%1 of the place where the stem leaves the soil").arg(name), base_row_);
    base_[axis]->setRange(-place_reach_m, place_reach_m);
    base_[axis]->setDecimals(place_decimals);
    base_[axis]->setSingleStep(place_step_m);
    base_[axis]->setSuffix(" m");
    base_row_->layout()->addWidget(base_[axis]);
    connect(base_[axis], QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &PlantForm::follow);
  }
  form_->addRow(tr("Base of the stem"), base_row_);
  auto* row = form_row(this);
  height_ = place_box("stem_height", tr("Height above the soil at which the diameter of the stem is measured"), row);
  height_->setRange(1, max_height_mm);
  height_->setDecimals(height_decimals);
  height_->setSuffix(" mm");
  row->layout()->addWidget(height_);
  apply_ = new QPushButton(tr("Measure again"), row);
  apply_->setObjectName("apply_places");
  apply_->setToolTip(tr("Takes base and height over and measures the plant again"));
  row->layout()->addWidget(apply_);
  static_cast<QHBoxLayout*>(row->layout())->addStretch();
  form_->addRow(tr("Stem measured at"), row);
  connect(height_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &PlantForm::follow);
  connect(apply_, &QPushButton::clicked, this, &PlantForm::apply_asked);
}

void PlantForm::add_buttons(const Commands& commands) {
  command_button(base_row_, commands, "plant.pick_base");
  command_button(base_row_, commands, "plant.handles");
  command_button(cut_row_, commands, "plant.outline");
  command_button(cut_row_, commands, "plant.cut_box");
  for (const char* id : {"plant.accept", "plant.reject", "plant.set_value", "plant.note"})
    command_button(decide_row_, commands, id);
  for (auto* row : {base_row_, cut_row_, decide_row_}) static_cast<QHBoxLayout*>(row->layout())->addStretch();
}

void PlantForm::show_places(const std::optional<Eigen::Vector3d>& base, double stem_height_mm) {
  const bool known = base && std::isfinite(stem_height_mm);
  for (int axis = 0; axis < 3; ++axis) {
    auto* b = base_[static_cast<std::size_t>(axis)];
    const QSignalBlocker quiet(b);
    b->setValue(known ? (*base)[axis] : 0);
    b->setEnabled(known);
    shown_base_[axis] = b->value();
  }
  const QSignalBlocker quiet(height_);
  height_->setValue(known ? stem_height_mm : 0);
  height_->setEnabled(known);
  shown_height_mm_ = height_->value();
  follow();
}

void PlantForm::show_state(const Survey& survey) {
  QStringList words;
  if (survey.traits && survey.traits->rows() > 0 && survey.traits->has("state"))
    words << tr("State: %1").arg(QString::fromStdString(survey.traits->text("state", 0)));
  if (const auto* log = survey.edit_log.get(); log != nullptr && log->rows() > 0 && log->has("outcome")) {
    const auto& outcomes = log->texts("outcome");
    const auto conflicts = std::ranges::count(outcomes, "conflict");
    words << tr("%n edit(s)", nullptr, static_cast<int>(outcomes.size()));
    if (conflicts > 0) words << tr("%n no longer fit", nullptr, static_cast<int>(conflicts));
    const auto last = log->rows() - 1;
    words << QString::fromStdString(log->text("action", last) + ": " + log->text("outcome", last) +
                                    (log->text("message", last).empty() ? "" : ", " + log->text("message", last)));
  }
  state_->setText(words.join("   "));
  state_->setVisible(!words.isEmpty());
}

void PlantForm::follow() { apply_->setEnabled(new_base().has_value() || new_stem_height_mm().has_value()); }

std::optional<Eigen::Vector3d> PlantForm::new_base() const {
  const Eigen::Vector3d typed(base_[0]->value(), base_[1]->value(), base_[2]->value());
  if (!base_[0]->isEnabled() || typed == shown_base_) return {};
  return typed;
}

std::optional<double> PlantForm::new_stem_height_mm() const {
  if (!height_->isEnabled() || height_->value() == shown_height_mm_) return {};
  return height_->value();
}

plant::Part PlantForm::cut_becomes() const { return static_cast<plant::Part>(becomes_->currentData().toInt()); }

}  // namespace bole::desktop
