#include "slam/core/loops/loop_tables.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/angles.h"
#include "base/option.h"
#include "cloud/table_columns.h"

namespace bole::slam {
namespace {

// The one of the two quaternions of a rotation that has a positive scalar part.
Eigen::Quaterniond upright(Eigen::Quaterniond q) {
  if (q.w() < 0) q.coeffs() *= -1;
  return q;
}

constexpr std::array<const char*, 7> pose_columns{"x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"};

class PoseColumns {
 public:
  void add(const Pose& T) {
    const Eigen::Quaterniond q = upright(Eigen::Quaterniond(T.linear()));
    for (std::size_t i = 0; i < 3; ++i) values_[i].push_back(T.translation()[static_cast<Eigen::Index>(i)]);
    for (std::size_t i = 0; i < 4; ++i) values_[3 + i].push_back(q.coeffs()[static_cast<Eigen::Index>(i)]);
  }
  void write(Table& t) const {
    for (std::size_t i = 0; i < values_.size(); ++i) t.set(pose_columns[i], values_[i]);
  }

 private:
  std::array<std::vector<double>, 7> values_;
};

std::vector<Pose> read_poses(const Table& t, const std::string& name) {
  std::array<std::vector<double>, 7> v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = t.numbers(pose_columns[i]);
  std::vector<Pose> out;
  for (std::size_t r = 0; r < t.rows(); ++r) {
    const Eigen::Quaterniond q(v[6][r], v[3][r], v[4][r], v[5][r]);
    const Eigen::Vector3d at(v[0][r], v[1][r], v[2][r]);
    if (!at.allFinite() || !(std::abs(q.norm() - 1) < 0.01))
      throw bad_input("row " + std::to_string(r + 1) + " of the table " + name + " has no pose",
                      "numbers in x_m, y_m, z_m, and a quaternion of length 1 in qx, qy, qz, qw");
    Pose T = Pose::Identity();
    T.linear() = q.normalized().toRotationMatrix();
    T.translation() = at;
    out.push_back(T);
  }
  return out;
}

std::int64_t whole(std::size_t i) { return static_cast<std::int64_t>(i); }

// Columns of the two ends of a loop or edge.
class EndColumns {
 public:
  EndColumns(const std::vector<Keyframe>& keyframes, const std::vector<std::size_t>& frame_of_keyframe)
      : keyframes_(keyframes), frames_(frame_of_keyframe) {}
  void add(std::size_t from, std::size_t to) {
    from_.push_back(whole(from));
    to_.push_back(whole(to));
    from_frame_.push_back(whole(frames_[from]));
    to_frame_.push_back(whole(frames_[to]));
    from_s_.push_back(keyframes_[from].time_s);
    to_s_.push_back(keyframes_[to].time_s);
  }
  void write(Table& t) const {
    t.set("from_keyframe", from_);
    t.set("to_keyframe", to_);
    t.set("from_frame", from_frame_);
    t.set("to_frame", to_frame_);
    t.set("from_time_s", from_s_);
    t.set("to_time_s", to_s_);
  }

