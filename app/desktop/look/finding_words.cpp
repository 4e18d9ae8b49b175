#include "look/finding_words.h"

#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QStringList>
#include <QXmlStreamReader>
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "look/language.h"

namespace bole::desktop {
namespace {

constexpr int max_words_of_a_name = 3;  // of an inserted text that may stay as it is
constexpr int few_letters = 8;          // sentences with fewer fixed letters match nearly anything
constexpr int max_remembered = 5000;
constexpr int max_letters = 2000;                  // letters of a line that a stage may tell
constexpr const char* needed_mark = "; needed: ";  // base/error.h

// A sentence cut at its %1, %2 ..., which come in this order in the English.
class FindingPattern {
 public:
  explicit FindingPattern(const FindingText& text) : fixed_(parts(text.english)), translation_(text.translation) {
    for (const auto& part : fixed_)
      letters_ += static_cast<int>(std::count_if(part.begin(), part.end(), [](QChar c) { return c.isLetter(); }));
    for (const auto& part : fixed_) length_ += part.size();
  }

  int length() const { return length_; }
  bool contains(const char* text) const {
    return std::ranges::any_of(fixed_, [text](const QString& part) { return part.contains(text); });
  }
  bool is_weak() const { return letters_ < few_letters; }
  bool has_quotes_around(int place) const { return fixed_[place].endsWith('\'') && fixed_[place + 1].startsWith('\''); }
  // ", trees from %1 cm": what is added to a sentence.
  bool is_a_tail() const { return !fixed_.front().isEmpty() && !fixed_.front().front().isLetterOrNumber(); }

  // What stands in the places; nothing where the text is another one.
  std::optional<QStringList> match(const QString& text) const {
    if (fixed_.size() == 1) return text == fixed_.front() ? std::optional(QStringList()) : std::nullopt;
    if (!text.startsWith(fixed_.front())) return {};
    QStringList inserted;
    int at = fixed_.front().size();
    const int tail = text.size() - fixed_.back().size();
    for (int i = 1; i + 1 < fixed_.size(); ++i) {
      const int next = text.indexOf(fixed_[i], at);
      if (next < 0) return {};
      inserted << text.mid(at, next - at);
      at = next + fixed_[i].size();
    }
    if (tail < at || !text.endsWith(fixed_.back())) return {};
    return inserted << text.mid(at, tail - at);
  }

  QString filled(const QStringList& inserted) const {
    QString out;
    int end = 0;
    for (auto it = place().globalMatch(translation_); it.hasNext();) {
      const auto found = it.next();
      out += translation_.mid(end, found.capturedStart() - end) + inserted.value(found.captured(1).toInt() - 1);
      end = found.capturedEnd();
    }
    return out + translation_.mid(end);
  }

 private:
  static const QRegularExpression& place() {
    static const QRegularExpression expression("%(\\d+)");
    return expression;
  }
  static QStringList parts(const QString& english) { return english.split(place()); }

  QStringList fixed_;
  QString translation_;
  int length_ = 0, letters_ = 0;
};

class FindingCatalogue {
 public:
  explicit FindingCatalogue(const std::vector<FindingText>& texts) {
    for (const auto& text : texts) {
      const FindingPattern pattern(text);
      if (pattern.is_a_tail()) tails_.push_back(pattern);
      if (text.english.contains("%1"))
        patterns_.push_back(pattern);
      else
        whole_.insert(text.english, text.translation);
    }
    std::ranges::stable_sort(tails_, std::ranges::greater{}, &FindingPattern::length);
    std::ranges::stable_sort(patterns_, std::ranges::greater{}, &FindingPattern::length);
  }

  QString words(const QString& english) {
    if (patterns_.empty()) return english;
    if (remembered_.size() > max_remembered) remembered_.clear();
    QStringList lines;
    for (const auto& line : english.split('\n'))
      lines << (line.size() > max_letters ? line : found(line).value_or(line));
    return lines.join('\n');
  }

 private:
  using Words = std::optional<QString>;

  // Nothing: no sentence of the catalogue. Each way looks at shorter texts only.
  Words found(const QString& english) {
    if (const auto it = whole_.constFind(english); it != whole_.constEnd()) return *it;
    if (const auto it = remembered_.constFind(english); it != remembered_.constEnd()) return *it;
    Words words = of_an_error(english);
    if (!words) words = behind_a_name(english);
    if (!words) words = of_a_pattern(english, false);
    if (!words) words = with_a_tail(english);
    if (!words) words = of_a_pattern(english, true);
    if (!words) words = piece_by_piece(english);
    remembered_.insert(english, words);
    return words;
  }

  // Errors are made of what was found, what was needed and what to do (base/error.h). They are cut there before tails
  // are looked for, since "fields x, y and z" has none.
  Words of_an_error(const QString& english) {
    if (!english.contains(needed_mark)) return cut_at(". ", QStringLiteral("。"), english, 2);
    const auto words = of_a_pattern(english, false);
    return words ? words : cut_at(needed_mark, QStringLiteral("；需要："), english, 1);
  }

