#include "io/core/views/colmap_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

#include "base/error.h"
#include "io/core/bytes/line_reader.h"

namespace bole::io {
namespace {

struct Model {
  std::string_view name;
  std::size_t parameters;
};
// In the order of COLMAP's numbers.
constexpr std::array models{Model{"SIMPLE_PINHOLE", 3},
                            Model{"PINHOLE", 4},
                            Model{"SIMPLE_RADIAL", 4},
                            Model{"RADIAL", 5},
                            Model{"OPENCV", 8},
                            Model{"OPENCV_FISHEYE", 8},
                            Model{"FULL_OPENCV", 12},
                            Model{"FOV", 5},
                            Model{"SIMPLE_RADIAL_FISHEYE", 4},
                            Model{"RADIAL_FISHEYE", 5},
                            Model{"THIN_PRISM_FISHEYE", 12}};

constexpr const char* known_models = "SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL or OPENCV";

// Numbers in the order of the file, little-endian.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  template <class T>
  T next() {
    T value{};
    if (bytes_.size() - at_ < sizeof(T)) throw bad_input("the file is cut off", "a whole file of COLMAP");
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  // A number of entries, each of at least `bytes`.
  std::size_t next_count(std::size_t bytes) {
    const auto count = next<std::uint64_t>();
    if (count > (bytes_.size() - at_) / bytes)
      throw bad_input("the file claims " + std::to_string(count) + " entries and has " +
                          std::to_string(bytes_.size() - at_) + " bytes for them",
                      "a whole file of COLMAP");
    return static_cast<std::size_t>(count);
  }
  std::string next_name() {
    const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto end = std::find(begin, bytes_.end(), std::uint8_t{0});
    if (end == bytes_.end() || end - begin > 4096) throw bad_input("a name has no end", "a whole file of COLMAP");
    at_ += static_cast<std::size_t>(end - begin) + 1;
    return {begin, end};
  }
  void skip(std::size_t bytes) {
    if (bytes_.size() - at_ < bytes) throw bad_input("the file is cut off", "a whole file of COLMAP");
    at_ += bytes;
  }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
};

void refuse_model(std::string_view name) {
  throw bad_input("a camera has the model " + std::string(name), known_models,
                  "Undistort the images with colmap image_undistorter first");
}

CameraModel camera_of_model(const Model& model, std::uint64_t width, std::uint64_t height,
                            const std::vector<double>& p) {
  CameraModel camera;
  if (width > 1'000'000 || height > 1'000'000)
    throw bad_input("a camera has " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
                    "the size of its images");
  camera.width = static_cast<int>(width);
  camera.height = static_cast<int>(height);
  const bool one_focal_length = model.name.starts_with("SIMPLE") || model.name == "RADIAL";
  const std::size_t center = one_focal_length ? 1 : 2;
  camera.fx = p[0];
  camera.fy = p[center - 1];
  camera.cx = p[center] - 0.5;
  camera.cy = p[center + 1] - 0.5;
  const auto rest = center + 2;
  if (model.name.find("FISHEYE") != std::string_view::npos || model.name == "FOV") refuse_model(model.name);
  for (std::size_t i = rest; i < std::min(p.size(), rest + 5); ++i) camera.distortion[i - rest] = p[i];
  if (model.name == "FULL_OPENCV" && std::any_of(p.begin() + 9, p.end(), [](double k) { return k != 0; }))
    refuse_model(model.name);
  camera.check();
  return camera;
}

void add_camera(std::uint32_t id, const CameraModel& camera, ColmapCameras& cameras) {
  if (!cameras.emplace(id, camera).second)
    throw bad_input("two cameras have the number " + std::to_string(id), "a number of its own for each");
}

// Calls `use(words, place)` for each line that is no comment. Where `empty_too`, lines without words count.
template <class Use>
void for_each_line(Bytes file, Use&& use, bool empty_too = false) {
  LineReader lines(file);
  std::string_view line;
  while (lines.next(line)) {
    line = trimmed(line);
    if ((line.empty() && !empty_too) || (!line.empty() && line.front() == '#')) continue;
    use(split_blanks(line), "line " + std::to_string(lines.number()));
  }
}

template <class T>
T number_of(std::string_view word, const std::string& place) {
  T value{};
  if (!parse_number(word, value)) throw bad_input(place + " has '" + std::string(word.substr(0, 40)) + "'", "a number");
  return value;
}

double finite(double value, const std::string& place) {
  if (!std::isfinite(value)) throw bad_input(place + " has a value that is no number", "a number");
  return value;
}

ColmapCameras cameras_of_text(Bytes file) {
  constexpr const char* needed = "CAMERA_ID MODEL WIDTH HEIGHT PARAMETERS";
  ColmapCameras cameras;
  for_each_line(file, [&](const std::vector<std::string_view>& words, const std::string& place) {
    if (words.size() < 5) throw bad_input(place + " has " + std::to_string(words.size()) + " words", needed);
    const auto model = std::ranges::find(models, words[1], &Model::name);
    if (model == models.end()) refuse_model(words[1].substr(0, 40));
    if (words.size() != 4 + model->parameters)
      throw bad_input(place + " has " + std::to_string(words.size() - 4) + " parameters",
                      std::to_string(model->parameters) + " for " + std::string(model->name));
    std::vector<double> parameters;
    for (std::size_t i = 4; i < words.size(); ++i)
      parameters.push_back(finite(number_of<double>(words[i], place), place));
    add_camera(number_of<std::uint32_t>(words[0], place),
               camera_of_model(*model, number_of<std::uint64_t>(words[2], place),
                               number_of<std::uint64_t>(words[3], place), parameters),
               cameras);
  });
  return cameras;
}

ColmapCameras cameras_of_bytes(Bytes file) {
  ByteReader reader(file);
  ColmapCameras cameras;
  const auto count = reader.next_count(24 + 3 * 8);
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = "camera " + std::to_string(i);
    const auto id = reader.next<std::uint32_t>();
    const auto number = reader.next<std::uint32_t>();
    if (number >= models.size()) refuse_model("number " + std::to_string(number));
    const auto width = reader.next<std::uint64_t>(), height = reader.next<std::uint64_t>();
    std::vector<double> parameters;
    for (std::size_t k = 0; k < models[number].parameters; ++k)
      parameters.push_back(finite(reader.next<double>(), place));
    add_camera(id, camera_of_model(models[number], width, height, parameters), cameras);
  }
  return cameras;
}

// COLMAP gives T_camera_world as quaternion (w first) and translation.
Pose pose_of_image(const std::array<double, 7>& v, const std::string& place) {
  for (const double x : v) finite(x, place);
  const Eigen::Quaterniond q(v[0], v[1], v[2], v[3]);
  if (!(std::abs(q.norm() - 1) < 0.01))
    throw bad_input(place + " has a quaternion of length " + std::to_string(q.norm()), "length 1, qw first");
  Pose T_camera_world = Pose::Identity();
  T_camera_world.linear() = q.normalized().toRotationMatrix();
  T_camera_world.translation() = Eigen::Vector3d(v[4], v[5], v[6]);
  return T_camera_world.inverse();
}

std::vector<ColmapImage> images_of_text(Bytes file) {
  constexpr const char* needed = "IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, and a line of points";
  std::vector<ColmapImage> images;
  bool points_follow = false;
  for_each_line(
      file,
      [&](const std::vector<std::string_view>& words, const std::string& place) {
        if (points_follow) {
          images.back().observations = words.size() / 3;
          points_follow = false;
          return;
        }
        if (words.empty()) return;
        if (words.size() < 10) throw bad_input(place + " has " + std::to_string(words.size()) + " words", needed);
        std::array<double, 7> pose{};
        for (std::size_t i = 0; i < pose.size(); ++i) pose[i] = number_of<double>(words[i + 1], place);
        // A name may have blanks: it is the rest of the line.
        const auto* begin = words[9].data();
        const auto* end = words.back().data() + words.back().size();
        images.push_back(
            {std::string(begin, end), number_of<std::uint32_t>(words[8], place), pose_of_image(pose, place), 0});
        points_follow = true;
      },
      true);
  return images;
}

std::vector<ColmapImage> images_of_bytes(Bytes file) {
  ByteReader reader(file);
  std::vector<ColmapImage> images;
  const auto count = reader.next_count(4 + 56 + 4 + 1 + 8);
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = "image " + std::to_string(i);
    ColmapImage image;
    reader.next<std::uint32_t>();  // its number
    std::array<double, 7> pose{};
    for (double& v : pose) v = reader.next<double>();
    image.T_world_camera = pose_of_image(pose, place);
    image.camera = reader.next<std::uint32_t>();
    image.name = reader.next_name();
    image.observations = reader.next_count(24);
    reader.skip(image.observations * 24);
    images.push_back(std::move(image));
  }
  return images;
}

