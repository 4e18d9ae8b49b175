#include "io/core/clouds/ply_reader.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "base/error.h"
#include "cloud/known_facts.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/clouds/cloud_builder.h"

namespace bole::io {
namespace {

constexpr std::size_t max_properties = 1024;

struct Property {
  SourceField field;                     // for a list: the type of its entries
  std::optional<SourceType> list_count;  // the type of its length
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  std::string format;
  std::vector<Element> elements;
  std::size_t data_offset = 0;
  std::string facts;  // JSON
};

SourceType scalar_type(std::string_view name, std::size_t line) {
  struct Named {
    std::string_view name;
    SourceType type;
  };
  using enum SourceType;
  constexpr std::array names{Named{"char", int8},       Named{"int8", int8},       Named{"uchar", uint8},
                             Named{"uint8", uint8},     Named{"short", int16},     Named{"int16", int16},
                             Named{"ushort", uint16},   Named{"uint16", uint16},   Named{"int", int32},
                             Named{"int32", int32},     Named{"uint", uint32},     Named{"uint32", uint32},
                             Named{"float", float32},   Named{"float32", float32}, Named{"double", float64},
                             Named{"float64", float64}, Named{"int64", int64},     Named{"uint64", uint64}};
  const auto it = std::ranges::find(names, name, &Named::name);
  if (it == names.end())
    throw bad_input("PLY header line " + std::to_string(line) + ": type '" + std::string(name.substr(0, 40)) + "'",
                    "char, uchar, short, ushort, int, uint, float or double");
  return it->type;
}

Header read_header(Bytes file) {
  Header header;
  LineReader lines(file);
  std::string_view text;
  const auto wrong = [&](const std::string& needed) {
    return bad_input(
        "PLY header line " + std::to_string(lines.number()) + " is '" + std::string(text.substr(0, 60)) + "'", needed);
  };
  std::size_t properties = 0;
  while (lines.next(text)) {
    if (text.starts_with(ply_facts_comment)) header.facts = text.substr(ply_facts_comment.size());
    const auto words = split_blanks(text);
    if (words.empty() || words[0] == "ply" || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") {
      if (header.format.empty())
        throw bad_input("the PLY header has no line format",
                        "format ascii, binary_little_endian or binary_big_endian 1.0");
      header.data_offset = lines.position();
      return header;
    }
    if (words[0] == "format" && words.size() >= 2) {
      header.format = words[1];
    } else if (words[0] == "element" && words.size() >= 3) {
      Element element{std::string(words[1]), 0, {}};
      if (!parse_number(words[2], element.count)) throw wrong("element NAME COUNT");
      header.elements.push_back(std::move(element));
    } else if (words[0] == "property" && words.size() >= 3 && !header.elements.empty()) {
      if (++properties > max_properties) throw wrong("at most " + std::to_string(max_properties) + " properties");
      auto& into = header.elements.back().properties;
      if (words[1] == "list") {
        if (words.size() < 5) throw wrong("property list COUNT_TYPE TYPE NAME");
        into.push_back(
            {{std::string(words[4]), scalar_type(words[3], lines.number())}, scalar_type(words[2], lines.number())});
      } else {
        into.push_back({{std::string(words[2]), scalar_type(words[1], lines.number())}, std::nullopt});
      }
    } else {
      throw wrong("format, element, property, comment or end_header");
    }
  }
  throw bad_input("the PLY header does not end after " + std::to_string(lines.number()) + " lines",
                  "a line end_header");
}

std::vector<SourceField> scalar_fields(const Element& vertex) {
  std::vector<SourceField> fields;
  for (const auto& p : vertex.properties)
    if (!p.list_count) fields.push_back(p.field);
  return fields;
}

// Reads binary records and stops at a record that goes beyond the end of the file.
class BinaryWalker {
 public:
  BinaryWalker(Bytes data, bool swap) : data_(data), swap_(swap) {}

  // Reads one record, and its scalars into `row`. False when the record goes beyond the end.
  bool read(const Element& element, std::vector<double>* row) {
    std::size_t at = at_, scalar = 0;
    for (const auto& p : element.properties) {
      const std::size_t bytes = source_type_bytes(p.field.type);
      if (p.list_count) {
        const std::size_t count_bytes = source_type_bytes(*p.list_count);
        if (count_bytes > data_.size() - at) return false;
        const double count = source_value(*p.list_count, data_.data() + at, swap_);
        at += count_bytes;
        if (!(count >= 0 && count * static_cast<double>(bytes) <= static_cast<double>(data_.size() - at))) return false;
        at += static_cast<std::size_t>(count) * bytes;
      } else {
        if (bytes > data_.size() - at) return false;
        if (row != nullptr) (*row)[scalar++] = source_value(p.field.type, data_.data() + at, swap_);
        at += bytes;
      }
    }
    at_ = at;
    return true;
  }

  // Skips a whole element. False when it goes beyond the end.
  bool skip(const Element& element, const Run& run) {
    const bool lists =
        std::ranges::any_of(element.properties, [](const Property& p) { return p.list_count.has_value(); });
    if (!lists) {
      std::size_t record = 0;
      for (const auto& p : element.properties) record += source_type_bytes(p.field.type);
      if (record > 0 && element.count > (data_.size() - at_) / record) return false;
      at_ += static_cast<std::size_t>(element.count) * record;
      return true;
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
      poll_points(run, i, 0);
      if (!read(element, nullptr)) return false;
    }
    return true;
  }

