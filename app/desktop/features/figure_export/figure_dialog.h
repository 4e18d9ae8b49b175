// Exports a figure of the report at a size in millimetres and a resolution, with a preview of what comes out.
#pragma once

#include <QDialog>
#include <QImage>
#include <QTimer>
#include <functional>
#include <memory>
#include <thread>

#include "features/figure_export/figure_source.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace bole::desktop {

class FigureDialog : public QDialog {
  Q_OBJECT

 public:
  FigureDialog(FigureSource source, QWidget* parent);
  ~FigureDialog() override;  // gives up what is being drawn

  void choose(const QString& figure);  // by its name; one that is not there changes nothing
  void save(const QString& path);      // draws and writes in the background; then `saved` or `refused`
  bool busy() const { return busy_; }
  const QImage& preview() const { return preview_; }

 Q_SIGNALS:
  void previewed();
  void saved(const QStringList& files);
  void refused(const QString& why);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  FigureFormat format() const;
  void ask_for_preview();
  void draw_preview();
  void show_preview();
  // `work` runs in the thread of the dialog, one at a time; its answer in the window's.
  void in_background(std::function<std::function<void()>(const Run&)> work);

  std::shared_ptr<const FigureSource> source_;
  QComboBox *figure_, *format_;
  QDoubleSpinBox* width_;
  QSpinBox* dpi_;
  QLabel *picture_, *size_;
  QPushButton* save_;
  QTimer delay_;
  QImage preview_;
  bool busy_ = false, again_ = false;
  std::jthread worker_;
};

}  // namespace bole::desktop
