#include "features/clouds/cloud_panel.h"

#include <QColorDialog>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "document/file_kinds.h"
#include "features/clouds/cloud_distance.h"
#include "features/clouds/clouds.h"
#include "look/last_folder.h"
#include "look/scrolled_page.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int cloud_id_role = Qt::UserRole, swatch_px = 14;
constexpr double max_shift_m = 1e8, max_size_px = 12;
const QString one_color;  // in place of an array

QColor qt_color(const render::Color& color) { return QColor::fromRgbF(color.r, color.g, color.b); }

QIcon swatch(const QColor& color) {
  QPixmap pixmap(swatch_px, swatch_px);
  pixmap.fill(color);
  QPainter painter(&pixmap);
  painter.setPen(color.darker(140));
  painter.drawRect(0, 0, swatch_px - 1, swatch_px - 1);
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // not tinted
  return icon;
}

QDoubleSpinBox* cloud_number(const char* id, const QString& tip, double max, double step, int decimals,
                             const QString& unit) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(id);
  box->setToolTip(tip);
  box->setRange(-max, max);
  box->setSingleStep(step);
  box->setDecimals(decimals);
  box->setSuffix(unit);
  box->setKeyboardTracking(false);
  box->setMinimumWidth(box->fontMetrics().horizontalAdvance("-500000.000 m"));
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return box;
}

// A tool button takes the short text of its action.
void put_action(QToolButton& button, QAction& action, const QString& short_text) {
  action.setIconText(short_text);
  button.setDefaultAction(&action);
  button.setFocusPolicy(Qt::StrongFocus);
}

void show_row(QTreeWidgetItem& item, const CloudEntry& cloud) {
  item.setText(0, cloud.name());
  item.setData(0, cloud_id_role, cloud.id);
  item.setFlags(item.flags() | Qt::ItemIsUserCheckable);
  item.setCheckState(0, cloud.visible ? Qt::Checked : Qt::Unchecked);
  item.setIcon(0, swatch(qt_color(cloud.color)));
  item.setToolTip(0, cloud.path);
  item.setText(1, cloud.read                ? QLocale().toString(static_cast<qulonglong>(cloud.read->found))
                  : cloud.problem.isEmpty() ? QStringLiteral("…")
                                            : CloudPanel::tr("not read"));
  item.setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
}

const auto number_changed = QOverload<double>::of(&QDoubleSpinBox::valueChanged);

// What a box shows of a value is rounded: the digits that it lacks are kept.
double typed(const QDoubleSpinBox& box, double before) {
  return std::abs(box.value() - before) < 0.6 * std::pow(10, -box.decimals()) ? before : box.value();
}

QString color_title(const std::string& array) {
  return array == "z" ? CloudPanel::tr("Height (z)") : QString::fromStdString(array).replace('_', ' ');
}

}  // namespace

CloudPanel::CloudPanel(Clouds& clouds, Workbench& bench)
    : QWidget(&bench),
      clouds_(clouds),
      bench_(bench),
      list_(new QTreeWidget),
      said_(new QLabel),
      reading_(new QLabel),
      help_(new QPushButton),
      cancel_(new QToolButton),
      form_(new QWidget) {
  make_list();
  said_->setObjectName("cloud_said");
  said_->setWordWrap(true);
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  help_->setObjectName("cloud_help");
  connect(help_, &QPushButton::clicked, this, &CloudPanel::help);
  auto* form = new QFormLayout(form_);
  form->setContentsMargins(0, 0, 0, 0);
  make_place_rows(form);
  make_look_rows(form);
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(6, 4, 6, 4);
  column->addWidget(list_, 1);
  column->addWidget(make_buttons());
  put_action(*cancel_, *bench_.commands().action("clouds.cancel"), tr("Cancel"));
  auto* reading_row = new QHBoxLayout;
  reading_row->addWidget(reading_, 1);
  reading_row->addWidget(cancel_);
  column->addLayout(reading_row);
  column->addWidget(said_);
  column->addWidget(help_, 0, Qt::AlignLeft);
  column->addWidget(form_);
  fill_with_scrolled(*this, page);
  bench_.docks().add("clouds", tr("Clouds"), this, Qt::LeftDockWidgetArea, "options")->hide();  // until there is one
  bench_.commands().give_context_menu(*list_, "clouds");
  connect(&clouds_, &Clouds::changed, this, &CloudPanel::follow_list);
  connect(&clouds_, &Clouds::progress, this, &CloudPanel::follow_reading);
  follow_list();
  follow_reading();
}