  std::size_t left() const { return data_.size() - at_; }

 private:
  Bytes data_;
  bool swap_;
  std::size_t at_ = 0;
};

std::size_t min_record(const Element& element) {
  std::size_t bytes = 0;
  for (const auto& p : element.properties) bytes += source_type_bytes(p.list_count.value_or(p.field.type));
  return std::max<std::size_t>(1, bytes);  // an element may have no properties
}

CloudReading read_binary_ply(Bytes data, const Header& header, std::size_t vertex_index,
                             const CloudReadOptions& options, const Run& run) {
  const bool little = header.format == "binary_little_endian";
  BinaryWalker walker(data, little != (std::endian::native == std::endian::little));
  const auto& vertex = header.elements[vertex_index];
  const auto fields = scalar_fields(vertex);
  CloudBuilder builder(fields, options);
  for (std::size_t e = 0; e < vertex_index; ++e)
    if (!walker.skip(header.elements[e], run))
      throw bad_input("the file is cut off in the PLY element '" + header.elements[e].name + "', before the points",
                      "the whole file");
  builder.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(vertex.count, walker.left() / min_record(vertex))));
  std::vector<double> row(fields.size());
  std::uint64_t read = 0;
  while (read < vertex.count && walker.read(vertex, &row)) {
    poll_points(run, read, static_cast<double>(read) / static_cast<double>(vertex.count));
    builder.add(row);
    ++read;
  }
  auto out = builder.finish();
  warn_cut_off(out.report, vertex.count, read);
  return out;
}

// The scalars of a line, without its lists. False where there are too few words or one is not a number.
bool read_words(const std::vector<std::string_view>& words, const Element& element, std::vector<double>& row) {
  std::size_t word = 0, scalar = 0;
  for (const auto& p : element.properties) {
    if (word >= words.size()) return false;
    double value = 0;
    if (!parse_number(words[word++], value)) return false;
    if (!p.list_count) {
      row[scalar++] = value;
    } else {
      if (!(value >= 0 && value <= static_cast<double>(words.size() - word))) return false;
      word += static_cast<std::size_t>(value);
    }
  }
  return true;
}

CloudReading read_ascii_ply(Bytes data, const Header& header, std::size_t vertex_index, const CloudReadOptions& options,
                            const Run& run) {
  const auto& vertex = header.elements[vertex_index];
  const auto fields = scalar_fields(vertex);
  CloudBuilder builder(fields, options);
  LineReader lines(data);
  std::string_view line;
  const auto next_line = [&] {
    while (lines.next(line))
      if (!trimmed(line).empty()) return true;
    return false;
  };
  for (std::size_t e = 0; e < vertex_index; ++e)
    for (std::uint64_t i = 0; i < header.elements[e].count; ++i) {
      poll_points(run, i, 0);
      if (!next_line())
        throw bad_input("the file is cut off in the PLY element '" + header.elements[e].name + "', before the points",
                        "the whole file");
    }
  std::vector<double> row(fields.size());
  std::vector<std::string_view> words;
  std::uint64_t read = 0, bad = 0;
  while (read < vertex.count && next_line()) {
    poll_points(run, read, static_cast<double>(read) / static_cast<double>(vertex.count));
    ++read;
    split_blanks(line, words);
    if (read_words(words, vertex, row))
      builder.add(row);
    else
      ++bad;
  }
  auto out = builder.finish();
  out.report.counts["bad_lines"] = static_cast<std::int64_t>(bad);
  if (bad > 0) out.report.warn(std::to_string(bad) + " lines without the properties of a vertex were skipped");
  warn_cut_off(out.report, vertex.count, read);
  return out;
}

}  // namespace

bool looks_like_ply(Bytes file) {
  return file.size() >= 4 && file[0] == 'p' && file[1] == 'l' && file[2] == 'y' &&
         (file[3] == '\n' || file[3] == '\r' || file[3] == ' ');
}

CloudReading read_ply(Bytes file, const CloudReadOptions& options, const Run& run) {
  const Header header = read_header(file);
  const auto vertex = std::ranges::find(header.elements, "vertex", &Element::name);
  CloudReading out;
  if (vertex == header.elements.end()) {
    out.report.counts = {{"points", 0}, {"dropped_points", 0}};
    out.report.warn("the file holds no points: it has no element 'vertex'");
  } else {
    const auto index = static_cast<std::size_t>(vertex - header.elements.begin());
    const Bytes data = file.subspan(header.data_offset);
    if (header.format == "ascii") {
      out = read_ascii_ply(data, header, index, options, run);
    } else if (header.format == "binary_little_endian" || header.format == "binary_big_endian") {
      out = read_binary_ply(data, header, index, options, run);
    } else {
      throw bad_input("the PLY format is '" + header.format.substr(0, 40) + "'",
                      "ascii, binary_little_endian or binary_big_endian");
    }
  }
  if (!header.facts.empty()) {
    std::vector<std::string> warnings;
    out.cloud.facts = facts_from_json(header.facts, warnings);
    for (auto& text : warnings) out.report.warn(std::move(text));
  }
  out.report.facts["format"] = "PLY " + header.format;
  return out;
}

}  // namespace bole::io
