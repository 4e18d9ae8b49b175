#include "panels/properties_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace bole::desktop {
namespace {

QString label_text(const OptionSpec& spec) {
  QString text = QString::fromStdString(spec.name);
  text.replace('_', ' ');
  return text.left(1).toUpper() + text.mid(1);
}

QString suffix(const OptionSpec& spec) {
  const auto unit = unit_symbol(spec.unit);
  return unit.empty() ? QString() : " " + QString::fromUtf8(unit.data(), static_cast<int>(unit.size()));
}

// Enough digits for a hundredth of the default or of the range's lower end.
int decimals_for(const OptionSpec& spec) {
  const double size = std::abs(std::get<double>(spec.default_value));
  return size > 0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 1, 6) : 3;
}

}  // namespace

PropertiesPanel::PropertiesPanel(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      title_(new QLabel),
      search_(new QLineEdit),
      advanced_(new QCheckBox(tr("Advanced"))),
      layout_(new QVBoxLayout(this)) {
  title_->setWordWrap(true);
  search_->setPlaceholderText(tr("Search options"));
  search_->setClearButtonEnabled(true);
  auto* top = new QHBoxLayout;
  top->addWidget(search_);
  top->addWidget(advanced_);
  layout_->addWidget(title_);
  layout_->addLayout(top);
  connect(search_, &QLineEdit::textChanged, this, &PropertiesPanel::rebuild);
  connect(advanced_, &QCheckBox::toggled, this, &PropertiesPanel::rebuild);
  connect(&session_, &Session::document_replaced, this, &PropertiesPanel::rebuild);
  connect(&session_, &Session::option_changed, this, [this](const QString& stage) {
    if (stage == stage_) QMetaObject::invokeMethod(this, &PropertiesPanel::rebuild, Qt::QueuedConnection);
  });
}

void PropertiesPanel::show_stage(const QString& id) {
  stage_ = id;
  rebuild();
}

void PropertiesPanel::rebuild() {
  delete form_;
  form_ = nullptr;
  if (!session_.has_document() || stage_.isEmpty()) return;
  const auto& stages = session_.document().stages();
  const auto it = std::ranges::find(stages, stage_.toStdString(), &StageNode::id);
  if (it == stages.end()) return;
  title_->setText("<b>" + QString::fromStdString(it->type->title) + "</b><br>" +
                  QString::fromStdString(it->type->help).toHtmlEscaped());

  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  const QString wanted = search_->text();
  for (const auto& spec : it->type->options->specs) {
    const QString label = label_text(spec);
    const bool found = !wanted.isEmpty() && (label.contains(wanted, Qt::CaseInsensitive) ||
                                             QString::fromStdString(spec.help).contains(wanted, Qt::CaseInsensitive));
    if (wanted.isEmpty() ? (spec.tier != Tier::basic && !advanced_->isChecked()) : !found) continue;
    auto* editor = editor_for(*it, spec);
    editor->setToolTip(QString::fromStdString(spec.help));
    editor->setObjectName(QString::fromStdString(spec.name));
    auto* name = new QLabel(it->options.is_default(spec.name) ? label : "<b>" + label + "</b>");
    name->setToolTip(QString::fromStdString(spec.help));
    form->addRow(name, editor);
  }
  scroll->setWidget(page);
  form_ = scroll;
  layout_->addWidget(scroll);
}

void PropertiesPanel::commit(const std::string& option, const OptionValue& value) {
  try {
    session_.set_option(stage_.toStdString(), option, value);
  } catch (const Error& e) {
    Q_EMIT refused(QString::fromUtf8(e.what()));
  }
}

QWidget* PropertiesPanel::editor_for(const StageNode& node, const OptionSpec& spec) {
  const OptionValue value = node.options.get(spec.name);
  if (const auto* on = std::get_if<bool>(&value)) {
    auto* box = new QCheckBox;
    box->setChecked(*on);
    connect(box, &QCheckBox::toggled, this, [this, name = spec.name](bool checked) { commit(name, checked); });
    return box;
  }
  if (const auto* number = std::get_if<std::int64_t>(&value)) {
    auto* box = new QSpinBox;
    box->setRange(static_cast<int>(std::max(spec.min, -2e9)), static_cast<int>(std::min(spec.max, 2e9)));
    box->setValue(static_cast<int>(*number));
    box->setSuffix(suffix(spec));
    box->setKeyboardTracking(false);
    connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this,
            [this, name = spec.name](int v) { commit(name, static_cast<std::int64_t>(v)); });
    return box;
  }
  if (const auto* number = std::get_if<double>(&value)) {
    auto* box = new QDoubleSpinBox;
    box->setDecimals(decimals_for(spec));
    box->setRange(std::max(spec.min, -1e9), std::min(spec.max, 1e9));
    box->setSingleStep(std::pow(10.0, 1 - decimals_for(spec)));
    box->setValue(*number);
    box->setSuffix(suffix(spec));
    box->setKeyboardTracking(false);
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this, name = spec.name](double v) { commit(name, v); });
    return box;
  }
  const auto text = QString::fromStdString(std::get<std::string>(value));
  if (spec.text_kind == TextKind::choice) {
    auto* box = new QComboBox;
    for (const auto& c : spec.choices) box->addItem(QString::fromStdString(c));
    box->setCurrentText(text);
    connect(box, &QComboBox::currentTextChanged, this,
            [this, name = spec.name](const QString& v) { commit(name, v.toStdString()); });
    return box;
  }
  auto* line = new QLineEdit(text);
  connect(line, &QLineEdit::editingFinished, this,
          [this, line, name = spec.name] { commit(name, line->text().toStdString()); });
  if (spec.text_kind != TextKind::input_path) return line;
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* browse = new QPushButton(tr("Browse…"));
  connect(browse, &QPushButton::clicked, this, [this, line, name = spec.name] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Open file"), line->text());
    if (!path.isEmpty()) commit(name, path.toStdString());
  });
  layout->addWidget(line);
  layout->addWidget(browse);
  return row;
}

}  // namespace bole::desktop
