// orchard_loops SCAN [frames=N] [out=DIR] [path=odometry|truth] [drifts=0,0.01] [drift_seed=N]
//               [searches=radius,single,placed,sequence] [registrations=icp,ndt_icp,features]
//               [guess_errors=0.3,1,2 [pairs=N]] [option=value ...]
// SPEC D: one path over a simulated recording, that of the odometry (preset lego_loam, or as the options say) or the
// true one, bent by a drift (orchard_keyframes.h), then its revisits looked for in each way and registered in each way,
// so that nothing else differs. Prints a JSON object with a row per way: what the search proposes and how much of it is
// right, what registration accepts, and what the graph keeps: loops found, right by place, true by pose, recall, and
// RMSE and SD of the keyframes' trajectory (SPEC D 16, 17). `registrations=` leaves it at the search. With `out`,
// writes reference.tum and for each row NAME.tum and NAME-loops.csv, for `bole evaluate`. What orchard_tables.py runs.
// With `guess_errors`, N true revisits are registered from guesses that are so many metres and 5 deg off instead.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <random>
#include <sstream>

#include "evaluation/core/evaluate_loops.h"
#include "evaluation/core/evaluate_trajectory.h"
#include "io/core/scans/frame_source.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"
#include "slam/core/loops/loop_candidates.h"
#include "slam/core/loops/loop_registration.h"
#include "slam/core/loops/loops.h"
#include "slam/core/loops/pose_graph.h"
#include "slam/core/map/tum_poses.h"
#include "slam/orchard_keyframes.h"

namespace {

using namespace bole;
using Json = nlohmann::ordered_json;

struct Settings {
  std::string scan, out, path = "odometry";
  std::vector<std::string> searches{"radius", "single", "placed", "sequence"},
      registrations{"icp", "ndt_icp", "features"}, drifts{"0"}, guess_errors;
  std::size_t frames = 1000000, pairs = 12;
  unsigned drift_seed = 1;
  OptionSet options{option_table(static_cast<const slam::SlamOptions*>(nullptr))};
};

std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> out;
  std::istringstream in(list);
  for (std::string part; std::getline(in, part, ',');) out.push_back(part);
  return out;
}

Settings settings_of(int count, char** arguments) {
  Settings settings;
  settings.options.set_text("preset", "lego_loam");
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    const auto equals = word.find('=');
    const auto name = word.substr(0, equals), value = equals == std::string::npos ? "" : word.substr(equals + 1);
    if (equals == std::string::npos)
      settings.scan = word;
    else if (name == "frames")
      settings.frames = std::stoul(value);
    else if (name == "drift_seed")
      settings.drift_seed = static_cast<unsigned>(std::stoul(value));
    else if (name == "registrations")
      settings.registrations = parts_of(value);
    else if (name == "searches")
      settings.searches = parts_of(value);
    else if (name == "guess_errors")
      settings.guess_errors = parts_of(value);
    else if (name == "pairs")
      settings.pairs = std::stoul(value);
    else if (name == "drifts")
      settings.drifts = parts_of(value);
    else if (name == "path")
      settings.path = value;
    else if (name == "out")
      settings.out = value;
    else
      settings.options.set_text(name, value);
  }
  return settings;
}

Trajectory path_of(const std::vector<slam::Keyframe>& keyframes, const std::vector<Pose>& T_map_keyframe) {
  Trajectory out;
  for (std::size_t k = 0; k < keyframes.size(); ++k) out.poses.push_back({keyframes[k].time_s, T_map_keyframe[k]});
  return out;
}

std::vector<Pose> poses_of(const std::vector<slam::Keyframe>& keyframes) {
  std::vector<Pose> out;
  for (const auto& k : keyframes) out.push_back(k.T_map_keyframe);
  return out;
}

Table table_of(const std::vector<slam::Loop>& loops, const std::vector<slam::Keyframe>& keyframes) {
  std::map<std::string, std::vector<double>> columns;
  const std::array<const char*, 7> pose{"x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"};
  for (const auto* name : {"from_time_s", "to_time_s", "way_m", "correction_m", "overlap"}) columns[name];
  for (const auto* name : pose) columns[name];
  for (const auto& l : loops) {
    columns["from_time_s"].push_back(keyframes[l.from].time_s);
    columns["to_time_s"].push_back(keyframes[l.to].time_s);
    columns["way_m"].push_back(keyframes[l.to].travelled - keyframes[l.from].travelled);
    columns["correction_m"].push_back(l.correction);
    columns["overlap"].push_back(l.overlap);
    const Eigen::Quaterniond q(l.T_from_to.linear());
    const Eigen::Vector3d t = l.T_from_to.translation();
    const std::array<double, 7> values{t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
    for (std::size_t i = 0; i < pose.size(); ++i) columns[pose[i]].push_back(values[i]);
  }
  Table table;
  for (auto& [name, values] : columns) table.set(name, values);
  return table;
}

void add_summary(const Table& summary, const std::vector<std::string>& measures, Json& row) {
  const auto& names = summary.texts("measure");
  const auto values = summary.numbers("value");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::ranges::find(measures, names[i]) != measures.end())
      row[names[i]] = std::isfinite(values[i]) ? Json(values[i]) : Json(nullptr);
}

