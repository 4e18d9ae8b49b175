// The pictures of an RGB-D camera or of a plain camera. A *view* is one picture, with depth where the camera gives it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "camera/camera_model.h"
#include "camera/image.h"
#include "cloud/facts.h"
#include "cloud/trajectory.h"

namespace bole {
inline namespace cloud {

struct View {
  ColorImage color;
  DepthImage depth;  // empty where there is none; in the axes of the depth camera (RgbdCamera::of_depth())
  MaskImage mask;    // 255 where the picture shows the object; empty where it is not known
};

// Which images to read.
struct ViewParts {
  bool color = true, depth = true, mask = true;
};

// A printed board with chess squares and markers that fixes scale and axes: x along the columns, y along the rows,
// z up out of the print, origin in the first corner of the board (OpenCV's ChArUco board).
struct BoardFacts {
  std::string dictionary = "DICT_4X4_50";
  int columns = 0, rows = 0;  // squares
  double square = 0;          // metres
  double marker = 0;          // metres; 0: a chessboard without markers
  bool first_square_black = true;
};

// Views in the order of their times. One source may be read from several threads at a time.
class ViewSource {
 public:
  virtual ~ViewSource() = default;
  virtual std::size_t size() const = 0;
  // Fills `view` (its memory is re-used). Throws Error{bad_input} naming the file when it cannot be decoded.
  virtual void read(std::size_t index, View& view, ViewParts parts = {}) const = 0;
  virtual double time_s(std::size_t index) const = 0;  // strictly increasing
  virtual std::string name(std::size_t index) const = 0;
  virtual const RgbdCamera& camera(std::size_t index) const = 0;
  virtual bool has_depth() const = 0;
  // T_world_camera of the colour camera as the data give it, at the times of the views. Empty where none are given;
  // views without a pose are missing in it.
  virtual const Trajectory& given_poses() const = 0;
  virtual std::optional<BoardFacts> board() const { return std::nullopt; }
  // How the views are to be used: "test" for those that a dataset keeps back; empty where nothing is said.
  virtual std::string split(std::size_t) const { return {}; }
  virtual Facts facts() const { return {}; }
  virtual std::string description() const = 0;  // "plant_07: 120 views, 1280 x 720, depth 848 x 480"
  // Where it came from, so that a stored result can name and reopen it: a JSON text that its reader understands.
  virtual std::string locator() const = 0;
};

// The pose of a view in `poses`, or nothing where it has none. Times agree to a microsecond.
std::optional<Pose> pose_of_view(const Trajectory& poses, double time_s);

}  // namespace cloud
}  // namespace bole