  // "stems: 17 stems, 3 to check": stages are called by names, files have a dot in theirs, or stand in quotes.
  Words behind_a_name(const QString& english) {
    static const QRegularExpression name("^(?:[\\w-]+|'[^']*'): ");
    const auto match = name.match(english);
    if (!match.hasMatch()) return {};
    const auto rest = found(english.mid(match.capturedEnd()));
    return rest ? Words(match.captured() + *rest) : Words();
  }

  // What was needed is cut off first: no pattern goes over that, but those that say it themselves.
  static bool reaches_too_far(const FindingPattern& pattern, const QString& english) {
    return english.contains(needed_mark) && !pattern.contains(needed_mark);
  }

  // Short patterns take names, and what is a sentence of the catalogue or a part of one. In quotes there are names.
  bool is_known(const FindingPattern& pattern, int place, const QString& inserted, const QString& words) {
    if (words == inserted && pattern.has_quotes_around(place)) return !inserted.contains('\'');
    if (words == inserted) return words.count(' ') < (pattern.is_weak() ? 1 : max_words_of_a_name);
    const bool in_pieces = inserted.contains(". ") || inserted.contains("; ");
    return !pattern.is_weak() || !in_pieces || whole_.contains(inserted) || of_a_pattern(inserted, false);
  }

  // `with_unknown`: whole sentences may be inserted that have no words here.
  Words of_a_pattern(const QString& english, bool with_unknown) {
    for (const auto& pattern : patterns_) {
      if ((with_unknown && pattern.is_weak()) || reaches_too_far(pattern, english)) continue;
      if (const auto inserted = pattern.match(english)) {
        const auto words = all_words(*inserted);
        bool known = true;  // or names and numbers
        for (int i = 0; i < words.size(); ++i) known &= is_known(pattern, i, inserted->at(i), words[i]);
        if (known || with_unknown) return pattern.filled(words);
      }
    }
    return {};
  }

  QStringList all_words(const QStringList& inserted) {
    QStringList words;
    for (const auto& text : inserted) words << found(text).value_or(text);
    return words;
  }

  // The last tail that leaves a sentence before it.
  Words with_a_tail(const QString& english) {
    for (int at = english.size() - 1; at > 0; --at) {
      if (english[at].isLetterOrNumber()) continue;
      const QString rest = english.mid(at);
      for (const auto& tail : tails_)
        if (const auto inserted = tail.match(rest))
          if (const auto head = found(english.left(at))) return *head + tail.filled(all_words(*inserted));
    }
    return {};
  }

  // Some findings are made of two sentences.
  Words piece_by_piece(const QString& english) {
    static const std::array<std::array<QString, 2>, 3> between{
        {{". ", QStringLiteral("。")}, {"; ", QStringLiteral("；")}, {": ", QStringLiteral("：")}}};
    for (const auto& [cut, mark] : between)
      if (const auto words = cut_at(cut, mark, english, 1)) return words;
    return {};
  }

  // Where so many of both pieces have words.
  Words cut_at(const QString& cut, const QString& mark, const QString& english, int with_words) {
    const int at = english.indexOf(cut);
    if (at <= 0) return {};
    const QString first = english.left(at), second = english.mid(at + cut.size());
    const auto before = found(first), after = found(second);
    if (int{before.has_value()} + int{after.has_value()} < with_words) return {};
    return before.value_or(first) + mark + after.value_or(second);
  }

  QHash<QString, QString> whole_;
  QHash<QString, Words> remembered_;
  std::vector<FindingPattern> patterns_, tails_;  // the longest first
};

std::vector<FindingText> read_finding_texts(const QString& language) {
  std::vector<FindingText> texts;
  QFile file(":/i18n/findings_" + language + ".ts");
  if (!file.open(QIODevice::ReadOnly)) return texts;
  QXmlStreamReader xml(&file);
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("source")) texts.push_back({xml.readElementText(), {}});
    if (xml.name() == QLatin1String("translation") && !texts.empty()) texts.back().translation = xml.readElementText();
  }
  return texts;
}

}  // namespace

const std::vector<FindingText>& finding_texts(const QString& language) {
  static std::map<QString, std::vector<FindingText>> read;
  const auto known = read.find(language);
  return known != read.end() ? known->second : read[language] = read_finding_texts(language);
}

QString finding_words(const QString& english) {
  static std::map<QString, FindingCatalogue> catalogues;
  const QString language = current_language();
  auto known = catalogues.find(language);
  if (known == catalogues.end()) known = catalogues.emplace(language, finding_texts(language)).first;
  return known->second.words(english);
}

QString finding_words(const std::string& english) { return finding_words(QString::fromStdString(english)); }

}  // namespace bole::desktop