// What a search proposes, before anything is registered.
Json judged(const std::vector<slam::LoopCandidate>& candidates, const std::vector<slam::Keyframe>& keyframes,
            const Trajectory& truth) {
  std::vector<double> from_s, to_s;
  std::size_t opposite = 0, beside = 0, good_guesses = 0;
  for (const auto& c : candidates) {
    from_s.push_back(keyframes[c.from].time_s);
    to_s.push_back(keyframes[c.to].time_s);
    const Pose T_from = truth.at(from_s.back()), T_to = truth.at(to_s.back());
    const Pose T_from_to = T_from.inverse() * T_to, guess = keyframes[c.from].T_map_keyframe.inverse() * c.T_map_to;
    const double apart = T_from_to.translation().norm();
    if (apart > 3) continue;
    opposite += T_from_to.linear()(0, 0) < 0;
    beside += apart > 1.5;  // most likely in the next alley
    const Pose error = T_from_to.inverse() * guess;
    good_guesses += error.translation().norm() < 1 && Eigen::AngleAxisd(error.linear()).angle() < 0.17;
  }
  Table table;
  table.set("from_time_s", from_s);
  table.set("to_time_s", to_s);
  const auto found = evaluation::evaluate_loops(table, truth, {});
  Json row{{"proposed", found.found},
           {"proposed_right", found.right},
           {"of_these_opposite", opposite},
           {"of_these_beside", beside},
           {"guesses_within_1_m_10_deg", good_guesses}};
  add_summary(found.summary, {"loop_chances", "loop_recall"}, row);
  return row;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Pairs of true revisits spread evenly over the walk: (from, to), nearest of those within a metre and a half.
std::vector<std::pair<std::size_t, std::size_t>> true_revisits(const std::vector<slam::Keyframe>& keyframes,
                                                               const slam::SlamSettings& options,
                                                               std::size_t max_pairs) {
  std::vector<std::pair<std::size_t, std::size_t>> all, out;
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    double best_distance = 1.5;
    std::optional<std::size_t> from;
    for (std::size_t j = 0; j < k && keyframes[k].travelled - keyframes[j].travelled >= options.loop_path; ++j) {
      const double d = (keyframes[k].T_map_keyframe.translation() - keyframes[j].T_map_keyframe.translation()).norm();
      if (d < best_distance) {
        best_distance = d;
        from = j;
      }
    }
    if (from) all.emplace_back(*from, k);
  }
  for (std::size_t i = 0; i < std::min(max_pairs, all.size()); ++i)
    out.push_back(all[(2 * i + 1) * all.size() / (2 * std::min(max_pairs, all.size()))]);
  return out;
}

// How far registration brings a guess that is `guess_error_m` off in any direction on the ground and 5 deg in heading.
Json registered_from_afar(const Settings& settings, slam::SlamSettings options,
                          const std::vector<slam::Keyframe>& keyframes, const std::string& registration,
                          double guess_error_m) {
  options.loop_registration = choice_from_name<slam::LoopRegistrationKind>(registration);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-std::numbers::pi, std::numbers::pi);
  double squared = 0;
  std::vector<double> errors_m;
  std::size_t true_poses = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (const auto& [from, to] : true_revisits(keyframes, options, settings.pairs)) {
    const Pose& T_true = keyframes[to].T_map_keyframe;
    const double direction = any(random), turn = (any(random) > 0 ? 5 : -5) * std::numbers::pi / 180;
    Pose guess = T_true;
    guess.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix() * guess.linear();
    guess.translation() += guess_error_m * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0);
    const auto [first, last] = slam::stretch_about(keyframes, from, to, options);
    const Pose found = slam::LoopTarget(keyframes, first, last, options)
                           .registered(keyframes[to], guess, {})
                           .registration.motion.T_map_end;
    const Pose error = T_true.inverse() * found;
    errors_m.push_back(error.translation().norm());
    squared += error.translation().squaredNorm();
    true_poses += errors_m.back() <= 0.1 && Eigen::AngleAxisd(error.linear()).angle() <= std::numbers::pi / 180;
  }
  std::ranges::sort(errors_m);
  const auto n = static_cast<double>(errors_m.size());
  return {{"registration", registration},
          {"guess_error", guess_error_m},
          {"pairs", errors_m.size()},
          {"rmse", std::sqrt(squared / n)},
          {"median", errors_m[errors_m.size() / 2]},
          {"true_poses", true_poses},
          {"seconds", seconds_since(begin)}};
}

// Everything that is done with one path of keyframes.
class Experiment {
 public:
  Experiment(const Settings& settings, const slam::SlamSettings& options, const std::vector<slam::Keyframe>& keyframes,
             const Trajectory& truth, const std::string& drift)
      : settings_(settings), options_(options), keyframes_(keyframes), drift_(drift) {
    for (const auto& p : truth.poses)  // the part that was followed
      if (p.time_s <= keyframes.back().time_s + 0.05) driven_.poses.push_back(p);
    if (!settings.out.empty()) io::write_tum(std::filesystem::path(settings.out) / "reference.tum", driven_);
  }

