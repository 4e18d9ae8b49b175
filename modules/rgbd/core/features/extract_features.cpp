#include "rgbd/core/features/extract_features.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "rgbd/core/features/depth_lookup.h"
#include "rgbd/core/features/gray_image.h"

namespace bole::rgbd {
namespace {

constexpr double sift_contrast = 0.02;  // half of Lowe's: leaves and mats have little contrast, and the best are chosen
constexpr double faint_sift_contrast = 0.006;  // where an image has too few otherwise: bare walls, dark images
constexpr int orb_candidates = 4;              // times max_features, to choose from
constexpr int cells_across = 16;

cv::Ptr<cv::Feature2D> make_sift(double contrast = sift_contrast) { return cv::SIFT::create(0, 3, contrast); }

// OpenCV doubles the image before it searches and, up to 4.7, forgets that this moves the centres of the pixels by a
// quarter of a pixel. Measured on a blob, so that every version is right.
cv::Point2f sift_shift() {
  static const cv::Point2f shift = [] {
    constexpr int size = 96;
    constexpr double centre = 48, sigma = 3;
    cv::Mat blob(size, size, CV_8U);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const double r2 = (x - centre) * (x - centre) + (y - centre) * (y - centre);
        blob.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(60 + 150 * std::exp(-r2 / (2 * sigma * sigma)));
      }
    std::vector<cv::KeyPoint> found;
    make_sift()->detect(blob, found);
    if (found.empty()) return cv::Point2f(0, 0);
    const auto best = std::ranges::max_element(found, {}, [](const auto& k) { return k.response; });
    const cv::Point2f by(best->pt.x - static_cast<float>(centre), best->pt.y - static_cast<float>(centre));
    constexpr float quarter = 0.25F, tolerance = 0.1F;
    const bool moved = std::abs(by.x - quarter) < tolerance && std::abs(by.y - quarter) < tolerance;
    return moved ? cv::Point2f(quarter, quarter) : cv::Point2f(0, 0);
  }();
  return shift;
}

auto order_of(const cv::KeyPoint& k) { return std::tuple(-k.response, k.pt.y, k.pt.x, k.size, k.angle); }

// The best of every cell in turn, so that a rich texture does not use up the features of the whole image.
std::vector<std::size_t> spread(const std::vector<cv::KeyPoint>& found, const cv::Size& size, int max_features) {
  const double cell = static_cast<double>(size.width) / cells_across;
  std::map<std::pair<int, int>, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < found.size(); ++i)
    cells[{static_cast<int>(found[i].pt.y / cell), static_cast<int>(found[i].pt.x / cell)}].push_back(i);
  for (auto& [place, members] : cells)
    std::ranges::sort(members, {}, [&](std::size_t i) { return order_of(found[i]); });
  std::vector<std::size_t> out;
  for (std::size_t turn = 0; static_cast<int>(out.size()) < max_features; ++turn) {
    std::vector<std::size_t> taken;
    for (const auto& [place, members] : cells)
      if (turn < members.size()) taken.push_back(members[turn]);
    if (taken.empty()) break;
    std::ranges::sort(taken, {}, [&](std::size_t i) { return order_of(found[i]); });
    taken.resize(std::min(taken.size(), static_cast<std::size_t>(max_features) - out.size()));
    out.insert(out.end(), taken.begin(), taken.end());
  }
  return out;
}

void append_root_sift(const cv::Mat& row, std::vector<std::uint8_t>& out) {
  const auto* values = row.ptr<float>();
  double sum = 0;
  for (int i = 0; i < row.cols; ++i) sum += static_cast<double>(values[i]);
  for (int i = 0; i < row.cols; ++i)
    out.push_back(
        cv::saturate_cast<std::uint8_t>(512 * std::sqrt(static_cast<double>(values[i]) / std::max(sum, 1.0))));
}

void append_bits(const cv::Mat& row, std::vector<std::uint8_t>& out) {
  out.insert(out.end(), row.ptr<std::uint8_t>(), row.ptr<std::uint8_t>() + row.cols);
}

cv::Mat mask_of(const View& view, const cv::Size& size) {
  if (view.mask.empty()) return {};
  const cv::Mat mask(view.mask.height, view.mask.width, CV_8U,
                     const_cast<std::uint8_t*>(view.mask.values.data()));  // NOLINT: read only
  cv::Mat out;
  cv::resize(mask, out, size, 0, 0, cv::INTER_NEAREST);
  return out;
}

}  // namespace

Features extract_features(const View& view, const RgbdCamera& camera, const FeatureOptions& options, bool use_mask) {
  // OpenCV's threads give the features in an order that changes from run to run, and sums follow it. Views are worked
  // on side by side already.
  static const bool one_thread_each = (cv::setNumThreads(1), true);
  (void)one_thread_each;
  Features out;
  out.kind = options.kind;
  if (view.color.empty()) return out;
  cv::Mat gray = gray_image(view.color);
  const double factor = std::min(1.0, static_cast<double>(options.max_width) / gray.cols);
  if (factor < 1) cv::resize(gray, gray, {}, factor, factor, cv::INTER_AREA);
  const double to_full_x = static_cast<double>(view.color.width) / gray.cols;
  const double to_full_y = static_cast<double>(view.color.height) / gray.rows;

  const bool sift = options.kind == FeatureKind::sift;
  const auto finder =
      sift ? make_sift() : cv::Ptr<cv::Feature2D>(cv::ORB::create(orb_candidates * options.max_features));
  std::vector<cv::KeyPoint> found;
  cv::Mat descriptors;
  const cv::Mat mask = use_mask ? mask_of(view, gray.size()) : cv::Mat();
  finder->detectAndCompute(gray, mask, found, descriptors);
  if (sift && static_cast<int>(found.size()) < options.max_features)
    make_sift(faint_sift_contrast)->detectAndCompute(gray, mask, found, descriptors);

  const cv::Point2f shift = sift ? sift_shift() : cv::Point2f(0, 0);
  const DepthLookup depth(view.depth, camera);
  std::map<std::pair<float, float>, std::uint32_t> places;
  out.descriptor_bytes = descriptors.cols;
  for (const std::size_t i : spread(found, gray.size(), options.max_features)) {
    const auto& key = found[i];
    Feature f;
    f.pixel = {(static_cast<double>(key.pt.x - shift.x) + 0.5) * to_full_x - 0.5,
               (static_cast<double>(key.pt.y - shift.y) + 0.5) * to_full_y - 0.5};
    f.direction = camera.color.direction(f.pixel);
    f.size = static_cast<double>(key.size) * to_full_x;
    if (const auto w = depth.inverse_depth(f.pixel, f.direction)) f.inverse_depth = *w;
    const int x = std::clamp(static_cast<int>(std::lround(f.pixel.x())), 0, view.color.width - 1);
    const int y = std::clamp(static_cast<int>(std::lround(f.pixel.y())), 0, view.color.height - 1);
    for (int c = 0; c < 3; ++c) f.color[static_cast<std::size_t>(c)] = view.color.at(x, y, c);
    const auto index = static_cast<std::uint32_t>(out.features.size());
    f.place = places.try_emplace({key.pt.x, key.pt.y}, index).first->second;
    out.features.push_back(f);
    (sift ? append_root_sift : append_bits)(descriptors.row(static_cast<int>(i)), out.descriptors);
  }
  return out;
}

}  // namespace bole::rgbd
