// The one tree that is selected: row of the table, stem in 3-D, ring in the slice, point in the charts.
#pragma once

#include <QObject>
#include <cstdint>
#include <optional>

namespace bole::desktop {

class Selection : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  std::optional<std::int64_t> tree() const { return tree_; }
  void select(std::optional<std::int64_t> tree) {
    if (tree == tree_) return;
    tree_ = tree;
    Q_EMIT changed();
  }

 Q_SIGNALS:
  void changed();

 private:
  std::optional<std::int64_t> tree_;
};

}  // namespace bole::desktop
