// The window of the program: the workbench with its menus, docks and layouts; opens, saves and closes documents.
#pragma once

#include <array>

#include "workbench/workbench.h"

namespace bole::desktop {

class MainWindow : public Workbench {
  Q_OBJECT

 public:
  MainWindow();

  void open(const QString& path) override;
  void open_made(const pipeline::PipelineDocument& document, const QString& path) override;
  void save(const QString& path);

  // The recent file that the document in hand is listed as; empty for one that the program made by itself.
  const QString& recent_entry() const { return recent_entry_; }
  // Opens what a crash left of it, without asking.
  void restore(const QString& path);

  // The next close() asks nothing: what is not saved is kept for the next window, a run is cancelled.
  void close_without_question() { asks_before_close_ = false; }

  QMenu* menu(Menu which) { return menus_[static_cast<std::size_t>(which)]; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  bool may_lose_changes();  // asks what to do with unsaved changes; false: keep the document
  // Opens the pipeline at `path`, or what a crash left of it; without a file there, the one that `make` gives.
  void take_up(const QString& path, const std::function<pipeline::PipelineDocument()>& make);
  void note_recent(const QString& path);
  void make_docks();
  void make_menus();

  std::array<QMenu*, std::size(all_menus)> menus_{};
  QString recent_entry_;
  bool asks_before_close_ = true;
};

}  // namespace bole::desktop
