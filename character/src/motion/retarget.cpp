// SPDX-License-Identifier: MIT
// Views of motions for the engine, frame by frame.
#include "sinew_character/motion/retarget.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "motion/common_body.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/clips/builtin_motion.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

// A skeleton as arrays.
struct RigArrays {
  std::vector<float> positions;
  std::vector<int32_t> parents;

  explicit RigArrays(const std::vector<Joint>& joints) {
    for (const Joint& joint : joints) {
      positions.insert(positions.end(), {joint.position.x, joint.position.y, joint.position.z});
      parents.push_back(joint.parent);
    }
  }
  sinew_skeleton view(uint32_t up) const {
    sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
    skeleton.positions = positions.data();
    skeleton.parents = parents.data();
    skeleton.joint_count = static_cast<uint32_t>(parents.size());
    skeleton.up = up;
    return skeleton;
  }
};

// All frames of a clip, one behind the other.
struct FrameArrays {
  size_t joints;
  std::vector<float> rotations, translations;

  FrameArrays(size_t joint_count, size_t frames)
      : joints(joint_count), rotations(4 * joint_count * frames), translations(3 * joint_count * frames) {}
  float* rotations_at(size_t f) { return rotations.data() + 4 * joints * f; }
  float* translations_at(size_t f) { return translations.data() + 3 * joints * f; }
  void take(size_t f, const MotionFrame& frame) {
    for (size_t j = 0; j < joints; ++j) {
      for (size_t i = 0; i < 4; ++i) rotations_at(f)[4 * j + i] = static_cast<float>(frame.rotations[j][i]);
      for (size_t i = 0; i < 3; ++i) translations_at(f)[3 * j + i] = static_cast<float>(frame.translations[j][i]);
    }
  }
  MotionFrame frame(size_t f) {
    MotionFrame out;
    for (size_t j = 0; j < joints; ++j) {
      Quaternion q{};
      Point3 p{};
      for (size_t i = 0; i < 4; ++i) q[i] = static_cast<double>(rotations_at(f)[4 * j + i]);
      for (size_t i = 0; i < 3; ++i) p[i] = static_cast<double>(translations_at(f)[3 * j + i]);
      out.rotations.push_back(normalized(q));
      out.translations.push_back(p);
    }
    return out;
  }
};

}  // namespace

std::optional<Character> body_of_motion(const std::string& path) {
  if (is_motion_alone(path) || is_builtin_motion(path)) return std::nullopt;
  try {
    return read_mesh(path);
  } catch (const Error&) {  // a skeleton alone
    return std::nullopt;
  }
}

void Retargeter::check(sinew_status status) const {
  if (status != SINEW_OK) throw Error(name_ + ": cannot retarget the motion: " + sinew_status_text(status));
}

Retargeter::Retargeter(const Motion& source, const std::vector<Joint>& target, const std::vector<int>& map,
                       const std::vector<uint8_t>& classes, const RetargetSettings& settings, UpAxes up)
    : name_(source.name),
      source_count_(source.joints.size()),
      target_count_(target.size()),
      source_joints_(rest_joints(source)),
      target_joints_(target),
      settings_(settings),
      up_(up),
      classes_(classes),
      map_(map) {
  const RigArrays from(source_joints_), to(target);
  const sinew_skeleton source_rig = from.view(up.source), target_rig = to.view(up.target);
  size_t bytes = 0;
  check(sinew_retarget_create_workspace_size(source_rig.joint_count, target_rig.joint_count, &bytes));
  check(memory_.reserve(bytes) ? SINEW_OK : SINEW_ERROR_WORKSPACE);
  check(sinew_retarget_create(&source_rig, &target_rig, map.data(), classes.data(), &settings, memory_.data(),
                              memory_.size(), &plan_));
}

Retargeter::Body Retargeter::body_of(const Character& character, const std::vector<uint32_t>& vertices) {
  const SkinArrays rows = skin_arrays(character);
  Body body;
  body.slots = rows.influences;
  for (const uint32_t v : vertices) {
    const Vec3& p = character.vertices[v];
    body.positions.insert(body.positions.end(), {p.x, p.y, p.z});
    const size_t first = size_t{v} * body.slots;
    for (size_t i = first; i < first + body.slots; ++i) {
      body.joints.push_back(rows.joints[i]);
      body.weights.push_back(i == first && rows.weights[i] == 0 ? 65535
                                                                : rows.weights[i]);  // the engine wants a full row
    }
  }
  return body;
}

