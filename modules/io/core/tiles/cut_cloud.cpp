#include "io/core/tiles/cut_cloud.h"

#include <fmt/format.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>

#include "base/core/path_list.h"
#include "base/error.h"
#include "cloud/core/whole/occupied_cells.h"
#include "cloud/core/whole/whole_cloud.h"
#include "cloud/core/whole/whole_size.h"
#include "io/core/las/crs_unit.h"
#include "io/core/las/las_facts.h"
#include "io/core/tiles/record_stream.h"
#include "io/core/tiles/tile_file.h"
#include "io/core/tiles/tile_parts.h"

namespace bole::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_bytes_in_memory = std::size_t{256} << 20;
constexpr double max_spacing_cells = 4e8;
constexpr std::size_t max_tiles = 100'000;

struct SourceFile {
  fs::path path;
  std::unique_ptr<MappedFile> file;
  LasInfo info;
  std::array<std::int32_t, 3> shift{};  // added to its steps for those of the first file
};

Error not_alike(const SourceFile& a, const SourceFile& b, const std::string& what) {
  return bad_input(fmt::format("'{}' and '{}' differ in their {}", a.path.string(), b.path.string(), what),
                   "files of one cloud, of the same point format and steps", "Convert them alike: bole convert");
}

SourceFile open_source(const fs::path& path) {
  SourceFile s{path, std::make_unique<MappedFile>(path), {}};
  const Bytes bytes = s.file->bytes();
  if (bytes.size() < 4 || std::memcmp(bytes.data(), "LASF", 4) != 0)
    throw bad_input(fmt::format("'{}' is no LAS, LAZ or COPC file", path.string()), "a cloud that can be read in parts",
                    "Convert it: bole convert FILE cloud.laz");
  s.info = las::parse_info(bytes);
  const auto metres = las::metres_per_crs_unit(s.info.crs_wkt);
  if (!s.info.crs_wkt.empty() && (!metres || std::abs(*metres - 1) > 1e-9))
    throw bad_input(fmt::format("the coordinates of '{}' are not in metres", path.string()),
                    "a projected coordinate system in metres", "Project the cloud first");
  return s;
}

