#include "features/point_edit/point_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "commands/commands.h"

namespace bole::desktop {
namespace {

constexpr double min_m = 0.01, max_m = 100, usual_radius_m = 0.25, usual_size_m = 1;

}  // namespace

PointPanel::PointPanel(const Commands& commands, QWidget* parent)
    : QWidget(parent), target_(new QComboBox(this)), choice_(new QComboBox(this)), state_(new QLabel(this)) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(4, 4, 4, 4);
  const auto buttons = [&](std::initializer_list<const char*> ids) {
    auto* row = new QHBoxLayout;
    for (const char* id : ids) {
      auto* button = new QToolButton(this);
      button->setDefaultAction(commands.action(id));
      button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
      row->addWidget(button);
    }
    row->addStretch();
    return row;
  };
  form->addRow(buttons({"points.brush", "points.polygon", "points.box"}));
  target_->setObjectName("points_target");
  target_->addItems({tr("Selected tree"), tr("New tree"), tr("No tree"), tr("Ground"), tr("Noise")});
  target_->setToolTip(tr("What the selected points become. A new tree stands where the points hold a stem."));
  form->addRow(tr("Points become"), target_);
  choice_->setObjectName("points_choice");
  choice_->addItems({tr("All points"), tr("Points of no tree"), tr("Points of the selected tree")});
  choice_->setToolTip(tr("Which of the selected points change. Ground and noise take all."));
  form->addRow(tr("Only"), choice_);
  radius_ = metres("points_radius", usual_radius_m, tr("Points so near the stroke of the brush are selected"));
  form->addRow(tr("Radius of the brush"), radius_);
  auto* sizes = new QHBoxLayout;
  for (auto*& size : size_) {
    size = metres(nullptr, usual_size_m, tr("Size of the box: x, y and z before it is turned"));
    sizes->addWidget(size);
  }
  size_[0]->setObjectName("points_box_x");
  size_[1]->setObjectName("points_box_y");
  size_[2]->setObjectName("points_box_z");
  form->addRow(tr("Size of the box"), sizes);
  turn_ = new QDoubleSpinBox(this);
  turn_->setObjectName("points_turn");
  turn_->setRange(-180, 180);
  turn_->setSuffix(QString::fromUtf8("°"));
  turn_->setToolTip(tr("Turns the box about the vertical, anti-clockwise seen from above"));
  form->addRow(tr("Turn of the box"), turn_);
  state_->setObjectName("points_state");
  state_->setWordWrap(true);
  form->addRow(state_);
  form->addRow(buttons({"points.apply", "points.drop"}));
  const auto picked = QOverload<int>::of(&QComboBox::currentIndexChanged);
  connect(target_, picked, this, [this] {
    follow_target();
    Q_EMIT changed();
  });
  connect(choice_, picked, this, &PointPanel::changed);
  connect(turn_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &PointPanel::changed);
  show_state({});
}

QDoubleSpinBox* PointPanel::metres(const char* name, double value, const QString& tip) {
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(name);
  box->setRange(min_m, max_m);
  box->setSingleStep(0.05);
  box->setValue(value);
  box->setSuffix(tr(" m"));
  box->setToolTip(tip);
  box->setKeyboardTracking(false);
  connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &PointPanel::changed);
  return box;
}

PointTarget PointPanel::target() const { return static_cast<PointTarget>(target_->currentIndex()); }

PointChoice PointPanel::choice() const {
  return choice_->isEnabled() ? static_cast<PointChoice>(choice_->currentIndex()) : PointChoice::all;
}

void PointPanel::follow_target() const {
  choice_->setEnabled(target() != PointTarget::ground && target() != PointTarget::noise);
}

double PointPanel::brush_radius_m() const { return radius_->value(); }

Eigen::Vector3d PointPanel::box_size_m() const { return {size_[0]->value(), size_[1]->value(), size_[2]->value()}; }

double PointPanel::box_turn_deg() const { return turn_->value(); }

void PointPanel::show_state(const QString& text) const {
  state_->setText(text.isEmpty() ? tr("Brush, draw around or click points in the 3-D view.") : text);
}

}  // namespace bole::desktop
