#include "panels/properties_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/core/path_list.h"
#include "document/stage_words.h"
#include "look/finding_words.h"
#include "look/last_folder.h"
#include "pipeline/skipped_stages.h"

namespace bole::desktop {
namespace {

QString suffix(const OptionSpec& spec) {
  const auto unit = unit_symbol(spec.unit);
  return unit.empty() ? QString() : " " + QString::fromUtf8(unit.data(), static_cast<int>(unit.size()));
}

// Enough digits for a hundredth of the default or of the range's lower end.
int decimals_for(const OptionSpec& spec) {
  const auto* usual = std::get_if<double>(&spec.default_value);
  const double size = usual == nullptr ? 0 : std::abs(*usual);
  return size > 0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 1, 6) : 3;
}

QString first_sentence(const QString& text) {
  static const QRegularExpression end(QStringLiteral("\\. |。"));
  const auto found = end.match(text);
  return found.hasMatch() ? text.left(found.capturedStart() + 1) : text;
}

// Why an option means nothing now.
QString reason_text(const pipeline::StageType& type, const Condition& condition) {
  const auto& other = type.options->at(condition.option);
  const QString name = option_label(type, other);
  if (condition.values == std::vector<std::string>{""})
    return condition.holds_with ? PropertiesPanel::tr("Counts only while '%1' is empty.").arg(name)
                                : PropertiesPanel::tr("Counts only when '%1' is given.").arg(name);
  QStringList values;
  for (const auto& v : condition.values) values << value_words(other, other.parsed(v));
  const QString list = values.join(PropertiesPanel::tr(" or "));
  return condition.holds_with ? PropertiesPanel::tr("Counts only when '%1' is %2.").arg(name, list)
                              : PropertiesPanel::tr("Counts only when '%1' is not %2.").arg(name, list);
}

}  // namespace

