// A plot that a test of the window runs in a second.
#pragma once

#include <cmath>
#include <fstream>
#include <string>

namespace bole::desktop {

// Flat ground with nine upright stems of 20 cm, 3 m apart, the first at (1.5, 1.5), rows along y.
inline void write_cloud(const std::string& path) {
  std::ofstream out(path);
  for (int i = 0; i < 120; ++i)
    for (int j = 0; j < 120; ++j) out << i * 0.08 << ' ' << j * 0.08 << ' ' << 0.01 * ((i * 7 + j * 3) % 3) << '\n';
  for (int tree = 0; tree < 9; ++tree)
    for (int layer = 0; layer < 160; ++layer)
      for (int k = 0; k < 40; ++k) {
        const double angle = 2 * M_PI * (k + 0.37 * layer) / 40;
        out << 1.5 + 3 * (tree % 3) + 0.1 * std::cos(angle) << ' ' << 1.5 + 3 * (tree / 3) + 0.1 * std::sin(angle)
            << ' ' << 0.03 * layer << '\n';
      }
}

inline void write_pipeline(const std::string& path) {
  std::ofstream(path) << R"({"title": "Test", "stages": [
    {"id": "scan", "type": "io.read_cloud", "options": {"file": "cloud.xyz"}},
    {"id": "ground", "type": "ground.model", "options": {"method": "tin"}, "inputs": {"points": "scan.points"}},
    {"id": "slice", "type": "stems.slice", "inputs": {"points": "ground.points"}},
    {"id": "stems", "type": "stems.measure", "inputs": {"points": "ground.points", "slice": "slice.slice", "dem": "ground.dem"}},
    {"id": "edit", "type": "stems.edit", "inputs": {"stems": "stems.stems", "sections": "stems.sections", "points": "stems.points", "slice": "slice.slice"}}]})";
}

// The same with the place of the plot on the earth, from control points that are still to be given.
inline void write_placed_pipeline(const std::string& path) {
  std::ofstream(path) << R"({"title": "Placed", "stages": [
    {"id": "scan", "type": "io.read_cloud", "options": {"file": "cloud.xyz"}},
    {"id": "ground", "type": "ground.model", "options": {"method": "tin"}, "inputs": {"points": "scan.points"}},
    {"id": "slice", "type": "stems.slice", "inputs": {"points": "ground.points"}},
    {"id": "stems", "type": "stems.measure", "inputs": {"points": "ground.points", "slice": "slice.slice", "dem": "ground.dem"}},
    {"id": "edit", "type": "stems.edit", "inputs": {"stems": "stems.stems", "sections": "stems.sections", "points": "stems.points", "slice": "slice.slice"}},
    {"id": "place", "type": "survey.georeference", "inputs": {"stems": "edit.stems", "dem": "ground.dem"}}]})";
}

// Rows of plants from the stems.
inline void write_rows_pipeline(const std::string& path) {
  std::ofstream(path) << R"({"title": "Rows", "stages": [
    {"id": "scan", "type": "io.read_cloud", "options": {"file": "cloud.xyz"}},
    {"id": "ground", "type": "ground.model", "inputs": {"points": "scan.points"}},
    {"id": "slice", "type": "stems.slice", "inputs": {"points": "ground.points"}},
    {"id": "stems", "type": "stems.measure", "inputs": {"points": "ground.points", "slice": "slice.slice", "dem": "ground.dem"}},
    {"id": "rows", "type": "rows.from_stems", "inputs": {"stems": "stems.stems"}},
    {"id": "redone", "type": "rows.edit", "inputs": {"rows": "rows.rows", "plants": "rows.plants", "lines": "rows.lines", "strays": "rows.strays"}}]})";
}

}  // namespace bole::desktop
