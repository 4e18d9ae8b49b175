// Stages and their options in the language of the window. The declarations hold the English words, by which the
// translations in i18n/stages_*.ts and i18n/options_*.ts are found; a word without a translation stays English.
#pragma once

#include <QString>
#include <string>

#include "pipeline/document.h"

namespace bole::desktop {

QString stage_title(const pipeline::StageType& type);
QString stage_help(const pipeline::StageType& type);
// In a document: with its id where there are several of the type.
QString stage_title(const pipeline::PipelineDocument& document, const pipeline::StageNode& node);
QString stage_description(const pipeline::StageNode& node);  // id, type and help, for a tooltip

QString option_label(const pipeline::StageType& type, const OptionSpec& spec);  // "Min dbh"
QString option_help(const OptionSpec& spec);
// The sentence as i18n/options_*.ts has it: the list of a reader's formats is %1, so that a new format changes no
// sentence.
std::string help_sentence(const OptionSpec& spec);
QString choice_word(const OptionSpec& spec, const std::string& choice);  // or the word for "left open"
QString value_words(const OptionSpec& spec, const OptionValue& value);   // "on", "auto", "0.3"
std::string typed_value(const OptionSpec& spec, const QString& text);    // what value_words shows, read back
QString needed_words(const OptionSpec& spec);                            // "a number from 0.1 to 5 m"

}  // namespace bole::desktop
