#include "sim/core/seedling/charuco_mat.h"

#include <algorithm>
#include <cmath>
#include <opencv2/aruco.hpp>

namespace bole::sim {
namespace {

constexpr int modules = 6;  // of a marker of 4 x 4 bits and its border

}  // namespace

CharucoMat::CharucoMat() {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  const int markers = columns * rows / 2;
  bits_.resize(static_cast<std::size_t>(markers));
  for (int id = 0; id < markers; ++id) {
    cv::Mat image;
    dictionary->drawMarker(id, modules, image, 1);
    for (int r = 0; r < modules; ++r)
      for (int c = 0; c < modules; ++c)
        bits_[static_cast<std::size_t>(id)][static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] =
            image.at<unsigned char>(r, c) < 128;
  }
}

bool CharucoMat::black_at(double x, double y) const {
  if (x < 0 || y < 0 || x >= width() || y >= height()) return false;
  const int column = static_cast<int>(x / square), row = static_cast<int>(y / square);
  if ((column + row) % 2 == 0) return true;
  const double gap = 0.5 * (square - marker);
  const double u = (x - column * square - gap) / marker * modules, v = (y - row * square - gap) / marker * modules;
  if (u < 0 || v < 0 || u >= modules || v >= modules) return false;
  const int id = (row * columns + column) / 2;  // white squares before it, by rows
  return bits_[static_cast<std::size_t>(id)][static_cast<std::size_t>(v)][static_cast<std::size_t>(u)];
}

double CharucoMat::black(const Eigen::Vector2d& at, double footprint) const {
  const double y = height() - at.y();
  // Modules and squares are wider than 3 mm: where the corners of the footprint agree, all of it does.
  constexpr double narrowest = 0.003;
  const double half = 0.5 * footprint;
  if (footprint < narrowest) {
    const bool first = black_at(at.x() - half, y - half);
    if (black_at(at.x() + half, y - half) == first && black_at(at.x() - half, y + half) == first &&
        black_at(at.x() + half, y + half) == first && black_at(at.x(), y) == first)
      return first ? 1 : 0;
  }
  constexpr int n = 4;
  int count = 0;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      count += black_at(at.x() + footprint * ((i + 0.5) / n - 0.5), y + footprint * ((k + 0.5) / n - 0.5)) ? 1 : 0;
  return static_cast<double>(count) / (n * n);
}

std::vector<Eigen::Vector3d> CharucoMat::corners() const {
  std::vector<Eigen::Vector3d> list;
  for (int r = 1; r < rows; ++r)
    for (int c = 1; c < columns; ++c) list.emplace_back(c * square, height() - r * square, 0);
  return list;
}

}  // namespace bole::sim
