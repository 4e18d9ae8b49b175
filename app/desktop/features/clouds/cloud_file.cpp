#include "features/clouds/cloud_file.h"

#include <QColor>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"

namespace bole::desktop {
namespace {

constexpr double max_cloud_coordinate_m = 1e9, max_point_px = 12;

// Okabe and Ito (2008), Color universal design; those that stand out on the colour maps first.
constexpr std::array cloud_colors{render::hex(0xd55e00), render::hex(0xcc79a7), render::hex(0x56b4e9),
                                  render::hex(0xe69f00), render::hex(0x0072b2), render::hex(0x009e73)};

QString path_from(const QDir& folder, const QString& path) {
  const QString from_there = folder.relativeFilePath(path);
  return from_there.startsWith("../../") ? path : from_there;
}

Error wrong_entry(int number, const QString& what, const QString& needed) {
  return bad_input("cloud " + std::to_string(number) + " of the list " + what.toStdString(), needed.toStdString(),
                   "Move the file away, or correct it");
}

double number_of(const QJsonValue& value, int number, double max) {
  if (value.isUndefined()) return 0;
  if (!value.isDouble() || !(std::abs(value.toDouble()) <= max))
    throw wrong_entry(number, "holds something else than a number", "metres, degrees or pixels");
  return value.toDouble();
}

template <int size>
Eigen::Matrix<double, size, 1> numbers_of(const QJsonValue& value, int number) {
  Eigen::Matrix<double, size, 1> numbers = Eigen::Matrix<double, size, 1>::Zero();
  if (value.isUndefined()) return numbers;
  const auto list = value.toArray();
  if (list.size() != size)
    throw wrong_entry(number, "has a place of " + QString::number(list.size()) + " numbers", QString::number(size));
  for (int k = 0; k < size; ++k) numbers[k] = number_of(list[k], number, max_cloud_coordinate_m);
  return numbers;
}

CloudEntry entry_of(const QJsonObject& object, int number, const QDir& folder) {
  CloudEntry entry;
  const QString file = object.value("file").toString();
  if (file.isEmpty()) throw wrong_entry(number, "names no file", "\"file\"");
  entry.path = QDir::cleanPath(folder.absoluteFilePath(file));
  entry.visible = object.value("visible").toBool(true);
  const QColor color(object.value("color").toString());
  entry.color = color.isValid() ? render::hex(color.rgb() & 0xffffffU) : cloud_colors.front();
  entry.color_by = object.value("color_by").toString().toStdString();
  entry.point_px = std::clamp(number_of(object.value("point_size"), number, max_point_px), 0.0, max_point_px);
  if (object.contains("opacity"))
    entry.opacity = std::clamp(number_of(object.value("opacity"), number, 1), min_opacity, 1.0);
  entry.at.shift_m = numbers_of<3>(object.value("shift_m"), number);
  entry.at.turn_deg = number_of(object.value("turn_deg"), number, 360);
  entry.at.tilt_x_deg = number_of(object.value("tilt_x_deg"), number, 360);
  entry.at.tilt_y_deg = number_of(object.value("tilt_y_deg"), number, 360);
  if (object.contains("scale")) entry.at.scale = number_of(object.value("scale"), number, max_scale);
  if (!(entry.at.scale >= min_scale))
    throw wrong_entry(number, "has a scale of " + QString::number(entry.at.scale), "0.001 to 1000");
  const auto about = object.value("turn_about_m");
  if (about.toArray().size() == 3) {
    const auto pivot = numbers_of<3>(about, number);
    entry.pivot_m = pivot.head<2>();
    entry.pivot_z_m = pivot.z();
  } else if (object.contains("turn_about_m")) {
    entry.pivot_m = numbers_of<2>(about, number);
  }
  return entry;
}

}  // namespace

QString CloudEntry::name() const { return QFileInfo(path).fileName(); }

render::CloudPlace CloudEntry::place() const {
  return {at.shift_m, radians(at.turn_deg), radians(at.tilt_x_deg), radians(at.tilt_y_deg), at.scale, pivot()};
}

Eigen::Vector3d CloudEntry::pivot() const {
  const Eigen::Vector2d plan = pivot_m.value_or(Eigen::Vector2d::Zero());
  return {plan.x(), plan.y(), pivot_z_m.value_or(0)};
}

void CloudEntry::know_pivot() {
  const Eigen::Vector3d middle = ((read->extent.lo + read->extent.hi) / 2).array().round();
  if (!pivot_m) pivot_m = middle.head<2>();
  if (!pivot_z_m) pivot_z_m = middle.z();
}

render::Color free_cloud_color(const std::vector<CloudEntry>& taken) {
  const auto uses = [&](const render::Color& color) {
    return std::ranges::count_if(taken, [&](const CloudEntry& entry) {
      return entry.color.r == color.r && entry.color.g == color.g && entry.color.b == color.b;
    });
  };
  return *std::ranges::min_element(cloud_colors, {}, uses);
}

QByteArray clouds_json(const std::vector<CloudEntry>& list, const QDir& folder) {
  QJsonArray clouds;
  for (const auto& entry : list) {
    QJsonObject object{{"file", path_from(folder, entry.path)},
                       {"visible", entry.visible},
                       {"color", QColor::fromRgbF(entry.color.r, entry.color.g, entry.color.b).name()},
                       {"shift_m", QJsonArray{entry.at.shift_m.x(), entry.at.shift_m.y(), entry.at.shift_m.z()}},
                       {"turn_deg", entry.at.turn_deg}};
    if (entry.at.tilt_x_deg != 0) object["tilt_x_deg"] = entry.at.tilt_x_deg;
    if (entry.at.tilt_y_deg != 0) object["tilt_y_deg"] = entry.at.tilt_y_deg;
    if (entry.at.scale != 1) object["scale"] = entry.at.scale;
    if (entry.opacity < 1) object["opacity"] = entry.opacity;
    const bool lasts = !entry.distances || !is_of_distances(entry.color_by);  // distances are measured anew
    const auto& color_by = lasts ? entry.color_by : entry.distances->color_before;
    if (!color_by.empty()) object["color_by"] = QString::fromStdString(color_by);
    if (entry.point_px > 0) object["point_size"] = entry.point_px;
    if (entry.pivot_m) {
      QJsonArray about{entry.pivot_m->x(), entry.pivot_m->y()};
      if (entry.pivot_z_m) about.append(*entry.pivot_z_m);
      object["turn_about_m"] = about;
    }
    clouds.append(object);
  }
  return QJsonDocument(QJsonObject{{"clouds", clouds}}).toJson();
}

std::vector<CloudEntry> parse_clouds(const QByteArray& json, const QDir& folder) {
  const auto root = QJsonDocument::fromJson(json);
  if (!root.isObject() || !root.object().value("clouds").isArray())
    throw bad_input("it is no list of clouds", "a JSON object with \"clouds\"", "Move the file away");
  std::vector<CloudEntry> list;
  for (const auto& value : root.object().value("clouds").toArray())
    list.push_back(entry_of(value.toObject(), static_cast<int>(list.size()) + 1, folder));
  return list;
}

}  // namespace bole::desktop