sinew_motion_body Retargeter::view(const Body& body) const {
  return {body.positions.data(),
          triangles_.data(),
          {body.joints.data(), body.weights.data(), body.slots, SINEW_WEIGHT_UNORM16},
          static_cast<uint32_t>(body.positions.size() / 3),
          static_cast<uint32_t>(triangles_.size() / 3)};
}

size_t Retargeter::take_bodies(const Character& target, const Character* source) {
  CommonBody common;
  if (source != nullptr && source->influences.size() == source->vertices.size()) common = common_body(target, *source);
  constexpr size_t kFewest = 100;  // triangles that could be a body
  has_source_ = common.triangles.size() >= 3 * kFewest;
  const size_t shared = has_source_ ? common.triangles.size() / 3 : 0;
  if (has_source_) source_body_ = body_of(*source, common.second);
  if (!has_source_) common = common_body(target, target);
  std::vector<bool> in_hand;
  for (size_t j = 0; j < target.joints.size(); ++j) {
    int at = static_cast<int>(j);
    while (at >= 0 && classes_[static_cast<size_t>(at)] != SINEW_CLASS_HAND)
      at = target.joints[static_cast<size_t>(at)].parent;
    in_hand.push_back(at >= 0);
  }
  keep_skin(target, in_hand, &common);
  vertices_ = common.first;
  target_body_ = body_of(target, vertices_);
  triangles_ = std::move(common.triangles);
  return shared;
}

void Retargeter::keep_contacts() { method_ = Method::kContacts; }

void Retargeter::play_as_stream() { method_ = Method::kStream; }

void Retargeter::stream_clip(const sinew_motion_clip& whole, float fps) const {
  const RigArrays from(source_joints_), to(target_joints_);
  const sinew_skeleton source_rig = from.view(up_.source), target_rig = to.view(up_.target);
  const sinew_motion_body body = view(target_body_), source = view(source_body_);
  const bool has_body = body.vertex_count > 0;
  sinew_retarget_stream_options options = SINEW_INIT(sinew_retarget_stream_options);
  options.fps = fps;
  if (!range_) options.without = SINEW_WITHOUT_RANGE;
  options.source = has_source_ ? &source : nullptr;
  size_t bytes = 0;
  Workspace room;
  check(sinew_retarget_stream_workspace_size(source_rig.joint_count, target_rig.joint_count, body.vertex_count,
                                             body.triangle_count, &bytes));
  check(room.reserve(bytes) ? SINEW_OK : SINEW_ERROR_WORKSPACE);
  sinew_retarget_stream* stream = nullptr;
  check(sinew_retarget_stream_create(&source_rig, &target_rig, map_.data(), classes_.data(), &settings_,
                                     has_body ? &body : nullptr, &options, room.data(), room.size(), &stream));
  for (size_t f = 0; f < whole.frame_count; ++f) {
    const size_t s = source_count_ * f, t = target_count_ * f;
    check(sinew_retarget_stream_frame(stream, whole.source_rotations + 4 * s, whole.source_translations + 3 * s,
                                      whole.rotations + 4 * t, whole.translations + 3 * t));
  }
}

// The source in the target's vertices: every one the point of the source's surface at the same spot of the body.
bool Retargeter::take_corresponding(const Character& target, const Character& source) {
  const EngineViews from(source, {}), to(target, {});
  const SkinArrays rows = skin_arrays(source);
  std::vector<int32_t> joint_map(source.joints.size(), -1);
  for (size_t t = map_.size(); t-- > 0;)
    if (map_[t] >= 0 && static_cast<size_t>(map_[t]) < joint_map.size())
      joint_map[static_cast<size_t>(map_[t])] = static_cast<int32_t>(t);
  const sinew_bound_character bound = {&from.mesh,
                                       &from.skeleton,
                                       {rows.joints.data(), rows.weights.data(), rows.influences, SINEW_WEIGHT_UNORM16},
                                       joint_map.data()};
  size_t bytes = 0;
  Workspace room;
  std::vector<uint32_t> corners(3 * target.vertices.size());
  std::vector<float> shares(corners.size());
  if (sinew_corresponding_points_workspace_size(&bound, &to.mesh, &to.skeleton, &bytes) != SINEW_OK) return false;
  check(room.reserve(bytes) ? SINEW_OK : SINEW_ERROR_WORKSPACE);
  if (sinew_corresponding_points(&bound, &to.mesh, &to.skeleton, room.data(), room.size(), corners.data(),
                                 shares.data()) != SINEW_OK)
    return false;
  Character points;
  points.name = source.name;
  points.joints = source.joints;
  for (size_t k = 0; k < corners.size(); k += 3) {
    Vec3 position = {0, 0, 0};
    std::map<uint32_t, float> sums;
    for (size_t c = k; c < k + 3; ++c) {
      const Vec3& p = source.vertices[corners[c]];
      position = {position.x + shares[c] * p.x, position.y + shares[c] * p.y, position.z + shares[c] * p.z};
      for (const Influence& one : source.influences[corners[c]]) sums[one.joint] += shares[c] * one.weight;
    }
    points.vertices.push_back(position);
    points.influences.emplace_back();
    for (const auto& [joint, weight] : sums) points.influences.back().push_back({joint, weight});
  }
  source_body_ = body_of(points, vertices_);
  return true;
}