 private:
  const std::vector<Keyframe>& keyframes_;
  const std::vector<std::size_t>& frames_;
  std::vector<std::int64_t> from_, to_, from_frame_, to_frame_;
  std::vector<double> from_s_, to_s_;
};

// How far the keyframes are from where a loop wants them.
Pose residual_of(const Loop& l, const std::vector<Pose>& T_map_keyframe) {
  return l.T_from_to.inverse() * (T_map_keyframe[l.from].inverse() * T_map_keyframe[l.to]);
}

// Distance travelled up to each frame.
std::vector<double> travelled(const std::vector<Pose>& T_map_frame) {
  std::vector<double> out;
  for (std::size_t k = 0; k < T_map_frame.size(); ++k)
    out.push_back(k ? out.back() + (T_map_frame[k].translation() - T_map_frame[k - 1].translation()).norm() : 0);
  return out;
}

std::vector<std::size_t> indices(const Table& t, const char* column, std::size_t end, const std::string& table) {
  std::vector<std::size_t> out;
  for (const auto v : t.integers(column)) {
    if (v < 0 || static_cast<std::size_t>(v) >= end)
      throw bad_input("the table " + table + " has " + std::string(column) + " " + std::to_string(v),
                      "a number from 0 to " + std::to_string(end == 0 ? 0 : end - 1),
                      "Use tables of one run of slam.run");
    out.push_back(static_cast<std::size_t>(v));
  }
  return out;
}

}  // namespace

Table loops_table(const std::vector<Loop>& loops, const std::vector<Keyframe>& keyframes) {
  std::vector<double> from_s, to_s, distance, correction, overlap;
  std::vector<std::string> found_by;
  PoseColumns poses;
  for (const auto& l : loops) {
    poses.add(l.T_from_to);
    from_s.push_back(keyframes[l.from].time_s);
    to_s.push_back(keyframes[l.to].time_s);
    distance.push_back(keyframes[l.to].travelled - keyframes[l.from].travelled);
    correction.push_back(l.correction);
    overlap.push_back(l.overlap);
    found_by.emplace_back(choice_name(l.found_by));
  }
  Table t;
  t.set("from_time_s", from_s);
  t.set("to_time_s", to_s);
  t.set("way_m", distance);
  t.set("correction_m", correction);
  t.set("overlap", overlap);
  t.set("found_by", found_by);
  poses.write(t);
  return t;
}

void add_odometry_poses(const std::vector<Pose>& T_map_frame, Table& odometry) {
  PoseColumns poses;
  for (const auto& T : T_map_frame) poses.add(T);
  odometry.set("travelled_m", travelled(T_map_frame));
  poses.write(odometry);
}

std::vector<JudgedLoop> judged(const std::vector<CheckedLoop>& checked, const PoseGraphResult* graph) {
  std::vector<JudgedLoop> out;
  std::size_t in_graph = 0;
  for (const auto& c : checked) {
    JudgedLoop j{c, c.accepted, c.reason, false};
    if (c.accepted && graph && graph->refused[in_graph++]) {
      j.accepted = false;
      if (!graph->solved) {
        j.reason = "the pose graph has no solution";
      } else {
        const Pose error = residual_of(c.loop, graph->T_map_keyframe);
        j.reason = "it contradicts the odometry and the other loop closures by " +
                   number_text(std::round(100 * error.translation().norm()) / 100) + " m and " +
                   number_text(std::round(10 * degrees(Eigen::AngleAxisd(error.linear()).angle())) / 10) + " deg";
      }
    }
    out.push_back(std::move(j));
  }
  return out;
}

Table candidates_table(const std::vector<JudgedLoop>& loops, const std::vector<Keyframe>& keyframes,
                       const std::vector<std::size_t>& frame_of_keyframe, const std::vector<Pose>& T_map_keyframe) {
  EndColumns ends(keyframes, frame_of_keyframe);
  PoseColumns poses;
  std::vector<std::string> found_by, verdict, reason, state;
  std::vector<double> score, way, correction, overlap, rms, conditioning, residual, residual_deg;
  std::vector<std::int64_t> verified;
  for (const auto& j : loops) {
    const auto& c = j.checked;
    const auto& l = c.loop;
    ends.add(l.from, l.to);
    poses.add(l.T_from_to);
    found_by.emplace_back(choice_name(l.found_by));
    score.push_back(c.score);
    way.push_back(keyframes[l.to].travelled - keyframes[l.from].travelled);
    correction.push_back(l.correction);
    overlap.push_back(l.overlap);
    rms.push_back(c.rms);
    conditioning.push_back(c.conditioning);
    verified.push_back(c.accepted);
    verdict.emplace_back(j.accepted ? "accepted" : "refused");
    reason.push_back(j.reason);
    state.emplace_back(j.edited ? "edited" : "auto");
    const Pose error = residual_of(l, T_map_keyframe);
    residual.push_back(error.translation().norm());
    residual_deg.push_back(degrees(Eigen::AngleAxisd(error.linear()).angle()));
  }
  Table t;
  ends.write(t);
  t.set("found_by", found_by);
  t.set("score", score);
  t.set("way_m", way);
  t.set("correction_m", correction);
  t.set("overlap", overlap);
  t.set("rms_m", rms);
  t.set("conditioning", conditioning);
  t.set("verified", verified);
  t.set("verdict", verdict);
  t.set("reason", reason);
  t.set("state", state);
  t.set("residual_m", residual);
  t.set("residual_deg", residual_deg);
  poses.write(t);
  return t;
}

Table graph_table(const std::vector<GraphEdge>& edges, const std::vector<Keyframe>& keyframes,
                  const std::vector<std::size_t>& frame_of_keyframe) {
  EndColumns ends(keyframes, frame_of_keyframe);
  std::vector<std::string> kind;
  std::vector<double> of_turn, of_shift, turn_deg, shift, sigmas, weight;
  for (const auto& e : edges) {
    ends.add(e.from, e.to);
    kind.emplace_back(e.loop ? "loop" : "odometry");
    of_turn.push_back(1 / (e.sigma_rad * e.sigma_rad));
    of_shift.push_back(1 / (e.sigma * e.sigma));
    turn_deg.push_back(degrees(e.turn_rad));
    shift.push_back(e.shift);
    sigmas.push_back(e.sigmas());
    weight.push_back(e.weight);
  }
  Table t;
  ends.write(t);
  t.set("kind", kind);
  t.set("information_turn", of_turn);
  t.set("information_shift", of_shift);
  t.set("residual_m", shift);
  t.set("residual_deg", turn_deg);
  t.set("residual_sigmas", sigmas);
  t.set("weight", weight);
  return t;
}

StoredGraph stored_graph(const Table& odometry, const Table& candidates) {
  StoredGraph out;
  if (odometry.rows() > 0 && !odometry.has("qw"))
    throw bad_input("the table odometry has no poses", "the table odometry of slam.run, with x_m to qw");
  if (odometry.rows() > 0) {
    out.frame = indices(odometry, "frame", std::numeric_limits<std::int32_t>::max(), "odometry");
    out.T_map_frame = read_poses(odometry, "odometry");
    const auto keyframe = indices(odometry, "keyframe", odometry.rows(), "odometry");
    const auto time_s = odometry.numbers("time_s");
    const auto way = travelled(out.T_map_frame);
    for (std::size_t i = 0; i < keyframe.size(); ++i) {
      if (keyframe[i] < out.keyframes.size()) continue;
      if (keyframe[i] > out.keyframes.size() || (!out.keyframes.empty() && !(time_s[i] > out.keyframes.back().time_s)))
        throw bad_input("the frames of the table odometry are out of order at row " + std::to_string(i + 1),
                        "a row per frame in order of time, as slam.run gives it");
      Keyframe k;
      k.frame = i;
      k.time_s = time_s[i];
      k.travelled = way[i];
      k.T_map_keyframe = out.T_map_frame[i];
      out.keyframes.push_back(std::move(k));
      out.frame_of_keyframe.push_back(out.frame[i]);
    }
  }
  if (candidates.rows() == 0) return out;
  const auto n = out.keyframes.size();
  const auto from = indices(candidates, "from_keyframe", n, "loop_candidates"),
             to = indices(candidates, "to_keyframe", n, "loop_candidates");
  const auto T_from_to = read_poses(candidates, "loop_candidates");
  const auto correction = candidates.numbers("correction_m"), overlap = candidates.numbers("overlap"),
             score = candidates.numbers("score"), rms = candidates.numbers("rms_m"),
             conditioning = candidates.numbers("conditioning");
  const auto verified = candidates.integers("verified");
  const auto &found_by = candidates.texts("found_by"), &verdict = candidates.texts("verdict"),
             &state = candidates.texts("state");
  const auto reason = texts_or_empty(candidates, "reason");
  for (std::size_t i = 0; i < candidates.rows(); ++i) {
    if (from[i] >= to[i])
      throw bad_input("row " + std::to_string(i + 1) + " of the table loop_candidates goes from keyframe " +
                          std::to_string(from[i]) + " to " + std::to_string(to[i]),
                      "an earlier and a later keyframe");
    JudgedLoop j;
    j.checked.loop.from = from[i];
    j.checked.loop.to = to[i];
    j.checked.loop.T_from_to = T_from_to[i];
    j.checked.loop.overlap = overlap[i];
    j.checked.loop.correction = correction[i];
    j.checked.loop.found_by = choice_from_name<FoundBy>(found_by[i]);
    j.checked.accepted = verified[i] != 0;
    j.checked.score = score[i];
    j.checked.rms = rms[i];
    j.checked.conditioning = conditioning[i];
    j.accepted = verdict[i] == "accepted";
    j.reason = reason[i];
    j.edited = state[i] == "edited";
    j.checked.loop.by_hand = j.edited && j.accepted;
    out.loops.push_back(std::move(j));
  }
  return out;
}

}  // namespace bole::slam
