#include "sim/core/plot/truth.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "base/angles.h"
#include "base/error.h"

namespace bole::sim {
namespace {

class TextFile {
 public:
  explicit TextFile(const std::filesystem::path& path) : path_(path), out_(path, std::ios::binary) {}
  std::ofstream& stream() { return out_; }
  void close() {
    out_.close();
    if (!out_) throw failure("cannot write " + path_.string(), "a writable folder with free space");
  }

 private:
  std::filesystem::path path_;
  std::ofstream out_;
};

}  // namespace

Table tree_table(const Forest& forest) {
  std::vector<std::int64_t> id, in_plot, twin;
  std::vector<double> x, y, z, dbh, height, lean, azimuth, base_x, base_y, bark;
  std::vector<std::string> state, species;
  for (const auto& t : forest.trees) {
    id.push_back(t.id);
    in_plot.push_back(t.in_plot);
    twin.push_back(t.twin_of);
    x.push_back(t.taped.centre.x());
    y.push_back(t.taped.centre.y());
    z.push_back(t.taped.ground_z_m);
    dbh.push_back(100 * t.taped.diameter_m);
    height.push_back(t.stem.axis(t.stem.end_m).z() - t.taped.ground_z_m);
    lean.push_back(deg_per_rad * std::acos(std::min(1.0, t.taped.axis.z())));
    const double a = deg_per_rad * std::atan2(t.taped.axis.x(), t.taped.axis.y());
    azimuth.push_back(a < 0 ? a + 360 : a);
    state.emplace_back(t.alive ? "alive" : "dead");
    species.push_back(t.species_name);
    bark.push_back(1000 * t.stem.bark_depth_m);
    base_x.push_back(t.stem.foot.x());
    base_y.push_back(t.stem.foot.y());
  }
  Table table;
  table.facts["axes"] = "plot";
  table.set("tree_id", id);
  table.set("x_m", x);
  table.set("y_m", y);
  table.set("z_m", z);
  table.set("dbh_cm", dbh);
  table.set("height_m", height);
  table.set("lean_deg", lean);

  table.set("lean_azimuth_deg", azimuth);
  table.set("state", state);
  table.set("in_plot", in_plot);
  table.set("species", species);
  table.set("base_x_m", base_x);
  table.set("base_y_m", base_y);
  table.set("twin_of", twin);
  if (!forest.recipe.trees.species.empty()) table.set("bark_mm", bark);
  return table;
}

Table sapling_table(const std::vector<Sapling>& saplings) {
  std::vector<std::int64_t> id;
  std::vector<double> x, y, z, dbh, height;
  for (const auto& s : saplings) {
    id.push_back(static_cast<std::int64_t>(id.size()) + 1);
    x.push_back(s.taped.centre.x());
    y.push_back(s.taped.centre.y());
    z.push_back(s.taped.ground_z_m);
    dbh.push_back(100 * s.taped.diameter_m);
    height.push_back(s.stem.end_m);
  }
  Table table;
  table.facts["axes"] = "plot";
  table.set("sapling_id", id);
  table.set("x_m", x);
  table.set("y_m", y);
  table.set("z_m", z);
  table.set("dbh_cm", dbh);

  table.set("height_m", height);
  return table;
}

Table target_table(const Forest& forest) {
  std::vector<std::string> name;
  std::vector<double> x, y, z, diameter, height;
  for (const auto& t : forest.targets) {
    name.push_back(t.name);
    x.push_back(t.middle.x());
    y.push_back(t.middle.y());
    z.push_back(t.middle.z());
    diameter.push_back(2 * t.radius_m);

    height.push_back(t.height_m);
  }
  Table table;
  table.facts["axes"] = "plot";
  table.set("name", name);
  table.set("x_m", x);
  table.set("y_m", y);
  table.set("z_m", z);

  table.set("diameter_m", diameter);
  table.set("height_m", height);
  return table;
}

void write_csv(const Table& table, const std::filesystem::path& path) {
  TextFile file(path);
  const auto& columns = table.columns();
  for (std::size_t c = 0; c < columns.size(); ++c) file.stream() << (c ? "," : "") << columns[c].name;
  file.stream() << '\n';
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      file.stream() << (c ? "," : "") << table.text(columns[c].name, row, 4);
    file.stream() << '\n';
  }
  file.close();
}

void write_tum(const Trajectory& trajectory, const std::filesystem::path& path) {
  TextFile file(path);
  file.stream() << "# time_s x_m y_m z_m qx qy qz qw (sensor in plot axes)\n";
  for (const auto& p : trajectory.poses) {
    const Eigen::Vector3d t = p.T_target_sensor.translation();
    Eigen::Quaterniond q(p.T_target_sensor.linear());
    if (q.w() < 0) q.coeffs() *= -1;
    file.stream() << fmt::format("{:.6f} {:.6f} {:.6f} {:.6f} {:.9f} {:.9f} {:.9f} {:.9f}\n", p.time_s, t.x(), t.y(),
                                 t.z(), q.x(), q.y(), q.z(), q.w());
  }
  file.close();
}

}  // namespace bole::sim
