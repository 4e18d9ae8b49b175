// The breast-height slice of the selected stem, drawn by the code of the report's slice sheet.
#pragma once

#include <QWidget>
#include <cstdint>
#include <memory>

#include "cloud/point_cloud.h"
#include "cloud/table.h"

namespace bole::desktop {

class SliceView : public QWidget {
  Q_OBJECT

 public:
  explicit SliceView(QWidget* parent);

  // Either may be null.
  void show_survey(std::shared_ptr<const Table> stems, std::shared_ptr<const PointCloud> slice);
  void show_tree(std::int64_t id);

  QSize sizeHint() const override { return {320, 380}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage drawn() const;  // null when there is nothing to show

  std::shared_ptr<const Table> stems_;
  std::shared_ptr<const PointCloud> slice_;
  std::int64_t tree_ = 0;
};

}  // namespace bole::desktop
