// Views from files, decoded when they are read.
#pragma once

#include "io/core/views/found_views.h"
#include "io/core/views/view_files.h"

namespace bole::io {

class FileViews : public ViewSource {
 public:
  // `found` is checked (check_images).
  FileViews(FoundViews found, const ReadViewsOptions& options, std::string locator);

  std::size_t size() const override { return files_.size(); }
  void read(std::size_t index, View& view, ViewParts parts) const override;
  double time_s(std::size_t index) const override { return file(index).time_s; }
  std::string name(std::size_t index) const override { return file(index).name; }
  const RgbdCamera& camera(std::size_t index) const override { return cameras_[file(index).camera]; }
  bool has_depth() const override { return has_depth_; }
  const Trajectory& given_poses() const override { return poses_; }
  std::optional<BoardFacts> board() const override { return board_; }
  std::string split(std::size_t index) const override { return file(index).split; }
  Facts facts() const override { return facts_; }
  std::string description() const override { return description_; }
  std::string locator() const override { return locator_; }

 private:
  const ViewFile& file(std::size_t index) const;  // throws Error{bad_input} where there is no such view
  std::string describe() const;

  std::filesystem::path folder_;
  std::vector<ViewFile> files_;
  std::vector<RgbdCamera> cameras_;
  DepthCoding coding_;
  bool has_depth_ = false;
  Trajectory poses_;
  std::optional<BoardFacts> board_;
  Facts facts_;
  std::string description_, locator_;
};

}  // namespace bole::io