Retargeter::PointsOf Retargeter::follow_reference_points(const sinew_reference_options& settings,
                                                         const Character& target, const Character* source) {
  method_ = Method::kReferencePoints;
  reference_ = settings;
  if (has_source_) return PointsOf::kOneMesh;
  if (source == nullptr || source->influences.size() != source->vertices.size() || triangles_.empty())
    return PointsOf::kCapsules;
  has_source_ = take_corresponding(target, *source);
  return has_source_ ? PointsOf::kTwoMeshes : PointsOf::kCapsules;
}

Clip Retargeter::run(const Clip& clip, const std::function<bool()>& keep_going, ClipReport* report) {
  const size_t frames = clip.frames.size();
  FrameArrays from(source_count_, frames), to(target_count_, frames);
  std::vector<float> heights(frames);
  for (size_t f = 0; f < frames; ++f) {
    from.take(f, clip.frames[f]);
    check(sinew_retarget_height(plan_, from.rotations_at(f), from.translations_at(f), &heights[f]));
  }
  float ground = 0;
  check(sinew_retarget_ground(plan_, heights.data(), heights.size(), &ground));
  const auto go_on = [&] {
    if (keep_going && !keep_going()) throw Error(name_ + ": the job was interrupted");
  };
  for (size_t f = 0; f < frames; ++f) {
    go_on();
    check(sinew_retarget_frame(plan_, from.rotations_at(f), from.translations_at(f), ground, to.rotations_at(f),
                               to.translations_at(f)));
  }
  const sinew_motion_clip whole = {from.rotations.data(),  from.translations.data(),      to.rotations.data(),
                                   to.translations.data(), static_cast<uint32_t>(frames), ground};
  const sinew_motion_body target = view(target_body_), source = view(source_body_);
  const sinew_motion_body* const from_body = has_source_ ? &source : nullptr;
  const bool has_body = target.vertex_count > 0;
  ContactSettings settings;
  settings.fps = static_cast<float>(1 / clip.frame_time);
  size_t bytes = 0;
  if (has_body) {
    check(sinew_retarget_contacts_workspace_size(plan_, &target, whole.frame_count, &bytes));
    check(workspace_.reserve(bytes) ? SINEW_OK : SINEW_ERROR_WORKSPACE);
  }
  const auto measure = [&](std::vector<sinew_limb_quality>* limbs) {
    uint32_t count = 0;
    limbs->resize(SINEW_MAX_MOTION_LIMBS);
    if (has_body) {
      report->spots.resize(frames * SINEW_MAX_MOTION_LIMBS);
      check(sinew_retarget_spots(plan_, from_body, &target, &whole, &settings, workspace_.data(), workspace_.size(),
                                 limbs->data(), &count, report->spots.data()));
    }
    limbs->resize(count);
  };
  if (report != nullptr) measure(&report->before);
  if (method_ == Method::kStream) stream_clip(whole, settings.fps);
  if (range_ && method_ != Method::kStream && has_body)
    check(sinew_retarget_keep_range(plan_, &target, &whole, workspace_.data(), workspace_.size()));
  if (method_ == Method::kContacts && has_body)
    check(sinew_retarget_contacts(plan_, from_body, &target, &whole, &settings, workspace_.data(), workspace_.size()));
  if (method_ == Method::kReferencePoints && has_body) {
    Workspace room;
    check(sinew_retarget_reference_points_workspace_size(plan_, &target, &bytes));
    check(room.reserve(bytes) ? SINEW_OK : SINEW_ERROR_WORKSPACE);
    check(sinew_retarget_reference_points(plan_, from_body, &target, &whole, &reference_, room.data(), room.size()));
  }
  if (!limits_.empty())
    check(sinew_keep_joint_limits(limits_.data(), static_cast<uint32_t>(limits_.size()),
                                  static_cast<uint32_t>(target_count_), whole.frame_count, to.rotations.data()));
  if (report != nullptr) measure(&report->after);
  go_on();
  Clip out = {clip.name, clip.frame_time, {}};
  for (size_t f = 0; f < frames; ++f) out.frames.push_back(to.frame(f));
  return out;
}

}  // namespace sinew
