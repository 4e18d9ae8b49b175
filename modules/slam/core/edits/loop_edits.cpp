#include "slam/core/edits/loop_edits.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"

namespace bole::slam {
namespace {

using Action = LoopEdit::Action;

// In the order of LoopEdit::Action.
const std::array<EditAction, 2>& actions() {
  static const std::array<EditAction, 2> table{{
      {"accept", {"from_frame", "to_frame"}, {"relative_pose"}},
      {"refuse", {"from_frame", "to_frame"}, {}},
  }};
  return table;
}

std::size_t frame_number(const EditJson& value, const std::string& key) {
  if (!value.is_number_integer()) throw bad_input(key + " is " + value.dump(), "the number of a frame, from 0 on");
  return static_cast<std::size_t>(edit_number(value, key, 0, 1e9));
}

Pose relative_pose(const EditJson& value) {
  const std::string key = "relative_pose";
  if (!value.is_array() || value.size() != 7)
    throw bad_input(key + " is " + value.dump(), "seven numbers: x, y, z in metres and qx, qy, qz, qw");
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = edit_number(value[i], key, i < 3 ? -1e5 : -1.1, i < 3 ? 1e5 : 1.1);
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (std::abs(q.norm() - 1) > 0.01)
    throw bad_input(key + " has a quaternion of length " + EditJson(q.norm()).dump(), "one of length 1");
  Pose T = Pose::Identity();
  T.linear() = q.normalized().toRotationMatrix();
  T.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  return T;
}

EditJson object_of(const LoopEdit& edit) {
  EditJson o{{"action", action_name(edit.action)}, {"from_frame", edit.from_frame}, {"to_frame", edit.to_frame}};
  if (edit.T_from_to) {
    const Eigen::Vector3d t = edit.T_from_to->translation();
    const Eigen::Quaterniond q(edit.T_from_to->linear());
    o["relative_pose"] = EditJson::array({t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()});
  }
  put_edit_record(o, edit);
  return o;
}

}  // namespace

std::string_view action_name(Action action) { return actions()[static_cast<std::size_t>(action)].name; }

std::vector<LoopEdit> parse_loop_edits(std::string_view text) {
  std::vector<LoopEdit> edits;
  read_edits(text, actions(), {}, [&](std::size_t action, const EditJson& object) {
    LoopEdit edit;
    edit.action = static_cast<Action>(action);
    static_cast<EditRecord&>(edit) = edit_record(object);
    edit.from_frame = frame_number(object["from_frame"], "from_frame");
    edit.to_frame = frame_number(object["to_frame"], "to_frame");
    if (object.contains("relative_pose")) edit.T_from_to = relative_pose(object["relative_pose"]);
    if (edit.from_frame == edit.to_frame)
      throw bad_input("from_frame and to_frame are both " + std::to_string(edit.to_frame), "two frames");
    if (edit.from_frame > edit.to_frame) {
      std::swap(edit.from_frame, edit.to_frame);
      if (edit.T_from_to) edit.T_from_to = edit.T_from_to->inverse();
    }
    edits.push_back(std::move(edit));
  });
  return edits;
}

std::string to_json(const std::vector<LoopEdit>& edits) {
  EditJson list = EditJson::array();
  for (const auto& edit : edits) list.push_back(object_of(edit));
  return list.dump(2);
}

}  // namespace bole::slam
