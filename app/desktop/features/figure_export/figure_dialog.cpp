#include "features/figure_export/figure_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "look/last_folder.h"

namespace bole::desktop {
namespace {

constexpr int preview_delay_ms = 250;
constexpr double preview_dpi = 110;
const char* const endings[] = {".png", ".svg", ".pdf"};

}  // namespace

FigureDialog::FigureDialog(FigureSource source, QWidget* parent)
    : QDialog(parent),
      source_(std::make_shared<const FigureSource>(std::move(source))),
      figure_(new QComboBox),
      format_(new QComboBox),
      width_(new QDoubleSpinBox),
      dpi_(new QSpinBox),
      picture_(new QLabel),
      size_(new QLabel),
      save_(new QPushButton(tr("Save…"))) {
  setWindowTitle(tr("Export a figure"));
  resize(900, 620);
  for (const auto& name : source_->names())
    figure_->addItem(QString::fromStdString(name), QString::fromStdString(name));
  figure_->setObjectName("figure_name");
  format_->setObjectName("figure_format");
  width_->setObjectName("figure_width");
  dpi_->setObjectName("figure_dpi");
  format_->addItems({"PNG", "SVG", "PDF"});
  width_->setRange(40, 1200);
  width_->setDecimals(0);
  width_->setSuffix(tr(" mm"));
  width_->setValue(source_->options().figure_width);
  width_->setToolTip(tr("Width of a figure across the page; small charts take half of it"));
  dpi_->setRange(50, 1200);
  dpi_->setSuffix(tr(" dpi"));
  dpi_->setValue(static_cast<int>(source_->options().dpi));
  dpi_->setToolTip(tr("Pixels per inch of a PNG, and of the picture in a map"));
  width_->setKeyboardTracking(false);
  dpi_->setKeyboardTracking(false);
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setMinimumSize(420, 320);
  picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  auto* form = new QFormLayout;
  form->addRow(tr("Figure"), figure_);
  form->addRow(tr("Width"), width_);
  form->addRow(tr("Resolution"), dpi_);
  form->addRow(tr("Format"), format_);
  form->addRow(size_);
  form->addRow(save_);
  auto* layout = new QHBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(picture_, 1);
  delay_.setSingleShot(true);
  delay_.setInterval(preview_delay_ms);
  connect(&delay_, &QTimer::timeout, this, &FigureDialog::draw_preview);
  connect(figure_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &FigureDialog::ask_for_preview);
  connect(width_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &FigureDialog::ask_for_preview);
  connect(dpi_, QOverload<int>::of(&QSpinBox::valueChanged), this, &FigureDialog::ask_for_preview);
  connect(this, &FigureDialog::refused, size_, &QLabel::setText);
  connect(this, &FigureDialog::saved, this, [this](const QStringList& files) { size_->setText(files.join('\n')); });
  connect(save_, &QPushButton::clicked, this, [this] {
    const QString ending = endings[format_->currentIndex()];
    const QString name = figure_->currentText().replace(' ', '_') + ending;
    const QString path = note_folder(
        "export", QFileDialog::getSaveFileName(this, tr("Save figure"), in_last_folder("export", name), "*" + ending));
    if (!path.isEmpty()) save(path);
  });
  size_->setWordWrap(true);
  draw_preview();
}

FigureDialog::~FigureDialog() {
  worker_.request_stop();
  if (worker_.joinable()) worker_.join();
}

FigureFormat FigureDialog::format() const { return static_cast<FigureFormat>(format_->currentIndex()); }

void FigureDialog::choose(const QString& figure) {
  if (const int at = figure_->findData(figure); at >= 0) figure_->setCurrentIndex(at);
}

void FigureDialog::ask_for_preview() { delay_.start(); }

void FigureDialog::in_background(std::function<std::function<void()>(const Run&)> work) {
  if (worker_.joinable()) worker_.join();
  busy_ = true;
  save_->setEnabled(false);
  setCursor(Qt::BusyCursor);
  worker_ = std::jthread([this, work = std::move(work)](const std::stop_token& cancel) {
    Run run;
    run.cancel = cancel;
    std::function<void()> answer;
    try {
      answer = work(run);
    } catch (const std::exception& e) {
      answer = [this, why = QString::fromUtf8(e.what())] { Q_EMIT refused(why); };
    }
    QMetaObject::invokeMethod(
        this,
        [this, answer = std::move(answer)] {
          busy_ = false;
          save_->setEnabled(true);
          unsetCursor();
          answer();
          if (std::exchange(again_, false)) draw_preview();
        },
        Qt::QueuedConnection);
  });
}

void FigureDialog::draw_preview() {
  again_ = busy_;
  if (busy_ || figure_->count() == 0) return;
  in_background([this, source = source_, name = figure_->currentText().toStdString(), width = width_->value(),
                 dpi = dpi_->value()](const Run& run) -> std::function<void()> {
    const auto figures = source->make(name, width, preview_dpi, run);
    if (figures.empty()) throw bad_input("there is nothing to draw", "data for this figure");
    const auto& figure = figures.front();
    const auto image = render::figure_image(figure, preview_dpi);
    auto picture = QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
    auto text = tr("%1 x %2 mm, %3 x %4 pixels as PNG")
                    .arg(figure.width_mm, 0, 'f', 0)
                    .arg(figure.height_mm, 0, 'f', 0)
                    .arg(std::lround(figure.width_mm / 25.4 * dpi))
                    .arg(std::lround(figure.height_mm / 25.4 * dpi));
    if (figures.size() > 1) text += tr("; the first of %1 pages").arg(figures.size());
    return [this, picture, text] {
      preview_ = picture;
      size_->setText(text);
      show_preview();
      Q_EMIT previewed();
    };
  });
}

void FigureDialog::show_preview() {
  if (preview_.isNull()) return;
  picture_->setPixmap(
      QPixmap::fromImage(preview_.scaled(picture_->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation)));
}

void FigureDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  show_preview();
}

void FigureDialog::save(const QString& path) {
  if (busy_) return;
  in_background([this, source = source_, name = figure_->currentText().toStdString(), width = width_->value(),
                 dpi = static_cast<double>(dpi_->value()), kind = format(),
                 path](const Run& run) -> std::function<void()> {
    const auto figures = source->make(name, width, dpi, run);
    const QFileInfo file(path);
    QStringList files;
    for (std::size_t i = 0; i < figures.size(); ++i) {
      const QString page = figures.size() == 1 ? QString() : "_" + QString::number(i + 1);
      files << file.path() + "/" + file.completeBaseName() + page + "." + file.suffix();
      write_text_file(files.back().toStdString(), figure_bytes(figures[i], kind, dpi));
    }
    return [this, files] { Q_EMIT saved(files); };
  });
}

}  // namespace bole::desktop
