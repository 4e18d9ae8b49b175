#include "cloud/serialize.h"

#include <array>
#include <cstring>
#include <nlohmann/json.hpp>

#include "cloud/large_cloud.h"

namespace bole {
inline namespace cloud {
namespace {

using nlohmann::json;

Error damaged(const std::string& what) {
  return failure("stored result: " + what, "what was written", "Delete the cache folder if this stays");
}

template <class T>
std::string put_vector(const std::vector<T>& values, BlobStore& store) {
  return store.put(std::as_bytes(std::span(values)));
}

template <class T>
std::vector<T> get_vector(const json& id, std::size_t count, const BlobStore& store) {
  const auto name = id.get<std::string>();
  const std::size_t bytes = store.size(name);
  if (bytes != count * sizeof(T))
    throw damaged("an array has " + std::to_string(bytes) + " bytes instead of " + std::to_string(count * sizeof(T)));
  std::vector<T> values(count);
  store.get(name, std::as_writable_bytes(std::span(values)));
  return values;
}

// ---- clouds

constexpr std::string_view positions_tag = "positions";

json put_vector3(const Eigen::Vector3d& v) { return json::array({v.x(), v.y(), v.z()}); }
Eigen::Vector3d get_vector3(const json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

json store_cloud(const PointCloud& cloud, BlobStore& store) {
  json j{{"size", cloud.size()}, {"origin", put_vector3(cloud.origin)}, {"axes", axes_name(cloud.axes)},
         {"crs", cloud.crs_wkt}, {"scale", put_vector3(cloud.scale)},   {"facts", cloud.facts}};
  j["positions"] = put_vector(cloud.positions(), store);
  j["columns"] = json::object();
  for (const auto& [name, column] : cloud.columns()) {
    const std::string id = std::visit([&](const auto& values) { return put_vector(values, store); }, *column);
    leave_memory(*column, 0, cloud.size());
    j["columns"][name] = {{"type", array_type_name(column_type(*column))}, {"blob", id}};
  }
  return j;
}

ArrayType type_from_name(const std::string& name) {
  for (const auto type :
       {ArrayType::uint8, ArrayType::uint16, ArrayType::int32, ArrayType::float32, ArrayType::float64})
    if (array_type_name(type) == name) return type;
  throw damaged("array type '" + name + "'");
}

std::size_t stored_bytes(const json& columns, const BlobStore& store) {
  std::size_t bytes = 0;
  for (const auto& [name, column] : columns.items()) bytes += store.size(column.at("blob").get<std::string>());
  return bytes;
}

// `on_file`: the cloud is so large that its columns are not kept in memory.
std::shared_ptr<const Column> load_column(const json& j, std::size_t size, bool on_file, const BlobStore& store) {
  const auto id = j.at("blob").get<std::string>();
  const auto type_name = j.at("type").get<std::string>();
  if (auto shared = std::static_pointer_cast<const Column>(store.recall(id, type_name));
      shared && column_size(*shared) == size)
    return shared;
  Column column = make_column(type_from_name(type_name), 0);
  FilePages pages;
  std::visit(
      [&]<class T>(std::vector<T>& values) {
        values = get_vector<T>(j.at("blob"), size, store);
        const std::size_t bytes = size * sizeof(T);
        if (on_file && bytes >= min_file_bytes)
          pages = lay_on_file(values.data(), bytes, Content::keep, scratch_folders());
      },
      column);
  auto shared = column_with_pages(std::move(column), std::move(pages));
  leave_memory(*shared, 0, size);
  store.remember(id, type_name, shared);
  return shared;
}

std::shared_ptr<const PointCloud> load_cloud(const json& j, const BlobStore& store) {
  auto cloud = std::make_shared<PointCloud>();
  cloud->origin = get_vector3(j.at("origin"));
  cloud->scale = get_vector3(j.at("scale"));
  cloud->axes = axes_from_name(j.at("axes").get<std::string>());
  cloud->crs_wkt = j.at("crs").get<std::string>();
  cloud->facts = j.at("facts").get<Facts>();
  const auto size = j.at("size").get<std::size_t>();
  const auto id = j.at("positions").get<std::string>();
  auto positions = std::static_pointer_cast<const PointCloud::Positions>(store.recall(id, positions_tag));
  if (!positions || positions->size() != size) {
    positions =
        std::make_shared<const PointCloud::Positions>(get_vector<Eigen::Vector3f>(j.at("positions"), size, store));
    store.remember(id, positions_tag, positions);
  }
  cloud->share_positions(positions);
  const bool large = stored_bytes(j.at("columns"), store) > large_columns_bytes;
  for (const auto& [name, column] : j.at("columns").items())
    cloud->share_column(name, load_column(column, size, large, store));
  return cloud;
}

// ---- tables

std::string put_texts(const std::vector<std::string>& texts, BlobStore& store) {
  std::string bytes;
  for (const auto& text : texts) {
    const auto length = static_cast<std::uint32_t>(text.size());
    bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
    bytes += text;
  }
  return store.put(std::as_bytes(std::span(bytes)));
}

std::vector<std::string> get_texts(const std::string& id, std::size_t rows, const BlobStore& store) {
  std::string bytes(store.size(id), '\0');
  store.get(id, std::as_writable_bytes(std::span(bytes)));
  std::vector<std::string> texts;
  std::size_t at = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    std::uint32_t length = 0;
    if (bytes.size() - at < sizeof length) throw damaged("a text column ends early");
    std::memcpy(&length, bytes.data() + at, sizeof length);
    at += sizeof length;
    if (bytes.size() - at < length) throw damaged("a text column ends early");
    texts.emplace_back(bytes, at, length);
    at += length;
  }
  return texts;
}

json store_table(const Table& table, BlobStore& store) {
  json j{{"rows", table.rows()}, {"facts", table.facts}, {"columns", json::array()}};
  for (const auto& column : table.columns()) {
    json c{{"name", column.name}};
    if (const auto* numbers = std::get_if<std::vector<double>>(&column.values))
      c["type"] = "number", c["blob"] = put_vector(*numbers, store);
    if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&column.values))
      c["type"] = "integer", c["blob"] = put_vector(*integers, store);
    if (const auto* texts = std::get_if<std::vector<std::string>>(&column.values))
      c["type"] = "text", c["blob"] = put_texts(*texts, store);
    j["columns"].push_back(std::move(c));
  }
  return j;
}

std::shared_ptr<const Table> load_table(const json& j, const BlobStore& store) {
  auto table = std::make_shared<Table>();
  table->facts = j.at("facts").get<Facts>();
  const auto rows = j.at("rows").get<std::size_t>();
  for (const auto& c : j.at("columns")) {
    const auto name = c.at("name").get<std::string>();
    const auto type = c.at("type").get<std::string>();
    if (type == "number")
      table->set(name, get_vector<double>(c.at("blob"), rows, store));
    else if (type == "integer")
      table->set(name, get_vector<std::int64_t>(c.at("blob"), rows, store));
    else if (type == "text")
      table->set(name, get_texts(c.at("blob").get<std::string>(), rows, store));
    else
      throw damaged("column type '" + type + "'");
  }
  return table;
}

// ---- rasters and trajectories

json store_raster(const Raster& raster, BlobStore& store) {
  return {{"origin", json::array({raster.origin.x(), raster.origin.y()})},
          {"cell_m", raster.cell_m},
          {"nx", raster.nx},
          {"ny", raster.ny},
          {"axes", axes_name(raster.axes)},
          {"crs", raster.crs_wkt},
          {"quantity", raster.quantity},
          {"values", put_vector(raster.values, store)}};
}

std::shared_ptr<const Raster> load_raster(const json& j, const BlobStore& store) {
  auto raster = std::make_shared<Raster>();
  raster->origin = {j.at("origin").at(0).get<double>(), j.at("origin").at(1).get<double>()};
  raster->cell_m = j.at("cell_m").get<double>();
  raster->nx = j.at("nx").get<int>(), raster->ny = j.at("ny").get<int>();
  raster->axes = axes_from_name(j.at("axes").get<std::string>());
  raster->crs_wkt = j.at("crs").get<std::string>();
  raster->quantity = j.at("quantity").get<std::string>();
  raster->values = get_vector<float>(
      j.at("values"), static_cast<std::size_t>(raster->nx) * static_cast<std::size_t>(raster->ny), store);
  return raster;
}

using PoseRow = std::array<double, 13>;  // time, then the upper three rows of the matrix

json store_trajectory(const Trajectory& trajectory, BlobStore& store) {
  std::vector<PoseRow> rows;
  for (const auto& pose : trajectory.poses) {
    PoseRow row{pose.time_s};
    Eigen::Map<Eigen::Matrix<double, 3, 4>>(row.data() + 1) = pose.T_target_sensor.affine();
    rows.push_back(row);
  }
  return {{"size", rows.size()},
          {"axes", axes_name(trajectory.axes)},
          {"facts", trajectory.facts},
          {"poses", put_vector(rows, store)}};
}

std::shared_ptr<const Trajectory> load_trajectory(const json& j, const BlobStore& store) {
  auto trajectory = std::make_shared<Trajectory>();
  trajectory->axes = axes_from_name(j.at("axes").get<std::string>());
  trajectory->facts = j.at("facts").get<Facts>();
  for (const auto& row : get_vector<PoseRow>(j.at("poses"), j.at("size").get<std::size_t>(), store)) {
    StampedPose pose{row[0], Pose::Identity()};
    pose.T_target_sensor.affine() = Eigen::Map<const Eigen::Matrix<double, 3, 4>>(row.data() + 1);
    trajectory->poses.push_back(pose);
  }
  return trajectory;
}

void collect_blobs(const json& j, const std::string& key, std::vector<std::string>& ids) {
  if (j.is_structured())
    for (const auto& [k, value] : j.items()) {
      if (k != "facts") collect_blobs(value, k, ids);
    }
  else if (j.is_string() && (key == "blob" || key == "positions" || key == "values" || key == "poses"))
    ids.push_back(j.get<std::string>());
}

}  // namespace

