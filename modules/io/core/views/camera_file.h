// camera.json and mat.json of a folder of views.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/report.h"
#include "camera/camera_model.h"
#include "cloud/core/view_source.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

// {"width": 1280, "height": 720, "fx": 912.5, "fy": 912.5, "cx": 639.5, "cy": 359.5,
//  "distortion": [k1, k2, p1, p2, k3], "depth_scale": 1000,
//  "depth": {a camera like this one}, "depth_to_color": 4 x 4, rows first, metres}
//
// `distortion`, `depth` and `depth_to_color` may be absent: none, registered to colour, the same axes. depth_scale is
// in units of the depth image per metre; where it is absent it is 1000, and the report says so if `with_depth`. Throws
// Error{bad_input} that names the entry. Open3D's intrinsic_matrix is understood in place of fx, fy, cx and cy.
RgbdCamera parse_camera(Bytes text, bool with_depth, Report& report);
RgbdCamera read_camera_file(const std::filesystem::path& path, bool with_depth, Report& report);
// The entry depth_bias: coefficients of what is to be added to a measured depth (camera/camera_json.h), or none. Throws
// Error{bad_input} where they are more than three or move depth by more than a fifth within 5 m.
std::vector<double> read_depth_bias(const std::filesystem::path& path);
std::string camera_text(const RgbdCamera& camera);
void write_camera_file(const std::filesystem::path& path, const RgbdCamera& camera);

// {"type": "charuco" or "chessboard", "dictionary": "DICT_4X4_50", "squares": [11, 9], "square_mm": 30,
//  "marker_mm": 22, "first_square": "black" or "white"}
BoardFacts parse_board(Bytes text);
BoardFacts read_board_file(const std::filesystem::path& path);
std::string board_text(const BoardFacts& board);
void write_board_file(const std::filesystem::path& path, const BoardFacts& board);

}  // namespace bole::io
