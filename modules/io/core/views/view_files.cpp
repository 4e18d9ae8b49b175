#include "io/core/views/view_files.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "base/atomic_file.h"
#include "base/error.h"

namespace bole::io {
namespace {

constexpr std::uint16_t no_depth_too = 65535;  // Kinect recordings of 7-Scenes
constexpr const char* whole_image = "a whole PNG, JPEG or PGM image";

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

cv::Mat decoded(const std::filesystem::path& path, Bytes file, int flags) {
  const auto header = image_header(file);
  if (!header) throw bad_input(quoted(path) + " is no whole image", whole_image);
  if (header->kind == ImageKind::jpeg && !is_whole_jpeg(file))
    throw bad_input(quoted(path) + " is cut off", whole_image);
  cv::Mat image;
  try {
    const cv::Mat bytes(1, static_cast<int>(file.size()), CV_8UC1, const_cast<std::uint8_t*>(file.data()));
    image = cv::imdecode(bytes, flags);
  } catch (const cv::Exception& e) {
    throw bad_input(quoted(path) + " cannot be decoded: " + e.err, whole_image);
  }
  if (image.cols != header->width || image.rows != header->height)
    throw bad_input(quoted(path) + " is damaged or cut off", whole_image);
  return image;
}

template <class T>
void resize(Image<T>& image, int width, int height, int channels) {
  image.width = width;
  image.height = height;
  image.channels = channels;
  image.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                      static_cast<std::size_t>(channels));
}

std::uint8_t over_white(std::uint8_t value, std::uint8_t alpha) {
  return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha) + 127) / 255);
}

void take_alpha(const cv::Mat& image, ColorImage& color, MaskImage& mask) {
  resize(mask, image.cols, image.rows, 1);
  for (int y = 0; y < image.rows; ++y) {
    const auto* row = image.ptr<std::uint8_t>(y);
    auto* out = &color.at(0, y);
    for (int x = 0; x < image.cols; ++x, row += 4, out += 3) {
      for (int c = 0; c < 3; ++c) out[c] = over_white(row[2 - c], row[3]);
      mask.at(x, y) = row[3] >= 128 ? 255 : 0;
    }
  }
}

void take_pgm(Bytes file, const ImageHeader& header, bool little_endian, std::vector<std::uint16_t>& values) {
  const auto* at = file.data() + header.data;
  const std::size_t low = little_endian ? 0 : 1;
  for (auto& value : values) {
    value = static_cast<std::uint16_t>(at[1 - low] << 8 | at[low]);
    at += 2;
  }
}

std::size_t pixels_of(const ImageHeader& header) {
  return static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
}

float metres_of(std::uint16_t value, const DepthCoding& coding) {
  if (value == 0 || value == no_depth_too) return 0;
  const double z = value / coding.units_per_metre;
  const double metres = z + coding.bias[0] + z * (coding.bias[1] + z * coding.bias[2]);
  return metres > coding.max_depth || metres <= 0 ? 0 : static_cast<float>(metres);
}

void write_image(const std::filesystem::path& path, const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  try {
    if (!cv::imencode(path.extension().string(), image, bytes)) bytes.clear();
  } catch (const cv::Exception&) {
    bytes.clear();
  }
  if (bytes.empty()) throw failure(quoted(path) + " cannot be encoded", "an image that is not empty, .png or .jpg");
  AtomicFile file(path);
  file.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.commit();
}

template <class T>
cv::Mat wrapped(const Image<T>& image, int type) {
  return {image.height, image.width, type, const_cast<T*>(image.values.data())};
}

}  // namespace

