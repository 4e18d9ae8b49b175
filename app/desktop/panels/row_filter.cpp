#include "panels/row_filter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "document/cell_words.h"

namespace bole::desktop {
namespace {

std::string lower(std::string text) {
  for (auto& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::optional<double> number_of(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

// Words, quoted texts and relations, whether there are blanks between them or not.
struct Token {
  std::string text;
  bool relation = false;
};
std::vector<Token> tokens_of(const std::string& text) {
  const std::string signs = "<>=!~";
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == ' ' || text[i] == '\t' || text[i] == ',') {
      ++i;
    } else if (text[i] == '"') {
      const auto end = std::min(text.find('"', i + 1), text.size());
      tokens.push_back({text.substr(i + 1, end - i - 1)});
      i = end + 1;
    } else {
      const bool sign = signs.find(text[i]) != std::string::npos;
      auto end = i;
      while (end < text.size() && text[end] != '"' && text[end] != ' ' && text[end] != '\t' && text[end] != ',' &&
             (signs.find(text[end]) != std::string::npos) == sign)
        ++end;
      tokens.push_back({text.substr(i, end - i), sign});
      i = end;
    }
  }
  return tokens;
}

// The column of that name, or the one that has it before its unit.
std::string column_named(const Table& table, const std::string& name) {
  const auto wanted = lower(name);
  for (const auto& column : table.columns())
    if (lower(column.name) == wanted) return column.name;
  for (const auto& column : table.columns())
    if (lower(column.name).substr(0, column.name.rfind('_')) == wanted) return column.name;
  return {};
}

}  // namespace

std::vector<RowCondition> RowCondition::parse(const std::string& text, const Table* table) {
  static const std::vector<std::pair<std::string, Relation>> relations = {
      {"=", Relation::equal},          {"==", Relation::equal},      {"!=", Relation::unequal},
      {"<", Relation::less},           {"<=", Relation::less_equal}, {">", Relation::greater},
      {">=", Relation::greater_equal}, {"~", Relation::contains}};
  const auto tokens = tokens_of(text);
  std::vector<RowCondition> conditions;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    RowCondition condition;
    if (i + 1 < tokens.size() && tokens[i + 1].relation) {
      // While it is being typed, a condition without its value holds everywhere.
      if (i + 2 == tokens.size()) break;
      const auto relation = std::ranges::find(relations, tokens[i + 1].text, &std::pair<std::string, Relation>::first);
      if (table) condition.column_ = column_named(*table, tokens[i].text);
      condition.text_ = lower(tokens[i + 2].text);
      condition.number_ = number_of(condition.text_);
      if (table && condition.column_.empty()) condition.problem_ = "no column " + tokens[i].text;
      if (relation == relations.end())
        condition.problem_ = tokens[i + 1].text + " is none of = != < <= > >= ~";
      else
        condition.relation_ = relation->second;
      i += 2;
    } else {
      condition.text_ = lower(tokens[i].text);
    }
    conditions.push_back(std::move(condition));
  }
  return conditions;
}

bool RowCondition::holds(const Table& table, std::size_t row) const {
  if (!problem_.empty()) return false;
  if (column_.empty())
    return std::ranges::any_of(table.columns(), [&](const auto& column) {
      const auto text = table.text(column.name, row, column.name.ends_with("_m") ? 3 : 2);
      const auto shown = cell_words(column.name, QString::fromStdString(text)).toStdString();
      return lower(text).find(text_) != std::string::npos || lower(shown).find(text_) != std::string::npos;
    });
  const bool words = std::holds_alternative<std::vector<std::string>>(*table.find(column_));
  if (relation_ == Relation::contains) return lower(table.text(column_, row)).find(text_) != std::string::npos;
  if (words || !number_) {
    const auto order = lower(table.text(column_, row)).compare(text_);
    switch (relation_) {
      case Relation::equal:
        return order == 0;
      case Relation::unequal:
        return order != 0;
      case Relation::less:
        return order < 0;
      case Relation::less_equal:
        return order <= 0;
      case Relation::greater:
        return order > 0;
      default:
        return order >= 0;
    }
  }
  const auto* reals = std::get_if<std::vector<double>>(table.find(column_));
  const double value =
      reals ? (*reals)[row] : static_cast<double>(std::get<std::vector<std::int64_t>>(*table.find(column_))[row]);
  const double shown = column_.ends_with("_m") ? 0.0005 : 0.005;  // a number is equal to what the table shows of it
  switch (relation_) {
    case Relation::equal:
      return std::abs(value - *number_) < shown;
    case Relation::unequal:
      return !(std::abs(value - *number_) < shown);
    case Relation::less:
      return value < *number_;
    case Relation::less_equal:
      return value <= *number_;
    case Relation::greater:
      return value > *number_;
    default:
      return value >= *number_;
  }
}

RowFilter::RowFilter(QObject* parent) : QSortFilterProxyModel(parent) { setSortRole(Qt::UserRole); }

void RowFilter::set_table(const Table* table) {
  table_ = table;
  conditions_ = RowCondition::parse(text_.toStdString(), table_);
}

void RowFilter::set_ranks(std::vector<std::size_t> ranks) {
  ranks_ = std::move(ranks);
  if (by_rank_) invalidate();
}

void RowFilter::sort_by_rank() {
  by_rank_ = true;
  QSortFilterProxyModel::sort(0, Qt::AscendingOrder);
  invalidate();
}

void RowFilter::sort(int column, Qt::SortOrder order) {
  if (column < 0) return sort_by_rank();
  const bool again = std::exchange(by_rank_, false);
  QSortFilterProxyModel::sort(column, order);
  if (again) invalidate();
}

bool RowFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const auto a = static_cast<std::size_t>(left.row()), b = static_cast<std::size_t>(right.row());
  if (by_rank_ && a < ranks_.size() && b < ranks_.size()) return ranks_[a] < ranks_[b];
  return QSortFilterProxyModel::lessThan(left, right);
}

void RowFilter::set_text(const QString& text) {
  text_ = text;
  conditions_ = RowCondition::parse(text_.toStdString(), table_);
  invalidateFilter();
}

QString RowFilter::problem() const {
  for (const auto& condition : conditions_)
    if (!condition.problem().empty()) return QString::fromStdString(condition.problem());
  return {};
}

bool RowFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  return !table_ || std::ranges::all_of(conditions_, [&](const RowCondition& condition) {
    return condition.holds(*table_, static_cast<std::size_t>(row));
  });
}

}  // namespace bole::desktop
