#include "trajectory_figures.h"

#include <filesystem>

#include "base/atomic_file.h"
#include "base/error.h"
#include "render/charts/trajectory_charts.h"

namespace bole::cli {
namespace {

constexpr double width_mm = 180, dpi = 200;

std::string drawn(const render::Figure& figure, const std::string& ending) {
  if (ending == ".svg") return render::figure_svg(figure);
  if (ending == ".pdf") return render::figure_pdf(figure);
  if (ending == ".png") return render::figure_png(figure, dpi);
  throw bad_input("the figure's name ends with '" + ending + "'", ".svg, .pdf or .png");
}

}  // namespace

void draw_trajectories(const Trajectory& estimate, const Trajectory& reference, const Table* loops,
                       const std::string& figure_file, const std::string& folder) {
  const render::TrajectoryComparison both{&estimate, &reference, loops};
  if (!figure_file.empty()) {
    const std::string ending = std::filesystem::path(figure_file).extension().string();
    write_text_file(figure_file, drawn(render::trajectory_sheet(both, width_mm), ending));
  }
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw failure("cannot make the folder " + folder + ": " + error.message());
  for (const auto& figure :
       {render::trajectory_overlay(both, width_mm), render::trajectory_error_chart(both, width_mm)})
    for (const char* ending : {".svg", ".png"})
      write_text_file(std::filesystem::path(folder) / (figure.name + ending), drawn(figure, ending));
}

}  // namespace bole::cli
