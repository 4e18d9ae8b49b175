// The files beside pictures: cameras, boards, transforms.json, models of COLMAP, lists of poses, and headers of images.
// The first byte chooses the parser.
#include <cmath>
#include <cstring>

#include "fuzz_target.h"
#include "io/core/views/camera_file.h"
#include "io/core/views/colmap_model.h"
#include "io/core/views/image_header.h"
#include "io/core/views/pose_list.h"
#include "io/core/views/transforms_file.h"
#include "io/core/views/view_files.h"

namespace bole::fuzz {
namespace {

template <class T>
void put(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

std::string colmap_camera() {
  std::string out;
  put(out, std::uint64_t{1});
  put(out, std::uint32_t{1});
  put(out, std::uint32_t{1});
  put(out, std::uint64_t{64});
  put(out, std::uint64_t{48});
  for (const double v : {60.0, 61.0, 32.0, 24.0}) put(out, v);
  return out;
}

std::string colmap_image() {
  std::string out;
  put(out, std::uint64_t{1});
  put(out, std::uint32_t{1});
  for (const double v : {1.0, 0.0, 0.0, 0.0, 0.1, 0.2, 0.3}) put(out, v);
  put(out, std::uint32_t{1});
  out += "a.png";
  out += '\0';
  put(out, std::uint64_t{0});
  return out;
}

std::string colmap_point() {
  std::string out;
  put(out, std::uint64_t{1});
  put(out, std::uint64_t{7});
  for (const double v : {0.1, 0.2, 0.3}) put(out, v);
  out += "rgb";
  put(out, 0.5);
  put(out, std::uint64_t{1});
  put(out, std::uint64_t{3});
  return out;
}

void read_all(char choice, io::Bytes bytes) {
  Report report;
  switch (choice) {
    case 'c':
      io::camera_text(io::parse_camera(bytes, true, report));
      break;
    case 'b':
      io::board_text(io::parse_board(bytes));
      break;
    case 't':
      for (auto& view : io::parse_transforms(bytes).views) io::complete_camera(view, 64, 48);
      break;
    case 'C':
    case 'd':
      io::parse_colmap_cameras(bytes, choice == 'C');
      break;
    case 'I':
    case 'j':
      io::parse_colmap_images(bytes, choice == 'I');
      break;
    case 'P':
    case 'q':
      io::parse_colmap_points(bytes, choice == 'P');
      break;
    case 'l':
      io::parse_pose_list(bytes, "poses.txt");
      break;
    default:
      io::image_header(bytes);
      io::is_whole_jpeg(bytes);
      io::seems_little_endian_pgm(bytes);
  }
}

}  // namespace

void write_seeds(const std::filesystem::path& folder) {
  write_seed(folder, "camera", R"(c{"width":64,"height":48,"fx":60,"fy":61,"cx":31.5,"cy":23.5,"distortion":[0,0,0,0,0],
"depth_scale":1000,"depth":{"width":64,"height":48,"fx":60,"fy":61,"cx":31.5,"cy":23.5},
"depth_to_color":[[1,0,0,0.01],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})");
  write_seed(folder, "open3d", R"(c{"width":64,"height":48,"intrinsic_matrix":[60,0,0,0,61,0,31.5,23.5,1]})");
  write_seed(folder, "board",
             R"(b{"type":"charuco","dictionary":"DICT_4X4_50","squares":[11,9],"square_mm":30,"marker_mm":22})");
  write_seed(folder, "transforms", R"(t{"camera_angle_x":0.8,"k1":0.01,"frames":[{"file_path":"a",
"transform_matrix":[[1,0,0,1],[0,1,0,2],[0,0,1,3],[0,0,0,1]]}]})");
  write_seed(folder, "cameras_bin", "C" + colmap_camera());
  write_seed(folder, "cameras_txt", "d# comment\n1 PINHOLE 64 48 60 61 32 24\n");
  write_seed(folder, "images_bin", "I" + colmap_image());
  write_seed(folder, "images_txt", "j1 1 0 0 0 0.1 0.2 0.3 1 a.png\n1 2 -1\n");
  write_seed(folder, "points_bin", "P" + colmap_point());
  write_seed(folder, "points_txt", "q7 0.1 0.2 0.3 255 0 0 0.5 1 0 2 0\n");
  write_seed(folder, "log", "l0 0 1\n1 0 0 1\n0 1 0 2\n0 0 1 3\n0 0 0 1\n");
  write_seed(folder, "quaternions", "l0.1 0.2 0.3 0 0 0 1\n");
  write_seed(folder, "pgm", std::string("gP5 2 2 65535\n\1\2\3\4\5\6\7\x08", 22));
  write_seed(folder, "png", std::string("g\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x02\0\0\0\x01\x10\0\0\0\0\0\0\0\0", 34));
  write_seed(folder, "jpeg", std::string("g\xff\xd8\xff\xc0\0\x0b\x08\0\2\0\2\1\1\x11\0\xff\xda\0\2\1\xff\xd9", 23));
}

}  // namespace bole::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  bole::fuzz::allow_bad_input([&] { bole::fuzz::read_all(static_cast<char>(data[0]), {data + 1, size - 1}); });
  return 0;
}
