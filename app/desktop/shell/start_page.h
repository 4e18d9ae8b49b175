// What a window without a document shows: the sample plot, files to open, lessons, those files opened last with what
// was seen of them, and changes that a crash left unsaved.
#pragma once

#include <QWidget>

class QBoxLayout;

namespace bole::desktop {

class MainWindow;

class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(MainWindow& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void cover();
  void add_actions(QBoxLayout* layout);
  void add_lessons(QBoxLayout* layout);
  void add_unsaved(QBoxLayout* layout);
  void add_recent(QBoxLayout* layout);

  MainWindow& window_;
};

// Over the views and panels until a document is open.
void show_start_page(MainWindow& window);

}  // namespace bole::desktop