// Steps of the coordinates of another file in those of the first.
void align(SourceFile& s, const SourceFile& first) {
  if (s.info.point_format != first.info.point_format || s.info.record_length != first.info.record_length)
    throw not_alike(first, s, "point format");
  if (s.info.scale != first.info.scale) throw not_alike(first, s, "coordinate steps");
  for (int k = 0; k < 3; ++k) {
    const double steps = (s.info.offset[k] - first.info.offset[k]) / s.info.scale[k];
    if (std::abs(steps - std::round(steps)) > 1e-3 || std::abs(steps) > 1e9)
      throw not_alike(first, s, "coordinate steps (the offset)");
    s.shift[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(std::lround(steps));
  }
}

struct Tile {
  std::vector<std::uint8_t> waiting;  // records that are not on file yet
  std::unique_ptr<las::TileParts> parts;
  las::TileStatistics statistics;
  std::uint64_t core_points = 0;
};

class Cutter {
 public:
  Cutter(const CutOptions& options, const fs::path& folder, const Run& run)
      : options_(options), folder_(folder), run_(run) {
    if (options.buffer_m > options.tile_m)
      throw bad_input(
          fmt::format("the buffer of {:g} m is wider than the tile of {:g} m", options.buffer_m, options.tile_m),
          "a tile that is at least as wide as its buffer", "Set tile to several times buffer");
    for (const auto& path : split_paths(options.files)) sources_.push_back(open_source(path));
    for (auto& s : sources_) align(s, sources_.front());
    grid_ = {options.tile_m, options.buffer_m, {options.shift_x, options.shift_y}};
    stride_ = static_cast<std::size_t>(first().record_length);
    extended_ = las::point_layout(first().point_format).extended;
    fs::create_directories(folder);
    expect_area();
  }

  CutCloud cut() {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const auto n = static_cast<double>(sources_.size());
      const Run part = run_.part(0.95 * static_cast<double>(i) / n, 0.95 * static_cast<double>(i + 1) / n);
      const auto& s = sources_[i];
      las::for_each_records(s.file->bytes(), s.info, part, out_.report,
                            [&](const std::uint8_t* records, std::size_t count) { deal(s, records, count); });
    }
    std::erase_if(tiles_, [](const auto& entry) { return entry.second.core_points == 0; });
    spill(true);
    if (tiles_.empty()) throw bad_input("the files hold no points", "a cloud");
    write_files();
    describe();
    return std::move(out_);
  }

 private:
  static std::vector<fs::path> split_paths(const std::string& text) {
    std::vector<fs::path> out;
    for (const auto& path : input_paths(*std::ranges::find(option_table(static_cast<const CutOptions*>(nullptr)).specs,
                                                           "files", &OptionSpec::name),
                                        text))
      out.emplace_back(path);
    if (out.empty()) throw bad_input("no file is given", "the files of a cloud", "Set files");
    return out;
  }

  const LasInfo& first() const { return sources_.front().info; }

  Eigen::Vector3d position(const std::array<std::int32_t, 3>& v) const {
    return first().offset + Eigen::Vector3d(v[0], v[1], v[2]).cwiseProduct(first().scale);
  }

  // The cells in which the spacing of the points is looked at, over the area that the headers declare.
  void expect_area() {
    Eigen::AlignedBox2d area;
    for (const auto& s : sources_)
      if (s.info.points > 0) area.extend(s.info.min.head<2>()).extend(s.info.max.head<2>());
    if (area.isEmpty()) return;
    spacing_cell_ = finest_spacing_m;
    const auto cells = [&] { return (area.sizes().array() / spacing_cell_ + 1).prod(); };
    while (cells() > max_spacing_cells) spacing_cell_ *= 2;
    spacing_corner_ = area.min();
    occupied_ = std::make_unique<OccupiedCells>(static_cast<int>(area.sizes().x() / spacing_cell_) + 1,
                                                static_cast<int>(area.sizes().y() / spacing_cell_) + 1);
  }

  void deal(const SourceFile& s, const std::uint8_t* records, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i, records += stride_) {
      std::array<std::int32_t, 3> v{};
      for (std::size_t k = 0; k < 3; ++k) v[k] = las::load<std::int32_t>(records + 4 * k) + s.shift[k];
      const Eigen::Vector2d p = position(v).head<2>();
      for (std::size_t k = 0; k < 3; ++k)
        box_.min[k] = std::min(box_.min[k], v[k]), box_.max[k] = std::max(box_.max[k], v[k]);
      const Eigen::Array2d cell = ((p - spacing_corner_) / spacing_cell_).array().floor();
      if (occupied_ && (cell >= 0).all() && cell.x() < occupied_->nx() && cell.y() < occupied_->ny())
        occupied_->occupy(static_cast<int>(cell.x()), static_cast<int>(cell.y()));
      const TilePlace own = grid_.at(p);
      grid_.for_each_over(p, [&](const TilePlace& place) { put(place, place == own, v, records); });
    }
    if (waiting_bytes_ <= max_bytes_in_memory) return;
    spill(false);
    if (waiting_bytes_ > max_bytes_in_memory / 2) spill(true);  // very many tiles with less than a chunk each
  }

  void put(const TilePlace& place, bool core, const std::array<std::int32_t, 3>& v, const std::uint8_t* record) {
    Tile& tile = tile_at(place);
    const std::size_t at = tile.waiting.size();
    tile.waiting.insert(tile.waiting.end(), record, record + stride_);
    for (std::size_t k = 0; k < 3; ++k) las::store(&tile.waiting[at + 4 * k], v[k]);
    tile.statistics.add(&tile.waiting[at], extended_);
    tile.core_points += core ? 1 : 0;
    waiting_bytes_ += stride_;
  }

  // Points that follow one another mostly lie in the same few tiles.
  Tile& tile_at(const TilePlace& place) {
    auto& recent = recent_[static_cast<std::size_t>(place.column & 3) * 4 + static_cast<std::size_t>(place.row & 3)];
    if (recent.second == nullptr || !(recent.first == place)) {
      recent = {place, &tiles_[place]};
      if (tiles_.size() > max_tiles)
        throw bad_input(fmt::format("the points lie in more than {} tiles of {:g} m", max_tiles, options_.tile_m),
                        "tiles that fit the cloud",
                        "Set tile to a larger side; bole info shows how far the cloud reaches");
    }
    return *recent.second;
  }

  // Records that wait go on file: full chunks, or all.
  void spill(bool all) {
    run_.check_cancel();
    tbb::parallel_for_each(tiles_.begin(), tiles_.end(), [&](auto& entry) {
      auto& [place, tile] = entry;
      if (tile.waiting.empty() || run_.cancelled()) return;
      if (!tile.parts) tile.parts = std::make_unique<las::TileParts>(folder_ / (tile_name(place) + ".parts"), first());
      tile.parts->take(tile.waiting, all);
    });
    run_.check_cancel();
    waiting_bytes_ = 0;
    for (const auto& [place, tile] : tiles_) waiting_bytes_ += tile.waiting.size();
  }

  // The origin that a reader of the whole would take, and its least coordinates as offsets from it.
  WholeCloud whole() const {
    WholeCloud out;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double scale = first().scale[axis], offset = first().offset[axis];
      const std::int32_t middle = las::grid_middle(box_.min[k], box_.max[k], scale, offset);
      out.origin[axis] = offset + middle * scale;
      out.low[axis] =
          static_cast<double>(static_cast<float>(static_cast<double>(std::int64_t{box_.min[k]} - middle) * scale));
    }
    return out;
  }

  Facts facts_of_tiles() {
    std::vector<std::string> warnings;
    Facts facts = las::read_facts(sources_.front().file->bytes(), first(), warnings);
    for (auto& text : warnings) out_.report.warn(std::move(text));
    spacing_m_ = occupied_ ? spacing_of(std::move(*occupied_), spacing_cell_) : finest_spacing_m;
    set_whole(facts, whole(), spacing_m_);
    std::uint64_t points = 0;
    for (const auto& [place, tile] : tiles_) points += tile.core_points;
    facts[std::string(facts::whole_points.key)] = std::to_string(points);
    if (options_.breast_height) set_fact(facts, facts::breast_height, *options_.breast_height);
    return facts;
  }

  void write_files() {
    const Facts facts = facts_of_tiles();
    const Bytes source = sources_.front().file->bytes();
    const auto work = [&](auto& entry) {
      auto& [place, tile] = entry;
      if (run_.cancelled()) return;
      Run quiet;
      quiet.cancel = run_.cancel;
      las::write_tile_file(folder_ / (tile_name(place) + ".laz"), *tile.parts, source, first(), tile.statistics, facts,
                           quiet);
      tile.parts.reset();
    };
    // In batches: progress is told between them, from this thread.
    constexpr std::size_t batch = 16;
    std::size_t done = 0;
    for (auto it = tiles_.begin(); it != tiles_.end();) {
      auto end = it;
      for (std::size_t i = 0; i < batch && end != tiles_.end(); ++i) ++end;
      tbb::parallel_for_each(it, end, work);
      run_.check_cancel();
      done += static_cast<std::size_t>(std::distance(it, end));
      run_.report(0.95 + 0.05 * static_cast<double>(done) / static_cast<double>(tiles_.size()), "writing tiles");
      it = end;
    }
  }

  void describe() {
    std::vector<std::string> name, file;
    std::vector<std::int64_t> column, row, points, core_points;
    std::array<std::vector<double>, 4> bounds;
    for (const auto& [place, tile] : tiles_) {
      name.push_back(tile_name(place));
      file.push_back(name.back() + ".laz");
      column.push_back(place.column);
      row.push_back(place.row);
      points.push_back(static_cast<std::int64_t>(tile.statistics.points));
      core_points.push_back(static_cast<std::int64_t>(tile.core_points));
      const auto core = grid_.core(place);
      bounds[0].push_back(core.min().x());
      bounds[1].push_back(core.min().y());
      bounds[2].push_back(core.max().x());
      bounds[3].push_back(core.max().y());
      out_.report.counts["points"] += core_points.back();
      out_.report.counts["points_in_tiles"] += points.back();
    }
    auto& t = out_.tiles;
    t.set("name", name);
    t.set("file", file);
    t.set("column", column);
    t.set("row", row);
    constexpr std::array names{"xmin_m", "ymin_m", "xmax_m", "ymax_m"};
    for (std::size_t k = 0; k < 4; ++k) t.set(names[k], bounds[k]);
    t.set("points", points);
    t.set("core_points", core_points);
    auto& r = out_.report;
    r.counts["tiles"] = static_cast<std::int64_t>(tiles_.size());
    r.metrics["point_spacing"] = {spacing_m_, Unit::metre};
    r.message = fmt::format("{} points in {} tiles of {:g} m with buffers of {:g} m, {} of them repeated in buffers",
                            r.counts["points"], tiles_.size(), grid_.tile_m, grid_.buffer_m,
                            r.counts["points_in_tiles"] - r.counts["points"]);
  }

  const CutOptions& options_;
  fs::path folder_;
  const Run& run_;
  std::vector<SourceFile> sources_;
  TileGrid grid_;
  std::size_t stride_ = 0, waiting_bytes_ = 0;
  bool extended_ = true;
  las::IntegerBox box_;
  std::map<TilePlace, Tile> tiles_;
  std::array<std::pair<TilePlace, Tile*>, 16> recent_{};
  std::unique_ptr<OccupiedCells> occupied_;
  Eigen::Vector2d spacing_corner_ = Eigen::Vector2d::Zero();
  double spacing_cell_ = finest_spacing_m, spacing_m_ = finest_spacing_m;
  CutCloud out_;
};

}  // namespace

CutCloud cut_cloud(const CutOptions& options, const fs::path& folder, const Run& run) {
  return Cutter(options, folder, run).cut();
}

}  // namespace bole::io
