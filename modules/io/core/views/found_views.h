// What the reader of a layout found in a folder, before the images are looked at.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "cloud/core/view_source.h"
#include "io/core/views/read_views_options.h"

namespace bole::io {

struct ViewFile {
  std::string name{};
  double time_s = 0;
  std::filesystem::path color{}, depth{}, mask{};  // depth and mask: empty where there is none
  std::size_t camera = 0;                          // in FoundViews::cameras
  std::string split{};
  std::optional<Pose> T_world_camera{};
};

struct FoundViews {
  std::filesystem::path folder;
  std::vector<ViewFile> files;      // in the order of their times; files that are listed may be absent
  std::vector<RgbdCamera> cameras;  // width 0: the size of the first image
  std::optional<BoardFacts> board;
  bool little_endian_pgm = false;
  std::vector<double> depth_bias;  // of camera.json; see DepthCoding
  Facts facts;
  Report report;
};

// Things that befell many views, told as one finding: how many, and the first of them.
class Tally {
 public:
  void add(const std::string& example) {
    if (count_++ == 0) first_ = example;
  }
  std::size_t count() const { return count_; }
  // "3 colour images are missing (first: 000017)". Nothing happens where nothing was added.
  void tell(Report& report, Severity severity, const std::string& code, const std::string& text,
            const std::string& remedy = {}) const;
  std::string text(const std::string& what) const;

 private:
  std::size_t count_ = 0;
  std::string first_;
};

// Keeps one view of `every` and at most `max_views`, spread evenly.
void select_views(std::vector<ViewFile>& files, const ReadViewsOptions& options);

// Reads the header of every image. Views whose colour image is missing, damaged or of another size than their camera
// are left out; depth images likewise. Each kind of trouble is a finding with a count. Throws Error{bad_input} where no
// view is left, or depth was there and none of it can be used.
void check_images(FoundViews& found, const Run& run);

// Poses of a file by the time of the view. A pose whose time is no view's, within a millisecond, is left out and told;
// where most of them are, none is used.
void take_poses(const Trajectory& given, const std::string& name, FoundViews& found);

}  // namespace bole::io
