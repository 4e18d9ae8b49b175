#include "document/stage_words.h"

#include <QCoreApplication>
#include <QObject>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <optional>

#include "io/core/formats.h"

namespace bole::desktop {
namespace {

QString english_label(const OptionSpec& spec) {
  QString text = QString::fromStdString(spec.name);
  text.replace('_', ' ');
  for (const char* word : {"dbh", "crs", "imu"}) {
    static const QString edge = QStringLiteral("\\b%1\\b");
    text.replace(QRegularExpression(edge.arg(word)), QString(word).toUpper());
  }
  return text.left(1).toUpper() + text.mid(1);
}

QString limit_words(const OptionSpec& spec, double limit) {
  return spec.kind == ValueKind::integer ? QString::number(static_cast<qlonglong>(limit))
                                         : QString::fromStdString(number_text(limit));
}

QString range_words(const OptionSpec& spec) {
  const auto unit = unit_symbol(spec.unit);
  QString max = limit_words(spec, spec.max);
  if (!unit.empty()) max += " " + QString::fromUtf8(unit.data(), static_cast<int>(unit.size()));
  const QString text = spec.kind == ValueKind::integer ? QObject::tr("a whole number from %1 to %2")
                                                       : QObject::tr("a number from %1 to %2");
  return text.arg(limit_words(spec, spec.min), max);
}

QString choice_list(const OptionSpec& spec) {
  QStringList words;
  for (const auto& choice : spec.choices) words << choice_word(spec, choice);
  return words.join(", ");
}

// The formats of the content whose list ends the help of a reader's option.
std::optional<io::FileContent> content_listed(const OptionSpec& spec) {
  for (const auto content : io::all_contents)
    if (spec.text_kind == TextKind::input_path && spec.help.ends_with(": " + io::format_list(content) + "."))
      return content;
  return {};
}

// io::format_list() in the language of the window. A name or note without a translation stays as it is.
QString format_words(io::FileContent content) {
  const auto words = [](const std::string& text) { return QCoreApplication::translate("formats", text.c_str()); };
  QStringList list;
  for (const auto& [name, bracket] : io::listed_formats(content))
    list << (bracket.empty() ? words(name) : QObject::tr("%1 (%2)").arg(words(name), words(bracket)));
  const QString last = list.takeLast();
  return list.isEmpty() ? last : QObject::tr("%1 or %2").arg(list.join(QObject::tr(", ", "formats")), last);
}

}  // namespace

QString stage_title(const pipeline::StageType& type) {
  return QCoreApplication::translate("stages", type.title.c_str());
}

QString stage_help(const pipeline::StageType& type) {
  return QCoreApplication::translate("stage help", type.help.c_str());
}

QString stage_title(const pipeline::PipelineDocument& document, const pipeline::StageNode& node) {
  const bool twin = std::ranges::count(document.stages(), node.type, &pipeline::StageNode::type) > 1;
  const QString title = stage_title(*node.type);
  return twin ? QString("%1 (%2)").arg(title, QString::fromStdString(node.id)) : title;
}

QString stage_description(const pipeline::StageNode& node) {
  return QString::fromStdString(node.id + " (" + node.type->name + ")\n") + stage_help(*node.type);
}

// An option means something else in another stage ("seed"), a word in another option ("none"): such translations have
// the stage or the option as their comment.
QString option_label(const pipeline::StageType& type, const OptionSpec& spec) {
  return QCoreApplication::translate("option labels", english_label(spec).toUtf8().constData(), type.name.c_str());
}

std::string help_sentence(const OptionSpec& spec) {
  const auto content = content_listed(spec);
  if (!content) return spec.help;
  return spec.help.substr(0, spec.help.size() - io::format_list(*content).size() - 1) + "%1.";
}

QString option_help(const OptionSpec& spec) {
  const QString help = QCoreApplication::translate("option help", help_sentence(spec).c_str());
  const auto content = content_listed(spec);
  return content ? help.arg(format_words(*content)) : help;
}

QString choice_word(const OptionSpec& spec, const std::string& choice) {
  return QCoreApplication::translate("choices", choice.c_str(), spec.name.c_str());
}

QString value_words(const OptionSpec& spec, const OptionValue& value) {
  if (const auto* on = std::get_if<bool>(&value)) return *on ? QObject::tr("on") : QObject::tr("off");
  const auto text = option_text(value);
  const bool is_word = spec.text_kind == TextKind::choice || spec.is_unset(value);
  return is_word ? choice_word(spec, text) : QString::fromStdString(text);
}

std::string typed_value(const OptionSpec& spec, const QString& text) {
  const bool left_open = !spec.unset.empty() && text.trimmed() == choice_word(spec, spec.unset);
  return left_open ? spec.unset : text.toStdString();
}

QString needed_words(const OptionSpec& spec) {
  if (spec.text_kind == TextKind::choice) return QObject::tr("one of %1").arg(choice_list(spec));
  const QString text = spec.kind == ValueKind::text      ? QObject::tr("text")
                       : spec.kind == ValueKind::boolean ? QObject::tr("on or off")
                                                         : range_words(spec);
  return spec.unset.empty() ? text : QObject::tr("%1, or %2").arg(text, choice_word(spec, spec.unset));
}

}  // namespace bole::desktop