void read_color(const std::filesystem::path& path, ColorImage& color, MaskImage& mask) {
  const MappedFile file(path);
  const auto header = image_header(file.bytes());
  const bool alpha = header && header->kind == ImageKind::png && header->channels == 4 && header->bits == 8;
  const auto image =
      decoded(path, file.bytes(), alpha ? cv::IMREAD_UNCHANGED : cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  resize(color, image.cols, image.rows, 3);
  mask = {};
  if (image.type() == CV_8UC4) {
    take_alpha(image, color, mask);
    return;
  }
  if (image.type() != CV_8UC3) throw bad_input(quoted(path) + " is no colour image", whole_image);
  cv::Mat target = wrapped(color, CV_8UC3);
  cv::cvtColor(image, target, cv::COLOR_BGR2RGB);
}

void read_depth(const std::filesystem::path& path, const DepthCoding& coding, DepthImage& depth) {
  const MappedFile file(path);
  const auto header = image_header(file.bytes());
  if (!header) throw bad_input(quoted(path) + " is no whole image", whole_image);
  if (header->channels != 1 || header->bits != 16)
    throw bad_input(quoted(path) + " has " + std::to_string(header->channels) + " channels of " +
                        std::to_string(header->bits) + " bits",
                    "depth images of one channel and 16 bits");
  resize(depth, header->width, header->height, 1);
  if (header->kind == ImageKind::pgm) {
    std::vector<std::uint16_t> values(pixels_of(*header));
    take_pgm(file.bytes(), *header, coding.little_endian_pgm, values);
    std::ranges::transform(values, depth.values.begin(), [&](std::uint16_t v) { return metres_of(v, coding); });
    return;
  }
  const auto image = decoded(path, file.bytes(), cv::IMREAD_UNCHANGED);
  if (image.type() != CV_16UC1)
    throw bad_input(quoted(path) + " is no depth image", "depth images of one channel and 16 bits");
  for (int y = 0; y < image.rows; ++y)
    std::transform(image.ptr<std::uint16_t>(y), image.ptr<std::uint16_t>(y) + image.cols, &depth.at(0, y),
                   [&](std::uint16_t v) { return metres_of(v, coding); });
}

void read_mask(const std::filesystem::path& path, MaskImage& mask) {
  const MappedFile file(path);
  const auto image = decoded(path, file.bytes(), cv::IMREAD_GRAYSCALE);
  resize(mask, image.cols, image.rows, 1);
  for (int y = 0; y < image.rows; ++y)
    std::transform(image.ptr<std::uint8_t>(y), image.ptr<std::uint8_t>(y) + image.cols, &mask.at(0, y),
                   [](std::uint8_t v) { return static_cast<std::uint8_t>(v != 0 ? 255 : 0); });
}

bool seems_little_endian_pgm(Bytes file) {
  const auto header = image_header(file);
  if (!header || header->kind != ImageKind::pgm || header->bits != 16) return false;
  const auto steps = [&](bool little_endian) {
    std::vector<std::uint16_t> values(pixels_of(*header));
    take_pgm(file, *header, little_endian, values);
    std::uint64_t sum = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
      if (values[i] != 0 && values[i - 1] != 0)
        sum += static_cast<std::uint64_t>(std::abs(static_cast<int>(values[i]) - static_cast<int>(values[i - 1])));
    return sum;
  };
  return steps(true) < steps(false);
}

void write_color(const std::filesystem::path& path, const ColorImage& color) {
  cv::Mat image;
  if (!color.empty()) cv::cvtColor(wrapped(color, CV_8UC3), image, cv::COLOR_RGB2BGR);
  write_image(path, image);
}

void write_depth(const std::filesystem::path& path, const DepthImage& depth, double units_per_metre) {
  cv::Mat image(depth.height, depth.width, CV_16UC1);
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      const double value = std::round(depth.at(x, y) * units_per_metre);
      image.at<std::uint16_t>(y, x) = value > 0 && value < no_depth_too ? static_cast<std::uint16_t>(value) : 0;
    }
  write_image(path, image);
}

void write_mask(const std::filesystem::path& path, const MaskImage& mask) { write_image(path, wrapped(mask, CV_8UC1)); }

}  // namespace bole::io
