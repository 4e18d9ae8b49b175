// plot_speed cloud=FILE [copies=N] [bare=yes] [threads=N] [cancel=N] [steps=yes] [table=FILE] [option=value ...] From a
// file to the stem table, as pipelines/stem_map_from_cloud.json goes: wall clock, processor time, points per second and
// peak memory of each stage. `copies` lays the cloud N times beside itself, for the memory of large plots; `bare` drops
// all columns but intensity, as most clouds of other makers come. Heights, classes and labels of the file are dropped
// in any case. Where the machine is busy the processor time by the number of threads tells what an idle one would take.
// Options are those of stems.measure. `cancel` measures the stems N times more, cancelled at moments spread over the
// time of the first, and prints how long each took to end. `steps` prints the seconds between the words of progress of
// the stems too, and `table` writes the stems and the rejected with all digits, to compare two programs. Not a Google
// Benchmark: a run of minutes is not repeated until it settles.
#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <chrono>
#include <condition_variable>
#include <fstream>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "bench/run_tool.h"
#include "ground/core/model_ground.h"
#include "ground/core/rasters.h"
#include "io/core/clouds/cloud_reader.h"
#include "stems/core/breast_height_slice.h"
#include "stems/core/measure_stems.h"

namespace {

using namespace bole;

double processor_s() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(use.ru_utime) + seconds(use.ru_stime);
}

// Highest resident size since the last call, MiB.
double peak_mib() {
  std::ifstream status("/proc/self/status");
  double kib = 0;
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) kib = std::stod(line.substr(6));
  std::ofstream("/proc/self/clear_refs") << "5";
  return kib / 1024;
}

// Runs one stage and prints its row.
class Clock {
 public:
  template <class F>
  auto time(const std::string& stage, std::size_t points, F&& f) {
    peak_mib();
    const auto start = std::chrono::steady_clock::now();
    const double processor = processor_s();
    auto result = f();
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                 used = processor_s() - processor;
    if constexpr (requires { result.cloud.size(); }) points = result.cloud.size();
    print(stage, points, wall, used);
    wall_ += wall, processor_ += used;
    return result;
  }
  void total(std::size_t points) const { print("all", points, wall_, processor_, most_mib_); }

 private:
  void print(const std::string& stage, std::size_t points, double wall, double used) {
    const double mib = peak_mib();
    most_mib_ = std::max(most_mib_, mib);
    print(stage, points, wall, used, mib);
  }
  static void print(const std::string& stage, std::size_t points, double wall, double used, double mib) {
    fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.0f} |\n", stage, wall, used,
               1e-6 * static_cast<double>(points) / wall, mib);
    std::fflush(stdout);
  }
  double wall_ = 0, processor_ = 0, most_mib_ = 0;
};

// What a stage takes between the words of its progress; numbers in them do not count.
class Steps {
 public:
  void begin(std::string_view words) {
    end();
    step_ = std::string(words.substr(0, words.find_first_of("0123456789")));
  }
  void print() {
    end();
    for (const auto& [step, time] : times_)
      fmt::print("|   {} | {:.2f} | {:.2f} | | |\n", step, time.first, time.second);
  }

 private:
  void end() {
    const auto now = std::chrono::steady_clock::now();
    const double processor = processor_s();
    auto at = std::ranges::find(times_, step_, [](const auto& t) { return t.first; });
    if (at == times_.end()) at = times_.insert(at, {step_, {0, 0}});
    at->second.first += std::chrono::duration<double>(now - start_).count(), at->second.second += processor - used_;
    start_ = now, used_ = processor;
  }
  std::string step_ = "start";
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double used_ = processor_s();
  std::vector<std::pair<std::string, std::pair<double, double>>> times_;  // wall clock and processor
};

void write_table(const std::string& file, const stems::StemSurvey& survey) {
  std::ofstream out(file);
  for (const auto& s : survey.stems)
    out << fmt::format("stem {} {:.9f} {:.9f} {:.9f} dbh {:.9f} {:.9f} {:.9f} height {:.6f} volume {:.9f} {} {} {}\n",
                       s.id, s.breast_height.x(), s.breast_height.y(), s.breast_height.z(), 200 * s.radius,
                       200 * s.radius_low, 200 * s.radius_high, s.height_m, s.volume_m3, s.quality, s.state,
                       stems::joined(s.reasons));
  for (const auto& r : survey.rejected)
    out << fmt::format("rejected {:.6f} {:.6f} {:.6f} {} {}\n", r.position.x(), r.position.y(), 100 * r.dbh_m, r.points,
                       r.reason);
}

// Seconds of wall clock and of the processor from a cancel, `after_s` into the measurement, to its end; less than zero
// where it had ended before.
std::pair<double, double> time_to_end(double after_s, const std::function<void(const Run&)>& measure) {
  using Seconds = std::chrono::duration<double>;
  std::stop_source stop;
  std::chrono::steady_clock::time_point asked;
  double processor = 0;
  bool ended = false;
  std::mutex mutex;
  std::condition_variable end;
  std::thread timer([&] {
    std::unique_lock lock(mutex);
    if (end.wait_for(lock, Seconds(after_s), [&] { return ended; })) return;
    asked = std::chrono::steady_clock::now(), processor = processor_s();
    stop.request_stop();
  });
  Run run;
  run.cancel = stop.get_token();
  try {
    measure(run);
  } catch (const Error&) {
  }
  const auto now = std::chrono::steady_clock::now();
  const double used = processor_s();
  {
    const std::lock_guard lock(mutex);
    ended = true;
  }
  end.notify_all();
  timer.join();
  return stop.stop_requested() ? std::pair(Seconds(now - asked).count(), used - processor) : std::pair(-1.0, -1.0);
}

