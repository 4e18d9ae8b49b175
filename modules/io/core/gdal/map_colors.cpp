#include "io/core/gdal/map_colors.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "io/core/gdal/gdal_support.h"

namespace bole::io {
namespace {

constexpr int channels = 4, alpha_channel = 3;
constexpr int sample_side_px = 512;  // of what the range of numbers is taken from
constexpr double darkest_share = 0.01, opaque = 255;

struct Bands {
  std::vector<GDALRasterBand*> colors;  // 1 or 3
  GDALRasterBand* alpha = nullptr;
  const GDALColorTable* palette = nullptr;  // of the one band
};

Bands bands_of(GDALDataset& set, const std::string& name) {
  Bands bands;
  GDALRasterBand* named[3] = {};
  for (int i = 1; i <= set.GetRasterCount(); ++i) {
    auto* band = set.GetRasterBand(i);
    if (GDALDataTypeIsComplex(band->GetRasterDataType()) != FALSE)
      throw bad_input(fmt::format("band {} of '{}' holds complex numbers", i, name), "a picture");
    const auto means = band->GetColorInterpretation();
    if (means == GCI_AlphaBand && bands.alpha == nullptr) bands.alpha = band;
    if (means >= GCI_RedBand && means <= GCI_BlueBand && named[means - GCI_RedBand] == nullptr)
      named[means - GCI_RedBand] = band;
  }
  if (std::ranges::all_of(named, [](const auto* band) { return band != nullptr; })) {
    bands.colors.assign(std::begin(named), std::end(named));
    return bands;
  }
  for (int i = 1; i <= set.GetRasterCount() && bands.colors.size() < 3; ++i)
    if (auto* band = set.GetRasterBand(i); band != bands.alpha) bands.colors.push_back(band);
  if (bands.colors.empty()) throw bad_input(fmt::format("'{}' has no band with colours", name), "a picture");
  if (bands.colors.size() < 3) bands.colors.resize(1);
  if (bands.colors.size() == 1) bands.palette = bands.colors[0]->GetColorTable();
  return bands;
}

class Reading {
 public:
  Reading(const MapPart& part, const std::string& name, const Run& run) : part_(part), name_(name), run_(run) {}

  // Into every `spacing` bytes of `out`. `mean` of the pixels that one stands for, else one of them.
  void read(GDALRasterBand& band, void* out, GDALDataType type, int width, int height, int spacing, bool mean,
            double begin, double end) {
    begin_ = begin;
    end_ = end;
    GDALRasterIOExtraArg how;
    INIT_RASTERIO_EXTRA_ARG(how);
    const bool thinned = width < part_.columns || height < part_.rows;
    if (mean && thinned) how.eResampleAlg = GRIORA_Average;
    how.pfnProgress = &Reading::told;
    how.pProgressData = this;
    const gdal::Errors errors;
    const auto done = band.RasterIO(GF_Read, part_.column, part_.row, part_.columns, part_.rows, out, width, height,
                                    type, spacing, static_cast<GSpacing>(spacing) * width, &how);
    run_.check_cancel();
    if (done != CE_None) throw bad_input(fmt::format("'{}' cannot be read: {}", name_, errors.last()), "a whole file");
  }
  const MapPart& part() const { return part_; }

 private:
  static int told(double fraction, const char* /*message*/, void* self) {
    const auto& reading = *static_cast<Reading*>(self);
    reading.run_.report(reading.begin_ + fraction * (reading.end_ - reading.begin_), "map");
    return reading.run_.cancelled() ? FALSE : TRUE;
  }