void CloudPanel::make_list() {
  list_->setObjectName("clouds");
  list_->setHeaderLabels({tr("Cloud"), tr("Points")});
  list_->setRootIsDecorated(false);
  list_->setMinimumHeight(6 * list_->fontMetrics().height());
  list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // what lies below it stays in sight
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  list_->setToolTip(tr("Ticked clouds are drawn. Space: tick. Double click: zoom to it."));
  connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
    if (following_) return;
    follow_current();
    bench_.commands().update();
  });
  connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    if (!following_) clouds_.show(item->data(0, cloud_id_role).toInt(), item->checkState(0) == Qt::Checked);
  });
  connect(list_, &QTreeWidget::itemDoubleClicked, this,
          [this](QTreeWidgetItem* item) { clouds_.zoom_to(item->data(0, cloud_id_role).toInt()); });
}

QWidget* CloudPanel::make_buttons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  const std::pair<const char*, QString> buttons[] = {
      {"clouds.add", tr("Add…")}, {"clouds.zoom", tr("Zoom to")}, {"clouds.remove", tr("Remove")}};
  for (const auto& [id, text] : buttons) {
    auto* button = new QToolButton;
    put_action(*button, *bench_.commands().action(id), text);
    layout->addWidget(button);
  }
  layout->addStretch();
  return row;
}

void CloudPanel::make_place_rows(QFormLayout* form) {
  const QString titles[] = {tr("Shift x"), tr("Shift y"), tr("Shift z")};
  for (std::size_t k = 0; k < 3; ++k) {
    shift_[k] =
        cloud_number(k == 0   ? "cloud_x"
                     : k == 1 ? "cloud_y"
                              : "cloud_z",
                     tr("By how much the cloud is moved; its file stays as it is"), max_shift_m, 0.1, 3, tr(" m"));
    connect(shift_[k], number_changed, this, &CloudPanel::take_place);
    form->addRow(titles[k], shift_[k]);
  }
  turn_ = cloud_number("cloud_turn", tr("Counter-clockwise about the vertical through the middle of the cloud"), 360,
                       0.5, 2, QStringLiteral("°"));
  connect(turn_, number_changed, this, &CloudPanel::take_place);
  form->addRow(tr("Turn"), turn_);
}

void CloudPanel::make_look_rows(QFormLayout* form) {
  color_by_ = new QComboBox;
  color_by_->setObjectName("cloud_color_by");
  color_by_->setToolTip(tr("One colour keeps clouds apart. Numbers that colour the survey too have the same scale."));
  color_by_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(color_by_, QOverload<int>::of(&QComboBox::activated), this, &CloudPanel::take_look);
  color_ = new QToolButton;
  color_->setObjectName("cloud_color");
  color_->setToolTip(tr("Another colour for the cloud"));
  color_->setFocusPolicy(Qt::StrongFocus);
  connect(color_, &QToolButton::clicked, this, &CloudPanel::choose_color);
  auto* colors = new QHBoxLayout;
  colors->addWidget(color_by_, 1);
  colors->addWidget(color_);
  form->addRow(tr("Colour"), colors);
  size_ = cloud_number("cloud_size", tr("Size of a point on the screen"), max_size_px, 1, 0, tr(" px"));
  size_->setRange(0, max_size_px);
  size_->setSpecialValueText(tr("as the survey"));
  connect(size_, number_changed, this, &CloudPanel::take_look);
  form->addRow(tr("Point size"), size_);
}

int CloudPanel::current() const {
  return list_->currentItem() ? list_->currentItem()->data(0, cloud_id_role).toInt() : 0;
}

void CloudPanel::select(int id) {
  for (int row = 0; row < list_->topLevelItemCount(); ++row)
    if (list_->topLevelItem(row)->data(0, cloud_id_role).toInt() == id) list_->setCurrentItem(list_->topLevelItem(row));
}

void CloudPanel::come_forward() { bench_.docks().raise("clouds"); }

QString CloudPanel::said() const { return said_->text(); }

// An item that was ticked just now stays: it is in use by its list.
void CloudPanel::follow_list() {
  const auto& clouds = clouds_.list();
  const int before = current();
  following_ = true;
  bool same = list_->topLevelItemCount() == static_cast<int>(clouds.size());
  for (std::size_t k = 0; same && k < clouds.size(); ++k)
    same = list_->topLevelItem(static_cast<int>(k))->data(0, cloud_id_role).toInt() == clouds[k].id;
  if (!same) {
    list_->clear();
    for (std::size_t k = 0; k < clouds.size(); ++k) new QTreeWidgetItem(list_);
  }
  for (std::size_t k = 0; k < clouds.size(); ++k) show_row(*list_->topLevelItem(static_cast<int>(k)), clouds[k]);
  select(before);
  if (list_->currentItem() == nullptr && !clouds.empty()) list_->setCurrentItem(list_->topLevelItem(0));
  following_ = false;
  follow_current();
}