void print_cancels(int times, double whole_s, const std::function<void(const Run&)>& measure) {
  if (times < 1) return;
  fmt::print("\n| cancelled after, s | to the end, wall, s | processor, s |\n|---|---|---|\n");
  for (int k = 0; k < times; ++k) {
    const double after = whole_s * (k + 0.5) / times;
    const auto [wall, processor] = time_to_end(after, measure);
    if (wall >= 0) fmt::print("| {:.2f} | {:.2f} | {:.2f} |\n", after, wall, processor);
    std::fflush(stdout);
  }
}

// N times the cloud side by side along x, with the columns that remain.
PointCloud beside_itself(PointCloud cloud, int copies, bool bare) {
  for (const auto* label : {"tree_id", "stem", "height_above_ground", "classification"}) cloud.remove_column(label);
  if (bare) {
    std::vector<std::string> names;
    for (const auto& [name, column] : cloud.columns())
      if (name != "intensity") names.push_back(name);
    for (const auto& name : names) cloud.remove_column(name);
  }
  if (copies < 2) return cloud;
  float low = cloud.positions()[0].x(), high = low;
  for (const auto& p : cloud.positions()) low = std::min(low, p.x()), high = std::max(high, p.x());
  const std::size_t n = cloud.size();
  PointCloud::Positions positions;
  positions.reserve(n * static_cast<std::size_t>(copies));
  for (int k = 0; k < copies; ++k)
    for (const auto& p : cloud.positions())
      positions.emplace_back(p.x() + static_cast<float>(k) * (high - low), p.y(), p.z());
  PointCloud out(std::move(positions), cloud.origin);
  out.axes = cloud.axes;
  while (!cloud.columns().empty()) {
    const auto name = cloud.columns().begin()->first;
    out.set_column(name, std::visit(
                             [&](const auto& values) -> Column {
                               auto all = values;
                               all.reserve(n * static_cast<std::size_t>(copies));
                               for (int k = 1; k < copies; ++k) {
                                 all.insert(all.end(), values.begin(), values.end());
                                 if (name == arrays::sensor_x.name)
                                   for (std::size_t i = all.size() - n; i < all.size(); ++i)
                                     all[i] = static_cast<typename std::decay_t<decltype(all)>::value_type>(
                                         static_cast<double>(all[i]) + k * static_cast<double>(high - low));
                               }
                               return all;
                             },
                             cloud.column(name)));
    cloud.remove_column(name);
  }
  return out;
}

int run(int argc, char** argv) {
  std::string file;
  int copies = 1, threads = 2, cancels = 0;
  bool bare = false, steps = false;
  std::string table;
  OptionSet options(option_table(static_cast<const stems::MeasureOptions*>(nullptr)));
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i], name = argument.substr(0, argument.find('=')),
                      value = argument.substr(std::min(argument.size(), name.size() + 1));
    if (name == "cloud")
      file = value;
    else if (name == "copies")
      copies = std::stoi(value);
    else if (name == "threads")
      threads = std::stoi(value);
    else if (name == "cancel")
      cancels = std::stoi(value);
    else if (name == "table")
      table = value;
    else if (name == "steps")
      steps = value == "yes";
    else if (name == "bare")
      bare = value == "yes";
    else
      options.set_text(name, value);
  }
  if (file.empty()) throw bad_input("no cloud is given", "cloud=FILE");
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  fmt::print("| stage | wall, s | processor, s | million points/s | peak, MiB |\n|---|---|---|---|---|\n");
  Clock clock;
  auto points = clock.time("read", 0, [&] { return io::read_cloud(file); }).cloud;
  points = beside_itself(std::move(points), copies, bare);
  const std::size_t n = points.size();
  auto model = clock.time("ground", n, [&] { return ground::model_ground(points, {}, {}); });
  points.set_column(arrays::height_above_ground, std::move(model.height_above_ground));
  points.set_column(arrays::classification, std::move(model.classification));
  clock.time("slope and canopy", n, [&] {
    return std::pair(ground::slope_deg(model.dem), ground::canopy_height(points, model.dem, model.dem.cell_m));
  });
  clock.time("slice", n, [&] { return stems::breast_height_slice(points, {}, {}); });
  const auto measure = [&](const Run& run) {
    return stems::measure_stems(points, usual_breast_height_m, model.dem, nullptr, options.as<stems::MeasureOptions>(),
                                run);
  };
  const auto start = std::chrono::steady_clock::now();
  Steps taken;
  Run watched;
  if (steps) watched.progress = [&](double, std::string_view words) { taken.begin(words); };
  const auto survey = clock.time("stems", n, [&] { return measure(watched); });
  if (steps) taken.print();
  const double whole_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  clock.total(n);
  if (!table.empty()) write_table(table, survey);
  fmt::print("\n{:.1f} million points, {} threads: {} stems\n", 1e-6 * static_cast<double>(n), threads,
             survey.stems.size());
  print_cancels(cancels, whole_s, [&](const Run& run) { measure(run); });
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return bole::run_tool(run, argc, argv); }