  Json without_loops() const {
    Json row{{"drift", drift_}};
    judge(name("no_loops"), path_of(keyframes_, poses_of(keyframes_)), row);
    return row;
  }

  std::vector<Json> searched(const std::string& search) const {
    auto way = options_;
    const bool by_radius = search == "radius";
    way.loops = by_radius ? slam::LoopSource::odometry : slam::LoopSource::context;
    if (!by_radius) way.context_search = choice_from_name<slam::ContextSearchKind>(search);
    const auto begin = std::chrono::steady_clock::now();
    Json head{{"drift", drift_}, {"search", search}};
    head.update(judged(slam::find_loop_candidates(keyframes_, way, {}), keyframes_, driven_));
    head["search_seconds"] = seconds_since(begin);
    if (settings_.registrations.empty()) return {head};
    std::vector<Json> rows;
    for (const auto& registration : settings_.registrations) {
      way.loop_registration = choice_from_name<slam::LoopRegistrationKind>(registration);
      auto row = head;
      row["registration"] = registration;
      registered(name(search + "-" + registration), way, row);
      rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  std::string name(const std::string& of) const { return drift_ == "0" ? of : of + "-drift" + drift_; }

  void registered(const std::string& name, const slam::SlamSettings& way, Json& row) const {
    const std::vector<std::string> measures{
        "loops_found",           "loops_right",         "loops_wrong", "loop_precision",
        "loops_true_pose",       "loop_pose_precision", "loop_recall", "loop_shift_error_median",
        "loop_turn_error_median"};
    const auto begin = std::chrono::steady_clock::now();
    const auto found = slam::find_loops(keyframes_, way, {});
    const auto accepted = evaluation::evaluate_loops(table_of(found.loops, keyframes_), driven_, {});
    add_summary(accepted.summary, measures, row["accepted"]);
    const auto graph = slam::optimise_pose_graph(keyframes_, found.loops, {});
    const auto kept =
        evaluation::evaluate_loops(table_of(slam::kept_loops(found.loops, graph), keyframes_), driven_, {});
    add_summary(kept.summary, measures, row["kept"]);
    row["refused"] = std::ranges::count(graph.refused, 1);
    row["doubted"] = graph.doubted_loops;
    row["seconds"] = seconds_since(begin);
    if (!settings_.out.empty())
      io::write_table(std::filesystem::path(settings_.out) / (name + "-loops.csv"), kept.loops);
    judge(name, path_of(keyframes_, graph.T_map_keyframe), row);
  }

  void judge(const std::string& name, const Trajectory& path, Json& row) const {
    add_summary(evaluation::evaluate_trajectory(path, driven_, {}).summary,
                {"length", "ate_rmse", "ate_sd", "ate_mean", "ate_max", "end_error"}, row);
    if (!settings_.out.empty()) io::write_tum(std::filesystem::path(settings_.out) / (name + ".tum"), path);
  }

  const Settings& settings_;
  const slam::SlamSettings& options_;
  const std::vector<slam::Keyframe>& keyframes_;
  std::string drift_;
  Trajectory driven_;
};

}  // namespace

int main(int count, char** arguments) try {
  const auto settings = settings_of(count, arguments);
  namespace fs = std::filesystem;
  const auto options = slam::resolved(settings.options.as<slam::SlamOptions>());
  Trajectory truth;
  truth.poses = slam::read_tum_poses((fs::path(settings.scan).parent_path() / "trajectory.tum").string());
  const auto source = io::open_frame_source(settings.scan);
  const auto start = std::chrono::steady_clock::now();
  const auto straight = settings.path == "truth" ? true_keyframes(*source, options, truth, settings.frames)
                                                 : followed_keyframes(*source, options, settings.frames);
  if (!settings.out.empty()) fs::create_directories(settings.out);
  Json report{{"scan", settings.scan},
              {"frames", std::min(settings.frames, source->size())},
              {"keyframes", straight.size()},
              {"path", settings.path},
              {"seconds", seconds_since(start)}};
  for (const auto& error : settings.guess_errors)
    for (const auto& registration : settings.registrations) {
      report["from_afar"].push_back(registered_from_afar(settings, options, straight, registration, std::stod(error)));
      std::fprintf(stderr, "%s\n", report["from_afar"].back().dump().c_str());
    }
  for (const auto& drift : settings.guess_errors.empty() ? settings.drifts : std::vector<std::string>{}) {
    auto keyframes = straight;
    if (drift != "0") add_drift(keyframes, std::stod(drift), settings.drift_seed);
    const Experiment experiment(settings, options, keyframes, truth, drift);
    report["no_loops"].push_back(experiment.without_loops());
    std::fprintf(stderr, "%s\n", report["no_loops"].back().dump().c_str());
    for (const auto& search : settings.searches)
      for (const auto& row : experiment.searched(search)) {
        report["ways"].push_back(row);
        std::fprintf(stderr, "%s\n", row.dump().c_str());
      }
  }
  std::printf("%s\n", report.dump(1).c_str());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "orchard_loops: %s\n", error.what());
  return 1;
}