  const MapPart& part_;
  const std::string& name_;
  const Run& run_;
  double begin_ = 0, end_ = 1;
};

struct Range {
  double lo = 0, hi = 255;
};

// One for all bands, so that colours keep their hue.
Range range_of(const Bands& bands, Reading& reading) {
  const int width = std::min(sample_side_px, reading.part().width),
            height = std::min(sample_side_px, reading.part().height);
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<float> values(count), all;
  std::vector<std::uint8_t> mask(count);
  for (auto* band : bands.colors) {
    reading.read(*band, values.data(), GDT_Float32, width, height, sizeof(float), false, 0, 0);
    reading.read(bands.alpha != nullptr ? *bands.alpha : *band->GetMaskBand(), mask.data(), GDT_Byte, width, height, 1,
                 false, 0, 0);
    for (std::size_t i = 0; i < count; ++i)
      if (mask[i] != 0 && std::isfinite(values[i])) all.push_back(values[i]);
  }
  if (all.empty()) return {};
  std::ranges::sort(all);
  const auto cut = static_cast<std::size_t>(darkest_share * static_cast<double>(all.size()));
  const auto lo = static_cast<double>(all[cut]), hi = static_cast<double>(all[all.size() - 1 - cut]);
  return {lo, hi > lo ? hi : lo + 1};
}

void take_numbers(GDALRasterBand& band, const Range& range, std::size_t channel, Reading& reading,
                  std::vector<std::uint8_t>& rgba, double begin, double end) {
  const int width = reading.part().width, height = reading.part().height;
  std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  reading.read(band, values.data(), GDT_Float32, width, height, sizeof(float), true, begin, end);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double share = (static_cast<double>(values[i]) - range.lo) / (range.hi - range.lo);
    auto& alpha = rgba[channels * i + alpha_channel];
    if (!std::isfinite(share)) alpha = 0;
    rgba[channels * i + channel] =
        std::isfinite(share) ? static_cast<std::uint8_t>(std::lround(opaque * std::clamp(share, 0.0, 1.0))) : 0;
  }
}

void take_palette(const GDALColorTable& palette, std::vector<std::uint8_t>& rgba) {
  for (std::size_t i = 0; i < rgba.size(); i += channels) {
    GDALColorEntry color{0, 0, 0, 0};
    if (rgba[i] < palette.GetColorEntryCount()) palette.GetColorEntryAsRGB(rgba[i], &color);
    rgba[i] = static_cast<std::uint8_t>(color.c1);
    rgba[i + 1] = static_cast<std::uint8_t>(color.c2);
    rgba[i + 2] = static_cast<std::uint8_t>(color.c3);
    if (color.c4 < rgba[i + alpha_channel]) rgba[i + alpha_channel] = static_cast<std::uint8_t>(color.c4);
  }
}

// A pixel is there where any of its bands is: dark blue has two bands that are 0, which may be "no data".
void take_alpha(const Bands& bands, Reading& reading, std::vector<std::uint8_t>& rgba) {
  const int width = reading.part().width, height = reading.part().height;
  std::vector<std::uint8_t> mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  if (bands.alpha != nullptr) {
    if (bands.alpha->GetRasterDataType() == GDT_Byte) {
      reading.read(*bands.alpha, rgba.data() + alpha_channel, GDT_Byte, width, height, channels, true, 0, 0.1);
      return;
    }
    std::vector<float> values(mask.size());
    reading.read(*bands.alpha, values.data(), GDT_Float32, width, height, sizeof(float), false, 0, 0.1);
    for (std::size_t i = 0; i < values.size(); ++i) rgba[channels * i + alpha_channel] = values[i] > 0 ? 255 : 0;
    return;
  }
  for (auto* band : bands.colors) {
    reading.read(*band->GetMaskBand(), mask.data(), GDT_Byte, width, height, 1, false, 0, 0.1);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      auto& alpha = rgba[channels * i + alpha_channel];
      alpha = std::max(alpha, mask[i]);
    }
  }
}

}  // namespace

std::vector<std::uint8_t> map_colors(GDALDataset& set, const MapPart& part, const std::string& name, const Run& run) {
  const auto bands = bands_of(set, name);
  Reading reading(part, name, run);
  std::vector<std::uint8_t> rgba(channels * static_cast<std::size_t>(part.width) *
                                 static_cast<std::size_t>(part.height));
  const bool bytes =
      std::ranges::all_of(bands.colors, [](auto* band) { return band->GetRasterDataType() == GDT_Byte; });
  const auto range = bytes || bands.palette != nullptr ? Range{} : range_of(bands, reading);
  take_alpha(bands, reading, rgba);
  const auto count = bands.colors.size();
  for (std::size_t c = 0; c < count; ++c) {
    const double begin = 0.1 + 0.9 * static_cast<double>(c) / static_cast<double>(count),
                 end = 0.1 + 0.9 * static_cast<double>(c + 1) / static_cast<double>(count);
    if (bytes || bands.palette != nullptr)
      reading.read(*bands.colors[c], rgba.data() + c, GDT_Byte, part.width, part.height, channels,
                   bands.palette == nullptr, begin, end);
    else
      take_numbers(*bands.colors[c], range, c, reading, rgba, begin, end);
  }
  if (bands.palette != nullptr)
    take_palette(*bands.palette, rgba);
  else if (count == 1)
    for (std::size_t i = 0; i < rgba.size(); i += channels) rgba[i + 1] = rgba[i + 2] = rgba[i];
  return rgba;
}

}  // namespace bole::io