QString CloudPanel::words_of(const CloudEntry& cloud) const {
  QStringList lines;
  if (!cloud.problem.isEmpty()) lines << cloud.problem;
  if (clouds_.is_far(cloud.id)) {
    const double metres = *clouds_.distance_m(cloud.id);
    lines << (metres > undrawn_cloud_m ? tr("This cloud lies %1 from the survey, too far to be drawn with it.")
                                       : tr("This cloud lies %1 from the survey."))
                 .arg(distance_words(metres));
  }
  if (cloud.read) {
    if (cloud.read->on_disk()) lines << tr("Shown from the disk: what is near comes in full.");
    lines << cloud.read->remarks;
  }
  return lines.join('\n');
}

void CloudPanel::follow_current() {
  const auto* cloud = clouds_.find(current());
  form_->setEnabled(cloud != nullptr);
  const QString words = cloud == nullptr
                            ? tr("Clouds to look at beside the survey. They are drawn, measured by clicks and cut, and "
                                 "never enter a computation.")
                            : words_of(*cloud);
  said_->setText(words);
  said_->setVisible(!words.isEmpty());
  const bool unread = cloud != nullptr && !cloud->problem.isEmpty(),
             far = cloud != nullptr && clouds_.is_far(cloud->id);
  help_->setText(unread ? tr("Choose its file…") : tr("Move here"));
  help_->setToolTip(unread ? tr("The file where it lies now; place and look of the cloud stay")
                           : bench_.commands().action("clouds.move_here")->toolTip());
  help_->setVisible(unread || far);
  if (cloud == nullptr) return;
  following_ = true;
  for (int k = 0; k < 3; ++k) shift_[static_cast<std::size_t>(k)]->setValue(cloud->shift_m[k]);
  turn_->setValue(cloud->turn_deg);
  size_->setValue(cloud->point_px);
  show_colors(*cloud);
  following_ = false;
}

void CloudPanel::show_colors(const CloudEntry& cloud) {
  color_by_->clear();
  color_by_->addItem(tr("One colour"), one_color);
  if (cloud.read)
    for (const auto& array : render::paintable_arrays(*cloud.read->points))
      color_by_->addItem(color_title(array), QString::fromStdString(array));
  color_by_->setCurrentIndex(std::max(0, color_by_->findData(QString::fromStdString(cloud.color_by))));
  color_->setIcon(swatch(qt_color(cloud.color)));
  color_->setEnabled(cloud.color_by.empty());
}

void CloudPanel::follow_reading() {
  reading_->setText(clouds_.reading_text());
  reading_->setVisible(clouds_.reading());
  cancel_->setVisible(clouds_.reading());
  bench_.commands().update();
}

void CloudPanel::take_place() {
  if (following_) return;
  const auto* cloud = clouds_.find(current());
  if (cloud == nullptr) return;
  Eigen::Vector3d shift_m;
  for (int k = 0; k < 3; ++k) shift_m[k] = typed(*shift_[static_cast<std::size_t>(k)], cloud->shift_m[k]);
  clouds_.place(cloud->id, shift_m, typed(*turn_, cloud->turn_deg));
}

void CloudPanel::take_look() {
  const auto* cloud = clouds_.find(current());
  if (following_ || cloud == nullptr) return;
  clouds_.paint(cloud->id, cloud->color, color_by_->currentData().toString().toStdString(), size_->value());
}

void CloudPanel::choose_color() {
  const auto* cloud = clouds_.find(current());
  if (cloud == nullptr) return;
  const int id = cloud->id;
  const QColor chosen = QColorDialog::getColor(qt_color(cloud->color), this, tr("Colour of the cloud"));
  cloud = clouds_.find(id);  // a document may have been opened meanwhile
  if (!chosen.isValid() || cloud == nullptr) return;
  clouds_.paint(id, render::hex(chosen.rgb() & 0xffffffU), cloud->color_by, cloud->point_px);
}

void CloudPanel::help() {
  const auto* cloud = clouds_.find(current());
  if (cloud == nullptr) return;
  if (cloud->problem.isEmpty()) return bench_.guarded([this] { clouds_.move_here(current()); });
  const int id = cloud->id;
  const QString path =
      QFileDialog::getOpenFileName(&bench_, tr("Where is %1?").arg(cloud->name()), last_folder("open"),
                                   tr("Point clouds") + " (" + cloud_endings() + ");;" + tr("All files") + " (*)");
  if (!path.isEmpty()) clouds_.read_again(id, note_folder("open", path));
}

}  // namespace bole::desktop