struct PointSums {
  ColmapPoints points;
  double errors = 0, tracks = 0;

  void add(double error, std::size_t track) {
    ++points.count;
    errors += error;
    tracks += static_cast<double>(track);
  }
  ColmapPoints result() {
    if (points.count == 0) return points;
    points.mean_error_px = errors / static_cast<double>(points.count);
    points.mean_track = tracks / static_cast<double>(points.count);
    return points;
  }
};

}  // namespace

ColmapCameras parse_colmap_cameras(Bytes file, bool binary) {
  if (file.empty()) throw bad_input("the file is empty", "cameras of COLMAP");
  auto cameras = binary ? cameras_of_bytes(file) : cameras_of_text(file);
  if (cameras.empty()) throw bad_input("the file holds no cameras", known_models);
  return cameras;
}

std::vector<ColmapImage> parse_colmap_images(Bytes file, bool binary) {
  if (file.empty()) throw bad_input("the file is empty", "images of COLMAP");
  auto images = binary ? images_of_bytes(file) : images_of_text(file);
  if (images.empty()) throw bad_input("the file holds no images", "images that COLMAP registered");
  std::ranges::stable_sort(images, {}, &ColmapImage::name);
  return images;
}

ColmapPoints parse_colmap_points(Bytes file, bool binary) {
  PointSums sums;
  if (file.empty()) return {};
  if (!binary) {
    for_each_line(file, [&](const std::vector<std::string_view>& words, const std::string& place) {
      if (words.size() < 8) throw bad_input(place + " has " + std::to_string(words.size()) + " words", "a point");
      sums.add(finite(number_of<double>(words[7], place), place), (words.size() - 8) / 2);
    });
    return sums.result();
  }
  ByteReader reader(file);
  const auto count = reader.next_count(8 + 24 + 3 + 8 + 8);
  for (std::size_t i = 0; i < count; ++i) {
    reader.skip(8 + 24 + 3);  // number, place, colour
    const double error = finite(reader.next<double>(), "point " + std::to_string(i));
    const auto track = reader.next_count(8);
    reader.skip(track * 8);
    sums.add(error, track);
  }
  return sums.result();
}

}  // namespace bole::io