PropertiesPanel::PropertiesPanel(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      title_(new QLabel),
      search_(new QLineEdit),
      tier_(new QComboBox),
      notice_(new QLabel),
      at_once_(new QCheckBox(tr("Apply at once"))),
      apply_(new QPushButton(tr("Apply"))),
      reset_(new QPushButton(tr("Reset"))),
      defaults_(new QPushButton(tr("Defaults"))),
      layout_(new QVBoxLayout(this)) {
  title_->setWordWrap(true);
  notice_->setWordWrap(true);
  notice_->hide();
  search_->setPlaceholderText(tr("Search options"));
  search_->setClearButtonEnabled(true);
  tier_->addItems({tr("Basic"), tr("Advanced"), tr("Expert")});
  tier_->setObjectName("tier");
  at_once_->setObjectName("apply_at_once");
  apply_->setObjectName("apply");
  reset_->setObjectName("reset");
  defaults_->setObjectName("defaults");
  at_once_->setChecked(true);
  at_once_->setToolTip(tr("Changes go into the pipeline as they are made, else with Apply"));
  reset_->setToolTip(tr("Throws away what was not applied"));
  defaults_->setToolTip(tr("All options of this stage as they come with the program"));
  auto* top = new QHBoxLayout;
  top->addWidget(search_);
  top->addWidget(tier_);
  layout_->addWidget(title_);
  layout_->addLayout(top);
  layout_->addWidget(notice_);
  layout_->addLayout(buttons_layout());
  connect_widgets();
  show_pending();
}

QLayout* PropertiesPanel::buttons_layout() {
  auto* row = new QHBoxLayout;
  row->addWidget(at_once_);
  row->addStretch();
  for (auto* button : {apply_, reset_, defaults_}) row->addWidget(button);
  return row;
}

void PropertiesPanel::connect_widgets() {
  connect(search_, &QLineEdit::textChanged, this, &PropertiesPanel::rebuild);
  connect(tier_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PropertiesPanel::rebuild);
  connect(apply_, &QPushButton::clicked, this, &PropertiesPanel::apply);
  connect(reset_, &QPushButton::clicked, this, [this] {
    pending_.clear();
    rebuild();
  });
  connect(defaults_, &QPushButton::clicked, this, &PropertiesPanel::restore_defaults);
  connect(at_once_, &QCheckBox::toggled, this, [this](bool on) {
    if (on) apply();
    show_pending();
  });
  connect(&session_, &Session::document_replaced, this, [this] {
    pending_.clear();
    rebuild();
  });
  connect(&session_, &Session::option_changed, this, [this](const QString& stage) {
    if (stage == stage_) QMetaObject::invokeMethod(this, &PropertiesPanel::rebuild, Qt::QueuedConnection);
  });
}

void PropertiesPanel::show_stage(const QString& id) {
  if (!pending_.empty() && id != stage_) apply();  // nothing that was typed is lost
  stage_ = id;
  rebuild();
}

void PropertiesPanel::set_tier(Tier tier) { tier_->setCurrentIndex(static_cast<int>(tier)); }

const pipeline::StageNode* PropertiesPanel::node() const {
  if (!session_.has_document()) return nullptr;
  const auto& stages = session_.document().stages();
  const auto it = std::ranges::find(stages, stage_.toStdString(), &pipeline::StageNode::id);
  return it == stages.end() ? nullptr : &*it;
}

bool PropertiesPanel::is_listed(const pipeline::StageType& type, const OptionSpec& spec) const {
  const QString wanted = search_->text();
  if (wanted.isEmpty()) return static_cast<int>(spec.tier) <= tier_->currentIndex();
  const QStringList texts{option_label(type, spec), option_help(spec), QString::fromStdString(spec.name)};
  return std::ranges::any_of(texts, [&](const QString& text) { return text.contains(wanted, Qt::CaseInsensitive); });
}

void PropertiesPanel::rebuild() {
  delete form_;
  form_ = nullptr;
  rows_.clear();
  const auto* stage = node();
  if (!stage) return show_pending();
  const auto about = stage_help(*stage->type);
  title_->setText("<b>" + stage_title(*stage->type) + "</b><br>" + first_sentence(about).toHtmlEscaped());
  title_->setToolTip("<p>" + about.toHtmlEscaped() + "</p>");
  show_notice(*stage);

  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  for (const auto& spec : stage->type->options->specs) {
    if (!is_listed(*stage->type, spec)) continue;
    const auto help =
        option_help(spec) + "\n" + tr("%1; default %2").arg(needed_words(spec), value_words(spec, spec.default_value));
    auto* editor = editor_for(value_of(*stage, spec), spec);
    editor->setMinimumWidth(80);  // not that of the widest number there is
    editor->setObjectName(QString::fromStdString(spec.name));
    const bool changed = value_of(*stage, spec) != spec.default_value;
    const QString label = option_label(*stage->type, spec);
    auto* name = new QLabel(changed ? "<b>" + label + "</b>" : label);
    form->addRow(name, editor);
    rows_.push_back({&spec, name, editor, help});
  }
  show_conditions();
  if (form->rowCount() == 0)
    form->addRow(new QLabel(stage->type->options->specs.empty() ? tr("This stage has no options.")
                                                                : tr("No option here: see another tier or search.")));
  scroll->setWidget(page);
  form_ = scroll;
  layout_->insertWidget(3, scroll, 1);
  show_pending();
}

// Why the stage cannot run, or does not.
void PropertiesPanel::show_notice(const pipeline::StageNode& stage) {
  QStringList lines;
  for (const auto& problem : pipeline::validate(session_.document()))
    if (problem.stage == stage.id) lines << finding_words(problem.message);
  if (pipeline::is_skipped(session_.document(), stage)) lines << tr("This stage runs when its file is given.");
  notice_->setText(lines.join("\n"));
  notice_->setVisible(!lines.isEmpty());
}

// What another choice makes meaningless is greyed, and says why.
void PropertiesPanel::show_conditions() {
  const auto* stage = node();
  if (!stage) return;
  const auto& table = *stage->type->options;
  for (const auto& row : rows_) {
    const auto* unmet = table.unmet(*row.spec, [&](const OptionSpec& spec) { return value_of(*stage, spec); });
    row.name->setEnabled(unmet == nullptr);
    row.editor->setEnabled(unmet == nullptr);
    const QString text = unmet ? reason_text(*stage->type, *unmet) + "\n\n" + row.help : row.help;
    row.name->setToolTip(text);
    row.editor->setToolTip(text);
  }
}

void PropertiesPanel::show_pending() {
  const bool any = !pending_.empty();
  apply_->setEnabled(any);
  reset_->setEnabled(any);
  apply_->setToolTip(any                     ? tr("Takes the changes into the pipeline")
                     : at_once_->isChecked() ? tr("Nothing to apply: changes are taken at once")
                                             : tr("Nothing to apply: no option was changed"));
  const auto* stage = node();
  const bool all_default = !stage || std::ranges::all_of(stage->type->options->specs, [&](const auto& spec) {
    return stage->options.is_default(spec.name);
  });
  defaults_->setEnabled(!all_default);
}

OptionValue PropertiesPanel::value_of(const pipeline::StageNode& stage, const OptionSpec& spec) const {
  const auto it = pending_.find(spec.name);
  return it == pending_.end() ? stage.options.get(spec.name) : it->second;
}

void PropertiesPanel::commit(const std::string& option, const OptionValue& value) {
  try {
    if (at_once_->isChecked()) return session_.set_option(stage_.toStdString(), option, value);
    const auto* stage = node();
    const auto checked = stage->type->options->at(option).checked(value);
    if (checked == stage->options.get(option))
      pending_.erase(option);
    else
      pending_[option] = checked;
    show_conditions();
  } catch (const Error& e) {
    Q_EMIT refused(QString::fromUtf8(e.what()));
  }
  show_pending();
}

// All that waits, as one step of undo.
void PropertiesPanel::apply() {
  const auto waiting = std::exchange(pending_, {});
  if (waiting.empty() || !node()) return;
  session_.undo_stack().beginMacro(tr("options of %1").arg(stage_));
  for (const auto& [option, value] : waiting) session_.set_option(stage_.toStdString(), option, value);
  session_.undo_stack().endMacro();
}

void PropertiesPanel::restore_defaults() {
  pending_.clear();
  const auto* stage = node();
  if (!stage) return;
  session_.undo_stack().beginMacro(tr("defaults of %1").arg(stage_));
  for (const auto& spec : stage->type->options->specs)
    session_.set_option(stage_.toStdString(), spec.name, spec.default_value);
  session_.undo_stack().endMacro();
}

QWidget* PropertiesPanel::editor_for(const OptionValue& value, const OptionSpec& spec) {
  // One that may be left open takes a word besides its values: a line of text.
  const bool open = !spec.unset.empty();
  if (const auto* on = std::get_if<bool>(&value); on && !open) {
    auto* box = new QCheckBox;
    box->setChecked(*on);
    connect(box, &QCheckBox::toggled, this, [this, name = spec.name](bool checked) { commit(name, checked); });
    return box;
  }
  if (const auto* number = std::get_if<std::int64_t>(&value); number && !open) {
    auto* box = new QSpinBox;
    box->setRange(static_cast<int>(std::max(spec.min, -2e9)), static_cast<int>(std::min(spec.max, 2e9)));
    box->setValue(static_cast<int>(*number));
    box->setSuffix(suffix(spec));
    box->setKeyboardTracking(false);
    connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this,
            [this, name = spec.name](int v) { commit(name, static_cast<std::int64_t>(v)); });
    return box;
  }
  if (const auto* number = std::get_if<double>(&value); number && !open) {
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
  const auto text = QString::fromStdString(option_text(value));
  if (spec.text_kind == TextKind::choice) {
    auto* box = new QComboBox;
    for (const auto& c : spec.choices) box->addItem(choice_word(spec, c), QString::fromStdString(c));
    box->setCurrentIndex(box->findData(text));
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this, box, name = spec.name](int) { commit(name, box->currentData().toString().toStdString()); });
    return box;
  }
  auto* line = new QLineEdit(value_words(spec, value));
  connect(line, &QLineEdit::editingFinished, this,
          [this, line, spec = &spec] { commit(spec->name, typed_value(*spec, line->text())); });
  if (spec.text_kind != TextKind::input_path) return line;
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* browse = new QPushButton(tr("Browse…"));
  connect(browse, &QPushButton::clicked, this, [this, line, spec = &spec] {
    // A list of folders grows by one with every choice.
    const bool list = is_path_list(*spec);
    const QString begin = line->text().isEmpty() || list ? last_folder("open") : line->text();
    const QString path = list ? QFileDialog::getExistingDirectory(this, tr("Add folder"), begin)
                              : QFileDialog::getOpenFileName(this, tr("Open file"), begin);
    if (path.isEmpty()) return;
    note_folder("open", path);
    const bool more = list && !line->text().trimmed().isEmpty();
    commit(spec->name, (more ? line->text() + path_separator + path : path).toStdString());
  });
  layout->addWidget(line);
  layout->addWidget(browse);
  return row;
}

}  // namespace bole::desktop
