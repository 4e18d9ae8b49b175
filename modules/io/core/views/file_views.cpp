#include "io/core/views/file_views.h"

#include <algorithm>

#include "base/error.h"
#include "cloud/known_facts.h"

namespace bole::io {

FileViews::FileViews(FoundViews found, const ReadViewsOptions& options, std::string locator)
    : folder_(std::move(found.folder)),
      files_(std::move(found.files)),
      cameras_(std::move(found.cameras)),
      board_(std::move(found.board)),
      facts_(std::move(found.facts)),
      locator_(std::move(locator)) {
  if (options.max_depth) coding_.max_depth = *options.max_depth;
  coding_.little_endian_pgm = found.little_endian_pgm;
  std::copy_n(found.depth_bias.begin(), std::min(found.depth_bias.size(), coding_.bias.size()), coding_.bias.begin());
  has_depth_ = std::ranges::any_of(files_, [](const ViewFile& f) { return !f.depth.empty(); });
  for (const auto& f : files_)
    if (f.T_world_camera) poses_.poses.push_back({f.time_s, *f.T_world_camera});
  if (!poses_.empty()) poses_.facts[std::string(facts::poses.key)] = "given";
  description_ = describe();
}

const ViewFile& FileViews::file(std::size_t index) const {
  if (index >= files_.size())
    throw bad_input("view " + std::to_string(index) + " of '" + folder_.string() + "'",
                    "0 to " + std::to_string(files_.size() - 1));
  return files_[index];
}

void FileViews::read(std::size_t index, View& view, ViewParts parts) const {
  const auto& from = file(index);
  if (parts.color || (parts.mask && from.mask.empty())) {
    MaskImage alpha;
    ColorImage& color = view.color;
    read_color(from.color, color, alpha);
    view.mask = parts.mask && from.mask.empty() ? std::move(alpha) : MaskImage{};
  } else {
    view.mask = {};
  }
  if (!parts.color) view.color = {};
  if (parts.mask && !from.mask.empty()) read_mask(from.mask, view.mask);
  if (parts.depth && !from.depth.empty()) {
    DepthCoding coding = coding_;
    coding.units_per_metre = cameras_[from.camera].depth_scale;
    read_depth(from.depth, coding, view.depth);
  } else {
    view.depth = {};
  }
}

std::string FileViews::describe() const {
  const auto size = [](const CameraModel& m) { return std::to_string(m.width) + " x " + std::to_string(m.height); };
  const auto& camera = cameras_[files_.front().camera];
  auto name = folder_.filename().empty() ? folder_.parent_path().filename() : folder_.filename();
  return name.string() + ": " + std::to_string(files_.size()) + (files_.size() == 1 ? " view, " : " views, ") +
         size(camera.color) + (has_depth_ ? ", depth " + size(camera.of_depth()) : ", no depth");
}

}  // namespace bole::io
