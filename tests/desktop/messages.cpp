#include "messages.h"

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace bole::desktop {
namespace {

QStringList& list() {
  static QStringList collected;
  return collected;
}

void note_message(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type != QtDebugMsg && type != QtInfoMsg) list() << text;
}

class CollectingOutputWindow : public vtkOutputWindow {
 public:
  static CollectingOutputWindow* New();
  vtkTypeMacro(CollectingOutputWindow, vtkOutputWindow)
  void DisplayText(const char* text) override { list() << QString::fromUtf8(text); }
};
vtkStandardNewMacro(CollectingOutputWindow)

}  // namespace

void collect_complaints() {
  list().clear();
  qInstallMessageHandler(note_message);
  vtkOutputWindow::SetInstance(vtkSmartPointer<CollectingOutputWindow>::New());
}

QStringList complaints() { return list(); }

void stop_collecting() {
  qInstallMessageHandler(nullptr);
  vtkOutputWindow::SetInstance(nullptr);
  list().clear();
}

}  // namespace bole::desktop
