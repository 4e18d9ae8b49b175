#include "render/draw/figure.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>

#include "base/error.h"
#include "render/draw/screen_look.h"

namespace bole::render {
namespace {

constexpr double pt_per_mm = 72 / 25.4;
constexpr int max_pixels = 30000;  // a side; Cairo itself stops at 32767

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status, const Figure& figure) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw failure("figure '" + figure.name + "' could not be drawn: " + cairo_status_to_string(status));
}

void draw_on(cairo_surface_t* surface, const Figure& figure, double scale, bool paper = true,
             const ScreenLook* look = nullptr) {
  Context cairo(cairo_create(surface), cairo_destroy);
  if (look != nullptr) set_look(cairo.get(), *look);
  cairo_scale(cairo.get(), scale, scale);
  if (paper) {
    // The whole surface, also the part of a pixel beyond the sheet's edge.
    const Color sheet = look != nullptr && look->dark ? on_dark(ink::paper) : ink::paper;
    cairo_set_source_rgb(cairo.get(), sheet.r, sheet.g, sheet.b);
    cairo_paint(cairo.get());
  }
  Canvas canvas(cairo.get(), figure.width_mm, figure.height_mm);
  figure.draw(canvas);
  check(cairo_status(cairo.get()), figure);
}

Surface raster(const Figure& figure, double dpi, bool paper = true, const ScreenLook* look = nullptr) {
  const double w = std::round(figure.width_mm / mm_per_inch * dpi),
               h = std::round(figure.height_mm / mm_per_inch * dpi);
  if (!(w >= 1 && h >= 1 && w <= max_pixels && h <= max_pixels))
    throw bad_input("figure '" + figure.name + "' would have " + std::to_string(static_cast<long>(w)) + " x " +
                        std::to_string(static_cast<long>(h)) + " pixels",
                    "at most " + std::to_string(max_pixels) + " a side", "Lower its resolution or width");
  const auto format = paper ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32;
  Surface surface(cairo_image_surface_create(format, static_cast<int>(w), static_cast<int>(h)), cairo_surface_destroy);
  check(cairo_surface_status(surface.get()), figure);
  draw_on(surface.get(), figure, dpi / mm_per_inch, paper, look);
  cairo_surface_flush(surface.get());
  return surface;
}

std::string big_endian(std::uint32_t v) {
  return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8), static_cast<char>(v)};
}

// Cairo writes no resolution into a PNG: put a pHYs chunk (pixels per metre) behind the header.
std::string with_resolution(std::string png, double dpi) {
  constexpr std::size_t after_header = 8 + 25;
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi / mm_per_inch * 1000));
  const std::string body = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\1';
  const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  png.insert(after_header, big_endian(9) + body + big_endian(static_cast<std::uint32_t>(crc)));
  return png;
}

// Cairo numbers the elements of an SVG through the life of the process; numbers in the order of appearance make equal
// figures equal files. Text is glyph outlines, so that these words occur in names alone.
std::string with_own_numbers(const std::string& svg) {
  constexpr std::string_view digits = "0123456789";
  std::map<std::string, std::string> numbers;
  std::string out;
  out.reserve(svg.size());
  std::size_t from = 0;
  while (from < svg.size()) {
    std::size_t at = std::string::npos, begin = at;
    for (const std::string_view word : {"surface", "image", "source-"})
      if (const auto found = svg.find(word, from); found < at) at = found, begin = found + word.size();
    if (at == std::string::npos) break;
    const auto end = std::min(svg.find_first_not_of(digits, begin), svg.size());
    out.append(svg, from, begin - from);
    if (end > begin)
      out += numbers.try_emplace(svg.substr(begin, end - begin), std::to_string(numbers.size())).first->second;
    from = end;
  }
  return out.append(svg, from);
}

std::string surface_png(cairo_surface_t* surface, double dpi) {
  std::string bytes;
  if (const auto status = cairo_surface_write_to_png_stream(surface, append, &bytes); status != CAIRO_STATUS_SUCCESS)
    throw failure(std::string("a PNG could not be written: ") + cairo_status_to_string(status));
  return with_resolution(std::move(bytes), dpi);
}

// `opaque`: without looking at the surface's opacity, by which Cairo multiplies its colours.
Image image_of(const Surface& surface, bool opaque) {
  Image image{cairo_image_surface_get_width(surface.get()), cairo_image_surface_get_height(surface.get()), {}};
  const auto* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  image.rgba.reserve(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < image.width; ++x) {
      const unsigned opacity = opaque ? 255 : row[x] >> 24;
      for (const int shift : {16, 8, 0}) {
        const unsigned value = row[x] >> shift & 255;
        image.rgba.push_back(static_cast<std::uint8_t>(opacity == 0 ? 0 : std::min(255u, value * 255 / opacity)));
      }
      image.rgba.push_back(static_cast<std::uint8_t>(opacity));
    }
  }
  return image;
}

}  // namespace

Image figure_image(const Figure& figure, double dpi) { return image_of(raster(figure, dpi), true); }

Image figure_overlay(const Figure& figure, double dpi) { return image_of(raster(figure, dpi, false), false); }

Image screen_image(const Figure& figure, double dpi, const ScreenLook& look) {
  return image_of(raster(figure, dpi, true, &look), true);
}

Image screen_overlay(const Figure& figure, double dpi, const ScreenLook& look) {
  return image_of(raster(figure, dpi, false, &look), false);
}

std::string figure_png(const Figure& figure, double dpi) { return surface_png(raster(figure, dpi).get(), dpi); }

std::string image_png(const Image& image, double dpi) {
  const double w = image.width * mm_per_inch / dpi, h = image.height * mm_per_inch / dpi;
  return figure_png(
      Figure{"picture", {}, {}, w, h, false, [&](Canvas& canvas) { canvas.image(image, canvas.sheet()); }}, dpi);
}

std::string figure_svg(const Figure& figure) {
  std::string bytes;
  {
    Surface surface(
        cairo_svg_surface_create_for_stream(append, &bytes, figure.width_mm * pt_per_mm, figure.height_mm * pt_per_mm),
        cairo_surface_destroy);
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PT);
    check(cairo_surface_status(surface.get()), figure);
    draw_on(surface.get(), figure, pt_per_mm);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()), figure);
  }
  return with_own_numbers(bytes);
}

std::string figure_pdf(const Figure& figure) {
  std::string bytes;
  {
    Surface surface(
        cairo_pdf_surface_create_for_stream(append, &bytes, figure.width_mm * pt_per_mm, figure.height_mm * pt_per_mm),
        cairo_surface_destroy);
    check(cairo_surface_status(surface.get()), figure);
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, figure.title.c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "Bole");
    // The time of drawing would make equal runs differ.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    draw_on(surface.get(), figure, pt_per_mm);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()), figure);
  }
  return bytes;
}

}  // namespace bole::render
