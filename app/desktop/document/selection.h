// What is selected: the one tree (row of the table, stem in 3-D, ring in the slice, point in the charts), the one row
// of plants, the one view of a camera.
#pragma once

#include <QObject>
#include <cstdint>
#include <optional>
#include <string>

namespace bole::desktop {

class Selection : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  std::optional<std::int64_t> tree() const { return tree_; }
  void select(std::optional<std::int64_t> tree) {
    if (tree == tree_) return;
    tree_ = tree;
    Q_EMIT telling();
    Q_EMIT changed();
    Q_EMIT told();
    Q_EMIT beside();
  }

  const std::optional<std::string>& row() const { return row_; }  // of plants
  void select_row(const std::optional<std::string>& row) {
    if (row == row_) return;
    row_ = row;
    Q_EMIT row_changed();
  }

  const std::optional<std::size_t>& view() const { return view_; }  // place in the sequence of pictures
  void select_view(std::optional<std::size_t> view) {
    if (view == view_) return;
    view_ = view;
    Q_EMIT view_changed();
  }

 Q_SIGNALS:
  void changed();
  void telling();  // before and after all hear that it changed: views that many of these change draw once
  void told();
  void beside();  // last: views of their own, which make their pictures while that of the 3-D view is on its way
  void row_changed();
  void view_changed();

 private:
  std::optional<std::int64_t> tree_;
  std::optional<std::string> row_;
  std::optional<std::size_t> view_;
};

}  // namespace bole::desktop
