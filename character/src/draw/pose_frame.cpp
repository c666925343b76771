// SPDX-License-Identifier: MIT
// Boxes of posed vertices, a ground's aside.
#include "sinew_character/draw/pose_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace sinew {
namespace {

constexpr float kRoom = 1.02f;  // around what is framed

// Vertices that a picture of the poses has to show: all but those of joints that stand still and reach farther than all that moves, such as a
// ground.
std::vector<size_t> framed_vertices(const Character& character, const std::vector<Character>& poses) {
  const size_t joints = character.joints.size(), vertices = character.vertices.size();
  std::vector<std::optional<Box>> boxes(joints);
  std::vector<uint8_t> moves(joints, 0);
  std::vector<size_t> leading(vertices, 0);  // the joint with the largest weight
  const float still = 1e-4f * box_of(character.vertices).longest_side();
  std::optional<Box> moving;
  const auto add = [](std::optional<Box>* box, const Vec3& p) {
    if (!*box) *box = Box{p, p};
    (*box)->add(p);
  };
  for (size_t v = 0; v < vertices; ++v) {
    const auto& row = character.influences[v];
    const auto most = std::max_element(row.begin(), row.end(),
                                       [](const Influence& a, const Influence& b) { return a.weight < b.weight; });
    leading[v] = most == row.end() ? 0 : most->joint;
    const Vec3& first = poses[0].vertices[v];
    add(&boxes[leading[v]], first);
    const bool moved = std::any_of(poses.begin(), poses.end(), [&](const Character& pose) {
      const Vec3& p = pose.vertices[v];
      return std::max({std::fabs(p.x - first.x), std::fabs(p.y - first.y), std::fabs(p.z - first.z)}) > still;
    });
    if (!moved) continue;
    moves[leading[v]] = 1;
    add(&moving, first);
  }
  std::vector<size_t> framed;
  for (size_t v = 0; v < vertices; ++v) {
    const size_t joint = leading[v];
    if (moves[joint] != 0 || !moving || boxes[joint]->longest_side() <= moving->longest_side()) framed.push_back(v);
  }
  return framed;
}

}  // namespace

PoseFrame frame_poses(const Character& character, const std::vector<Character>& poses, Axis up) {
  const std::vector<size_t> framed = framed_vertices(character, poses);
  PoseFrame frame;
  std::vector<Box> boxes;
  for (const Character& pose : poses) {
    Box box = {pose.vertices[framed[0]], pose.vertices[framed[0]]};
    for (const size_t v : framed) box.add(pose.vertices[v]);
    boxes.push_back(box);
  }
  Box whole = boxes[0];
  for (const Box& box : boxes) {
    whole.add(box.low);
    whole.add(box.high);
  }
  const auto height = [&](Vec3* p) -> float& { return up == Axis::kZ ? p->z : p->y; };
  for (Box& box : boxes) {
    height(&box.low) = height(&whole.low);
    height(&box.high) = height(&whole.high);
    frame.middles.push_back(
        {0.5f * (box.low.x + box.high.x), 0.5f * (box.low.y + box.high.y), 0.5f * (box.low.z + box.high.z)});
    // Seen from the side and a little from above.
    const float depth = up == Axis::kZ ? box.high.y - box.low.y : box.high.z - box.low.z;
    const float across = std::hypot(box.high.x - box.low.x, depth), along = height(&box.high) - height(&box.low);
    frame.radius = std::max({frame.radius, 0.5f * kRoom * across, 0.5f * kRoom * std::hypot(along, 0.5f * across)});
  }
  return frame;
}

}  // namespace sinew
