#include "io/core/views/camera_file.h"

#include <algorithm>
#include <array>

#include "base/atomic_file.h"
#include "base/option.h"
#include "camera/camera_json.h"
#include "io/core/views/json_fields.h"
#include "io/core/views/pose_matrix.h"

namespace bole::io {
namespace {

constexpr const char* camera_needed =
    "an object with width, height, fx, fy, cx, cy, distortion (five numbers) and depth_scale";
constexpr const char* board_needed =
    R"({"type": "charuco", "dictionary": "DICT_4X4_50", "squares": [11, 9], "square_mm": 30, "marker_mm": 22})";

void take_distortion(const Json& json, CameraModel& camera) {
  if (!holds(json, "distortion")) return;
  constexpr const char* needed = "k1, k2, p1, p2 and k3";
  const auto values = numbers_of(json["distortion"], "distortion", needed);
  // Of OpenCV's longer models those that are zero behind k3 are this one.
  const bool more = values.size() > 5 && std::any_of(values.begin() + 5, values.end(), [](double v) { return v != 0; });
  if (more || values.size() > 14 || (!values.empty() && values.size() < 4))
    throw bad_input("the entry 'distortion' has " + std::to_string(values.size()) + " numbers", needed,
                    "Calibrate with the model of five coefficients");
  std::copy_n(values.begin(), std::min<std::size_t>(values.size(), 5), camera.distortion.begin());
}

// Open3D's {"width", "height", "intrinsic_matrix"}: nine numbers, columns first; rows first are told from them by the
// place of the principal point.
void take_matrix(Json& json) {
  constexpr const char* needed = "fx, 0, 0, 0, fy, 0, cx, cy, 1";
  const auto m = numbers_of(json["intrinsic_matrix"], "intrinsic_matrix", needed);
  const bool columns = m.size() == 9 && m[2] == 0 && m[5] == 0;
  const bool rows = m.size() == 9 && m[6] == 0 && m[7] == 0;
  if ((!columns && !rows) || m[8] != 1)
    throw bad_input("the entry 'intrinsic_matrix' is " + shown(json["intrinsic_matrix"]), needed);
  json["fx"] = m[0];
  json["fy"] = m[4];
  json["cx"] = columns ? m[6] : m[2];
  json["cy"] = columns ? m[7] : m[5];
}

CameraModel camera_from_json(const Json& json) {
  CameraModel camera;
  camera.width = whole_number_at(json, "width");
  camera.height = whole_number_at(json, "height");
  camera.fx = number_at(json, "fx");
  camera.fy = number_at(json, "fy");
  camera.cx = number_at(json, "cx");
  camera.cy = number_at(json, "cy");
  take_distortion(json, camera);
  camera.check();
  return camera;
}

void take_depth_scale(const Json& json, bool with_depth, RgbdCamera& camera, Report& report) {
  const Json* at = holds(json, "depth_scale") ? &json : nullptr;
  if (at == nullptr && holds(json, "depth") && holds(json["depth"], "depth_scale")) at = &json["depth"];
  if (at == nullptr) {
    if (with_depth)
      report.find(Severity::look, "depth_scale_assumed",
                  "camera.json has no depth_scale: 1000 units of the depth image per metre are assumed");
    return;
  }
  camera.depth_scale = number_at(*at, "depth_scale");
  if (!(camera.depth_scale >= 1 && camera.depth_scale <= 1e6))
    throw bad_input("the entry 'depth_scale' is " + number_text(camera.depth_scale),
                    "units of the depth image per metre, from 1 to 1000000 (1000: millimetres)",
                    camera.depth_scale > 0 && camera.depth_scale < 1
                        ? "Metres per unit are given the other way round: 0.001 is 1000"
                        : "");
}

void take_depth_camera(const Json& json, RgbdCamera& camera, Report& report) {
  if (!holds(json, "depth")) return;
  if (!json["depth"].is_object())
    throw bad_input("the entry 'depth' is " + shown(json["depth"]), "a camera: width, height, fx, fy, cx, cy");
  try {
    camera.depth = camera_from_json(json["depth"]);
  } catch (const Error& e) {
    throw e.at("depth");
  }
  if (!holds(json, "depth_to_color")) {
    report.find(Severity::look, "depth_to_color_missing",
                "camera.json has a depth camera and no depth_to_color: the two cameras are taken to be at one place");
    return;
  }
  camera.T_color_depth = pose_from_matrix(
      numbers_of(json["depth_to_color"], "depth_to_color", "a matrix of 4 x 4 numbers"), "depth_to_color");
  constexpr double max_apart = 0.5;  // metres between the cameras of one housing
  if (const double apart = camera.T_color_depth.translation().norm(); apart > max_apart)
    throw bad_input("depth_to_color moves by " + number_text(apart) + " m", "metres between two cameras of one housing",
                    "If these are millimetres, divide them by 1000");
}

// The dictionaries of OpenCV with the number of their markers.
std::size_t markers_in(const std::string& dictionary) {
  if (dictionary == "DICT_ARUCO_ORIGINAL") return 1024;
  for (const char* size : {"4X4", "5X5", "6X6", "7X7"})
    for (const std::size_t count : {50, 100, 250, 1000})
      if (dictionary == "DICT_" + std::string(size) + "_" + std::to_string(count)) return count;
  for (const auto& [name, count] : {std::pair{"16h5", 30}, {"25h9", 35}, {"36h10", 2320}, {"36h11", 587}})
    if (dictionary == "DICT_APRILTAG_" + std::string(name)) return static_cast<std::size_t>(count);
  return 0;
}

void take_squares(const Json& json, BoardFacts& board) {
  constexpr const char* needed = "two whole numbers from 2 to 100: columns and rows";
  const auto squares = numbers_of(holds(json, "squares") ? json["squares"] : Json(), "squares", needed);
  const auto whole = [](double v) { return v >= 2 && v <= 100 && v == std::floor(v); };
  if (squares.size() != 2 || !std::ranges::all_of(squares, whole))
    throw bad_input("the entry 'squares' is " + shown(json.value("squares", Json())), needed);
  board.columns = static_cast<int>(squares[0]);
  board.rows = static_cast<int>(squares[1]);
}

void take_markers(const Json& json, double square_mm, BoardFacts& board) {
  board.dictionary = text_at(json, "dictionary", board.dictionary);
  const auto known = markers_in(board.dictionary);
  if (known == 0)
    throw bad_input("the entry 'dictionary' is '" + board.dictionary + "'",
                    "a dictionary of OpenCV, such as DICT_4X4_50 or DICT_6X6_250");
  const auto markers = static_cast<std::size_t>(board.columns * board.rows / 2);
  if (markers > known)
    throw bad_input("a board of " + std::to_string(board.columns) + " x " + std::to_string(board.rows) +
                        " squares has " + std::to_string(markers) + " markers, " + board.dictionary + " has " +
                        std::to_string(known),
                    "a dictionary that is large enough");
  const double marker_mm = number_at(json, "marker_mm");
  if (!(marker_mm > 0.2 * square_mm && marker_mm < square_mm))
    throw bad_input("marker_mm is " + number_text(marker_mm) + " and square_mm " + number_text(square_mm),
                    "markers smaller than the squares, and not below a fifth of them");
  board.marker = marker_mm / 1000;
}

}  // namespace

RgbdCamera parse_camera(Bytes text, bool with_depth, Report& report) {
  auto json = parse_object(text, camera_needed);
  if (holds(json, "intrinsic_matrix")) take_matrix(json);
  RgbdCamera camera;
  camera.color = camera_from_json(json);
  take_depth_scale(json, with_depth, camera, report);
  take_depth_camera(json, camera, report);
  return camera;
}

RgbdCamera read_camera_file(const std::filesystem::path& path, bool with_depth, Report& report) {
  const MappedFile file(path);
  try {
    return parse_camera(file.bytes(), with_depth, report);
  } catch (const Error& e) {
    throw e.at("'" + path.string() + "'");
  }
}

std::vector<double> read_depth_bias(const std::filesystem::path& path) {
  constexpr const char* needed = "up to three numbers b0, b1, b2 in metres";
  const MappedFile file(path);
  const auto json = parse_object(file.bytes(), camera_needed);
  if (!holds(json, "depth_bias")) return {};
  auto bias = numbers_of(json["depth_bias"], "depth_bias", needed);
  bias.resize(std::max<std::size_t>(bias.size(), 3));
  bool small = bias.size() == 3;
  for (const double z : {0.3, 1.0, 5.0}) small = small && std::abs(bias[0] + z * (bias[1] + z * bias[2])) < 0.2 * z;
  if (!small)
    throw bad_input("the entry 'depth_bias' is " + shown(json["depth_bias"]), needed).at("'" + path.string() + "'");
  return bias;
}

std::string camera_text(const RgbdCamera& camera) { return camera_json(camera); }

void write_camera_file(const std::filesystem::path& path, const RgbdCamera& camera) {
  write_text_file(path, camera_text(camera));
}

BoardFacts parse_board(Bytes text) {
  const auto json = parse_object(text, board_needed);
  BoardFacts board;
  const auto type = text_at(json, "type", "charuco");
  if (type != "charuco" && type != "chessboard")
    throw bad_input("the entry 'type' is '" + type + "'", "charuco or chessboard");
  take_squares(json, board);
  const double square_mm = number_at(json, "square_mm");
  if (!(square_mm >= 1 && square_mm <= 1000))
    throw bad_input("square_mm is " + number_text(square_mm), "millimetres, from 1 to 1000",
                    square_mm > 0 && square_mm < 1 ? "Metres times 1000 are millimetres" : "");
  board.square = square_mm / 1000;
  if (type == "charuco") take_markers(json, square_mm, board);
  const auto first = text_at(json, "first_square", "black");
  if (first != "black" && first != "white")
    throw bad_input("the entry 'first_square' is '" + first + "'", "black or white");
  board.first_square_black = first == "black";
  return board;
}

BoardFacts read_board_file(const std::filesystem::path& path) {
  const MappedFile file(path);
  try {
    return parse_board(file.bytes());
  } catch (const Error& e) {
    throw e.at("'" + path.string() + "'");
  }
}

std::string board_text(const BoardFacts& board) {
  const auto millimetres = [](double metres) { return std::round(metres * 1e6) / 1e3; };
  Json json{{"type", board.marker > 0 ? "charuco" : "chessboard"},
            {"squares", {board.columns, board.rows}},
            {"square_mm", millimetres(board.square)},
            {"first_square", board.first_square_black ? "black" : "white"}};
  if (board.marker > 0) {
    json["dictionary"] = board.dictionary;
    json["marker_mm"] = millimetres(board.marker);
  }
  return json.dump(2) + "\n";
}

void write_board_file(const std::filesystem::path& path, const BoardFacts& board) {
  write_text_file(path, board_text(board));
}

}  // namespace bole::io
