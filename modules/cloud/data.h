// What flows between stages.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "cloud/core/view_source.h"
#include "cloud/point_cloud.h"
#include "cloud/raster.h"
#include "cloud/scan_frame.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"

namespace bole {
inline namespace cloud {

// In the order of the variant below.
enum class DataKind { none, cloud, table, raster, trajectory, frames, views };
std::string_view data_kind_name(DataKind kind);

using Data = std::variant<std::monostate, std::shared_ptr<const PointCloud>, std::shared_ptr<const Table>,
                          std::shared_ptr<const Raster>, std::shared_ptr<const Trajectory>,
                          std::shared_ptr<const FrameSource>, std::shared_ptr<const ViewSource>>;

inline DataKind data_kind(const Data& data) { return static_cast<DataKind>(data.index()); }

// The inputs or outputs of a stage, by port name.
class DataSet {
 public:
  void set(std::string_view port, Data data) { data_.insert_or_assign(std::string(port), std::move(data)); }
  void set(std::string_view port, PointCloud v) { set(port, Data(std::make_shared<const PointCloud>(std::move(v)))); }
  void set(std::string_view port, Table v) { set(port, Data(std::make_shared<const Table>(std::move(v)))); }
  void set(std::string_view port, Raster v) { set(port, Data(std::make_shared<const Raster>(std::move(v)))); }
  void set(std::string_view port, Trajectory v) { set(port, Data(std::make_shared<const Trajectory>(std::move(v)))); }

  bool has(std::string_view port) const;
  // The data of a port; throws Error{bad_input} when the port is not connected or holds another kind.
  const PointCloud& cloud(std::string_view port) const { return *get<PointCloud>(port); }
  const Table& table(std::string_view port) const { return *get<Table>(port); }
  const Raster& raster(std::string_view port) const { return *get<Raster>(port); }
  const Trajectory& trajectory(std::string_view port) const { return *get<Trajectory>(port); }
  const FrameSource& frames(std::string_view port) const { return *get<FrameSource>(port); }
  const ViewSource& views(std::string_view port) const { return *get<ViewSource>(port); }

  const std::map<std::string, Data, std::less<>>& all() const { return data_; }

  template <class T>
  std::shared_ptr<const T> get(std::string_view port) const {
    if (const auto it = data_.find(port); it != data_.end())
      if (const auto* p = std::get_if<std::shared_ptr<const T>>(&it->second); p && *p) return *p;
    throw missing(port);
  }

 private:
  static Error missing(std::string_view port);
  std::map<std::string, Data, std::less<>> data_;
};

}  // namespace cloud
}  // namespace bole
