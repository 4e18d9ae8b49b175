#include "features/clouds/cloud_panel.h"

#include <QDockWidget>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "document/file_kinds.h"
#include "features/clouds/cloud_align_page.h"
#include "features/clouds/cloud_difference_page.h"
#include "features/clouds/cloud_distance.h"
#include "features/clouds/cloud_jobs.h"
#include "features/clouds/cloud_look_page.h"
#include "features/clouds/cloud_place_page.h"
#include "features/clouds/cloud_widgets.h"
#include "features/clouds/clouds.h"
#include "look/last_folder.h"
#include "look/scrolled_page.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int cloud_id_role = Qt::UserRole;

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
      pages_(new QTabWidget),
      place_(new CloudPlacePage(clouds)),
      look_(new CloudLookPage(clouds)),
      align_(new CloudAlignPage(clouds, clouds.pairs(), clouds.jobs(), bench)),
      difference_(new CloudDifferencePage(clouds, bench)),
      doing_(new QProgressBar),
      cancel_work_(new QToolButton) {
  make_list();
  said_->setObjectName("cloud_said");
  said_->setWordWrap(true);
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  help_->setObjectName("cloud_help");
  connect(help_, &QPushButton::clicked, this, &CloudPanel::help);
  pages_->setObjectName("cloud_pages");
  pages_->setDocumentMode(true);
  pages_->addTab(place_, tr("Place"));
  pages_->addTab(look_, tr("Look"));
  pages_->addTab(align_, tr("Align"));
  pages_->addTab(difference_, tr("Distances"));
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
  put_action(*cancel_work_, *bench_.commands().action("clouds.cancel_work"), tr("Cancel"));
  doing_->setObjectName("cloud_work");
  auto* work_row = new QHBoxLayout;
  work_row->addWidget(doing_, 1);
  work_row->addWidget(cancel_work_);
  column->addLayout(work_row);
  column->addWidget(said_);
  column->addWidget(help_, 0, Qt::AlignLeft);
  column->addWidget(pages_);
  fill_with_scrolled(*this, page);
  bench_.docks().add("clouds", tr("Clouds"), this, Qt::LeftDockWidgetArea, "options")->hide();  // until there is one
  bench_.commands().give_context_menu(*list_, "clouds");
  connect(&clouds_, &Clouds::changed, this, &CloudPanel::follow_list);
  connect(&clouds_, &Clouds::progress, this, &CloudPanel::follow_reading);
  connect(&clouds_.jobs(), &CloudJobs::changed, this, &CloudPanel::follow_work);
  follow_list();
  follow_reading();
  follow_work();
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
  return button_row(bench_.commands(),
                    {{"clouds.add", tr("Add…")}, {"clouds.zoom", tr("Zoom to")}, {"clouds.remove", tr("Remove")}});
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
  if (cloud.at.scale != 1)
    lines << tr("Shown at scale %1: lengths in this cloud are not those of its file.").arg(cloud.at.scale, 0, 'g', 6);
  if (cloud.read) {
    if (cloud.read->on_disk()) lines << tr("Shown from the disk: what is near comes in full.");
    lines << cloud.read->remarks;
  }
  return lines.join('\n');
}

void CloudPanel::follow_current() {
  const auto* cloud = clouds_.find(current());
  place_->follow(cloud);
  look_->follow(cloud);
  align_->follow(cloud);
  difference_->follow(cloud);
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
}

void CloudPanel::follow_reading() {
  reading_->setText(clouds_.reading_text());
  reading_->setVisible(clouds_.reading());
  cancel_->setVisible(clouds_.reading());
  bench_.commands().update();
}

void CloudPanel::follow_work() {
  const auto& jobs = clouds_.jobs();
  doing_->setVisible(jobs.busy());
  cancel_work_->setVisible(jobs.busy());
  doing_->setToolTip(jobs.doing());
  doing_->setFormat(jobs.doing() + " %p %");
  doing_->setValue(static_cast<int>(100 * jobs.fraction()));
  if (!jobs.busy()) follow_current();
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