std::shared_ptr<const void> BlobStore::recall(const std::string& id, std::string_view type) const {
  const std::lock_guard lock(mutex_);
  const auto it = loaded_.find(id + ":" + std::string(type));
  return it == loaded_.end() ? nullptr : it->second.lock();
}

void BlobStore::remember(const std::string& id, std::string_view type, const std::shared_ptr<const void>& array) const {
  const std::lock_guard lock(mutex_);
  loaded_.insert_or_assign(id + ":" + std::string(type), array);
}

std::string store_data(const Data& data, BlobStore& store) {
  json j;
  switch (data_kind(data)) {
    case DataKind::none:
      break;
    case DataKind::cloud:
      j = store_cloud(*std::get<std::shared_ptr<const PointCloud>>(data), store);
      break;
    case DataKind::table:
      j = store_table(*std::get<std::shared_ptr<const Table>>(data), store);
      break;
    case DataKind::raster:
      j = store_raster(*std::get<std::shared_ptr<const Raster>>(data), store);
      break;
    case DataKind::trajectory:
      j = store_trajectory(*std::get<std::shared_ptr<const Trajectory>>(data), store);
      break;
    case DataKind::frames:
      j = {{"locator", std::get<std::shared_ptr<const FrameSource>>(data)->locator()}};
      break;
    case DataKind::views:
      j = {{"locator", std::get<std::shared_ptr<const ViewSource>>(data)->locator()}};
      break;
  }
  j["kind"] = data_kind_name(data_kind(data));
  try {
    return j.dump();
  } catch (const json::exception& e) {  // a text that is not UTF-8
    throw failure(std::string("a result cannot be stored: ") + e.what());
  }
}

Data load_data(std::string_view text, const BlobStore& store, const SourceOpener& open_source) {
  try {
    const json j = json::parse(text);
    const auto kind = j.at("kind").get<std::string>();
    if (kind == "cloud") return load_cloud(j, store);
    if (kind == "table") return load_table(j, store);
    if (kind == "raster") return load_raster(j, store);
    if (kind == "trajectory") return load_trajectory(j, store);
    if (kind == "frames" || kind == "views") return open_source(j.at("locator").get<std::string>());
    if (kind == "none") return {};
    throw damaged("kind '" + kind + "'");
  } catch (const json::exception& e) {
    throw damaged(e.what());
  }
}

std::vector<std::string> stored_blobs(std::string_view text) {
  std::vector<std::string> ids;
  try {
    collect_blobs(json::parse(text), "", ids);
  } catch (const json::exception& e) {
    throw damaged(e.what());
  }
  return ids;
}

}  // namespace cloud
}  // namespace bole
