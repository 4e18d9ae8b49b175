#include "rgbd/core/matching/descriptor_match.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <tuple>

#include "base/error.h"

namespace bole::rgbd {
namespace {

using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
constexpr std::size_t block_rows = 256;
constexpr double usual_ratio = 0.8;

Matrix unit_rows(const Features& f, std::size_t first, std::size_t count) {
  Matrix out(static_cast<Eigen::Index>(count), f.descriptor_bytes);
  for (std::size_t i = 0; i < count; ++i) {
    const auto* row = f.descriptor(first + i);
    for (int k = 0; k < f.descriptor_bytes; ++k) out(static_cast<Eigen::Index>(i), k) = static_cast<float>(row[k]);
  }
  out.rowwise().normalize();
  return out;
}

int hamming(const std::uint8_t* a, const std::uint8_t* b, int bytes) {
  int sum = 0, k = 0;
  for (; k + 8 <= bytes; k += 8) {
    std::uint64_t x = 0, y = 0;
    std::memcpy(&x, a + k, 8);
    std::memcpy(&y, b + k, 8);
    sum += std::popcount(x ^ y);
  }
  for (; k < bytes; ++k) sum += std::popcount(static_cast<unsigned>(a[k] ^ b[k]));
  return sum;
}

// Distances of some features of `a` (rows) to all of `b`: 2 - 2 cos of root-SIFT, bits of ORB.
Matrix distances(const Features& a, std::size_t first, std::size_t count, const Features& b, const Matrix& unit_b) {
  if (a.kind == FeatureKind::sift) {
    Matrix out = unit_rows(a, first, count) * unit_b.transpose();
    out.array() = 2 - 2 * out.array();
    return out;
  }
  Matrix out(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(b.size()));
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      out(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          static_cast<float>(hamming(a.descriptor(first + i), b.descriptor(j), a.descriptor_bytes));
  return out;
}

struct Nearest {
  float best = std::numeric_limits<float>::infinity(), next = std::numeric_limits<float>::infinity();
  std::uint32_t index = 0;
};

// A feature with two directions must not compete with itself.
Nearest nearest_of(const float* row, const Features& b) {
  Nearest n;
  for (std::uint32_t j = 0; j < b.size(); ++j) {
    if (!(row[j] < n.next)) continue;
    if (row[j] < n.best) {
      if (b.features[j].place != b.features[n.index].place) n.next = n.best;
      n.best = row[j];
      n.index = j;
    } else if (b.features[j].place != b.features[n.index].place) {
      n.next = row[j];
    }
  }
  return n;
}

}  // namespace

std::vector<Candidate> best_candidates(const Features& a, const Features& b) {
  if (a.size() == 0 || b.size() == 0) return {};
  if (a.kind != b.kind || a.descriptor_bytes != b.descriptor_bytes)
    throw failure("features of two kinds are compared", "one kind");
  const bool squared = a.kind == FeatureKind::sift;
  const Matrix unit_b = squared ? unit_rows(b, 0, b.size()) : Matrix();
  std::vector<Nearest> of_a(a.size());
  std::vector<Nearest> of_b(b.size());
  for (std::size_t first = 0; first < a.size(); first += block_rows) {
    const std::size_t count = std::min(block_rows, a.size() - first);
    const Matrix d = distances(a, first, count, b, unit_b);
    for (std::size_t i = 0; i < count; ++i) {
      const float* row = d.data() + i * b.size();
      of_a[first + i] = nearest_of(row, b);
      for (std::size_t j = 0; j < b.size(); ++j)
        if (row[j] < of_b[j].best) {
          of_b[j].best = row[j];
          of_b[j].index = static_cast<std::uint32_t>(first + i);
        }
    }
  }
  std::vector<Candidate> out(a.size());
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    const auto& n = of_a[i];
    out[i].match = {i, n.index};
    const double share = n.next > 0 ? static_cast<double>(std::max(n.best, 0.0F) / n.next) : 1;
    out[i].ratio = squared ? std::sqrt(share) : share;
    out[i].mutual = a.features[of_b[n.index].index].place == a.features[i].place;
  }
  return out;
}

Likeness::Likeness(const Features& features, int count) {
  strongest_.kind = features.kind;
  strongest_.descriptor_bytes = features.descriptor_bytes;
  std::vector<std::uint32_t> order(features.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::tuple(-features.features[i].size, i); });
  for (const auto i : order) {
    if (static_cast<int>(strongest_.size()) >= count) break;
    if (features.features[i].place != i) continue;
    auto f = features.features[i];
    f.place = static_cast<std::uint32_t>(strongest_.size());
    strongest_.features.push_back(f);
    strongest_.descriptors.insert(strongest_.descriptors.end(), features.descriptor(i),
                                  features.descriptor(i) + features.descriptor_bytes);
  }
}

int Likeness::with(const Likeness& other) const {
  int found = 0;
  for (const auto& c : best_candidates(strongest_, other.strongest_)) found += c.mutual && c.ratio < usual_ratio;
  return found;
}

}  // namespace bole::rgbd
