// Tabs of docks keep their whole titles: where there is no room for all of them, arrows lead to the others.
#pragma once

#include <QObject>

class QMainWindow;

namespace bole::desktop {

class WholeTabs : public QObject {
 public:
  explicit WholeTabs(QMainWindow& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace bole::desktop
