#include "io/core/clouds/ptx_reader.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/clouds/cloud_builder.h"

namespace bole::io {
namespace {

constexpr std::size_t ptx_lines_between_polls = 1 << 15;

// Reads lines of numbers, and throws Error{bad_input} for other lines.
class PtxLines {
 public:
  explicit PtxLines(Bytes file) : lines_(file) {}

  bool at_end() {
    while (lines_.next(line_))
      if (!trimmed(line_).empty()) return false;
    return true;
  }
  // The numbers of the current line. Call at_end() before.
  const std::vector<double>& numbers(std::size_t min_count, const char* what) {
    split_blanks(line_, words_);
    values_.assign(words_.size(), 0);
    bool good = words_.size() >= min_count;
    for (std::size_t i = 0; i < words_.size(); ++i) good = parse_number(words_[i], values_[i]) && good;
    if (!good)
      throw bad_input("PTX line " + std::to_string(lines_.number()) + " is '" + std::string(line_.substr(0, 60)) + "'",
                      what);
    return values_;
  }
  const std::vector<double>& next(std::size_t min_count, const char* what) {
    if (at_end()) throw bad_input("the PTX file ends after line " + std::to_string(lines_.number()), what);
    return numbers(min_count, what);
  }
  std::size_t number() const { return lines_.number(); }
  std::size_t position() const { return lines_.position(); }

 private:
  LineReader lines_;
  std::string_view line_;
  std::vector<std::string_view> words_;
  std::vector<double> values_;
};

double cells_of(PtxLines& lines, double columns) {
  const double rows = lines.next(1, "the number of rows")[0];
  if (!(columns >= 0 && rows >= 0 && columns * rows < 1e15))
    throw bad_input("the PTX grid has " + std::to_string(columns) + " columns and " + std::to_string(rows) + " rows",
                    "whole numbers");
  return columns * rows;
}

// Four lines of position and axes, then the same as a matrix of row vectors.
Eigen::Affine3d read_pose(PtxLines& lines) {
  for (int i = 0; i < 4; ++i) lines.next(3, "the scanner's position and axes, three numbers");
  Eigen::Affine3d pose = Eigen::Affine3d::Identity();
  for (int i = 0; i < 4; ++i) {
    const auto& v = lines.next(4, "a row of the 4 by 4 transformation");
    if (i < 3)
      pose.linear().col(i) = Eigen::Vector3d(v[0], v[1], v[2]);
    else
      pose.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  }
  return pose;
}

}  // namespace

bool looks_like_ptx(Bytes file) {
  LineReader lines(file);
  std::string_view line;
  std::size_t count = 0;
  double ignored = 0;
  while (count < 2 && lines.next(line)) {
    const auto words = split_blanks(line);
    if (words.size() != 1 || !parse_number(words[0], ignored)) return false;
    ++count;
  }
  return count == 2;
}

CloudReading read_ptx(Bytes file, const CloudReadOptions& options, const Run& run) {
  PtxLines lines(file);
  std::unique_ptr<CloudBuilder> builder;
  std::size_t fields = 0, scans = 0;
  double missing = 0;
  std::int64_t empty_cells = 0;
  while (!lines.at_end()) {
    const double columns = lines.numbers(1, "the number of columns of a scan")[0];
    const double cells = cells_of(lines, columns);
    const Eigen::Affine3d pose = read_pose(lines);
    ++scans;
    double cell = 0;
    for (; cell < cells && !lines.at_end(); ++cell) {
      if (lines.number() % ptx_lines_between_polls == 0) {
        run.check_cancel();
        run.report(static_cast<double>(lines.position()) / static_cast<double>(file.size()), "reading lines");
      }
      auto row = lines.numbers(3, "x y z, with or without intensity and red green blue");
      if (!builder) {
        fields = row.size() >= 7 ? 7 : row.size() >= 4 ? 4 : 3;
        std::vector<SourceField> all{{"x"}, {"y"}, {"z"}, {"intensity"}, {"red"}, {"green"}, {"blue"}};
        all.resize(fields);
        builder = std::make_unique<CloudBuilder>(all, options);
      }
      if (row[0] == 0 && row[1] == 0 && row[2] == 0) {
        ++empty_cells;
        continue;
      }
      row.resize(fields, std::nan(""));
      const Eigen::Vector3d p = pose * Eigen::Vector3d(row[0], row[1], row[2]);
      row[0] = p.x();
      row[1] = p.y();
      row[2] = p.z();
      builder->add(row);
    }
    missing += cells - cell;
  }
  if (!builder) throw bad_input("the PTX file holds no points", "lines x y z intensity below the header of a scan");
  auto out = builder->finish();
  out.report.counts["empty_cells"] = empty_cells;
  out.report.counts["scans"] = static_cast<std::int64_t>(scans);
  if (missing > 0) out.report.warn("the file is cut off: " + number_text(missing) + " points of the grid are missing");
  out.report.facts["format"] = "PTX";
  return out;
}

}  // namespace bole::io
