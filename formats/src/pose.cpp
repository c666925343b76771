// SPDX-License-Identifier: MIT
// Palettes of random and of given poses, and posed characters; the skinning itself is the engine's.
#include "sinew_formats/pose.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "numpy_random.hpp"
#include "sinew/sinew.h"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

using Mat33 = std::array<double, 9>;
using Point = std::array<double, 3>;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

// Joint indices, every parent before its children. Throws when the hierarchy has a cycle or a parent that does not
// exist.
std::vector<size_t> parents_first(const Character& character) {
  const size_t joint_count = character.joints.size();
  std::vector<std::vector<size_t>> children(joint_count);
  std::vector<size_t> order;
  order.reserve(joint_count);
  for (size_t j = 0; j < joint_count; ++j) {
    const int parent = character.joints[j].parent;
    if (parent >= static_cast<int>(joint_count)) {
      throw Error(character.name + ": joint '" + character.joints[j].name + "' names parent " + std::to_string(parent) +
                  ", but there are " + std::to_string(joint_count) + " joints");
    }
    if (parent < 0) {
      order.push_back(j);
    } else {
      children[static_cast<size_t>(parent)].push_back(j);
    }
  }
  for (size_t next = 0; next < order.size(); ++next) {
    const std::vector<size_t>& below = children[order[next]];
    order.insert(order.end(), below.begin(), below.end());
  }
  if (order.size() != joint_count) {
    throw Error(character.name + ": the joint parents form a cycle (" + std::to_string(joint_count - order.size()) +
                " joints hang on it); give every joint a way to a root");
  }
  return order;
}

Mat33 product(const Mat33& a, const Mat33& b) {
  Mat33 c{};
  for (size_t r = 0; r < 3; ++r)
    for (size_t k = 0; k < 3; ++k)
      for (size_t n = 0; n < 3; ++n) c[3 * r + n] += a[3 * r + k] * b[3 * k + n];
  return c;
}

Mat34 product(const Mat34& a, const Mat34& b) {
  Mat34 c{};
  for (size_t r = 0; r < 3; ++r) {
    for (size_t n = 0; n < 4; ++n) {
      for (size_t k = 0; k < 3; ++k) c[4 * r + n] += a[4 * r + k] * b[4 * k + n];
    }
    c[4 * r + 3] += a[4 * r + 3];
  }
  return c;
}

// Rodrigues: I + sin(t) K + (1 - cos(t)) K^2 for a unit axis.
Mat33 axis_rotation(const Point& axis, double angle) {
  const Mat33 k = {0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0};
  const Mat33 kk = product(k, k);
  Mat33 r = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (size_t i = 0; i < 9; ++i) r[i] += std::sin(angle) * k[i] + (1 - std::cos(angle)) * kk[i];
  return r;
}

Mat34 turn_about(const Mat33& r, const Point& centre) {
  Mat34 m{};
  for (size_t i = 0; i < 3; ++i) {
    m[4 * i + 3] = centre[i];
    for (size_t k = 0; k < 3; ++k) {
      m[4 * i + k] = r[3 * i + k];
      m[4 * i + 3] -= r[3 * i + k] * centre[k];
    }
  }
  return m;
}

Point transform(const Mat34& m, const Vec3& p) {
  Point out{};
  for (size_t i = 0; i < 3; ++i) {
    out[i] = m[4 * i] * static_cast<double>(p.x) + m[4 * i + 1] * static_cast<double>(p.y) +
             m[4 * i + 2] * static_cast<double>(p.z) + m[4 * i + 3];
  }
  return out;
}

Vec3 to_vec3(const Point& p) { return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}; }

Point rest_position(const Joint& joint) {
  return {static_cast<double>(joint.position.x), static_cast<double>(joint.position.y),
          static_cast<double>(joint.position.z)};
}

// One row for the C API: the strongest `slots` influences as unorm16 with sum 65535. The rounding remainder (at most
// half a step per slot) goes to the largest, which holds at least 65535 / 12. Returns false for a row without weight.
bool quantise_row(const std::vector<Influence>& row, size_t slots, uint16_t* joints, uint16_t* weights) {
  std::vector<Influence> kept;
  for (const Influence& influence : row)
    if (influence.weight > 0) kept.push_back(influence);
  std::stable_sort(kept.begin(), kept.end(),
                   [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  if (kept.size() > slots) kept.resize(slots);
  double sum = 0;
  for (const Influence& influence : kept) sum += static_cast<double>(influence.weight);
  if (kept.empty() || !std::isfinite(sum)) return false;
  int remainder = 65535;
  for (size_t s = 0; s < kept.size(); ++s) {
    const double share = static_cast<double>(kept[s].weight) / sum;
    joints[s] = static_cast<uint16_t>(kept[s].joint);
    weights[s] = static_cast<uint16_t>(std::lround(share * 65535));
    remainder -= weights[s];
  }
  weights[0] = static_cast<uint16_t>(weights[0] + remainder);
  return true;
}

}  // namespace

std::vector<std::vector<Mat34>> random_poses(const Character& character, const std::string& name,
                                             const std::vector<std::array<double, 3>>& positions, int poses) {
  constexpr double low_limit = 30, high_limit = 60;
  const size_t joint_count = character.joints.size();
  const size_t pose_count = poses > 0 ? static_cast<size_t>(poses) : 0;
  if (positions.size() != joint_count) {
    throw Error(name + ": random poses need one position per joint, expected " + std::to_string(joint_count) +
                ", found " + std::to_string(positions.size()));
  }
  const std::vector<size_t> order = parents_first(character);

  const auto* bytes = reinterpret_cast<const Bytef*>(name.data());
  NumpyRandom random(static_cast<uint64_t>(crc32(crc32(0, nullptr, 0), bytes, static_cast<uInt>(name.size()))));

  // The draws go joint by joint in the order of names, so that the order of joints in the file does not change the
  // poses. Bytes of UTF-8 sort like code points.
  std::vector<size_t> by_name(joint_count);
  for (size_t j = 0; j < joint_count; ++j) by_name[j] = j;
  std::stable_sort(by_name.begin(), by_name.end(),
                   [&](size_t a, size_t b) { return character.joints[a].name < character.joints[b].name; });
  std::vector<std::vector<Mat33>> turns(pose_count, std::vector<Mat33>(joint_count));
  std::vector<Point> axes(pose_count);
  for (size_t j : by_name) {
    for (Point& axis : axes) {
      for (double& x : axis) x = random.normal();
      const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
      for (double& x : axis) x /= length;
    }
    for (size_t k = 0; k < pose_count; ++k) {
      // np.linspace(30, 60, poses); a single pose takes the wide end.
      const double limit =
          k + 1 == pose_count
              ? high_limit
              : static_cast<double>(k) * ((high_limit - low_limit) / static_cast<double>(pose_count - 1)) + low_limit;
      const double angle = random.uniform(-1, 1) * (limit * kRadiansPerDegree);
      turns[k][j] = axis_rotation(axes[k], character.joints[j].parent < 0 ? 0 : angle);
    }
  }

  std::vector<std::vector<Mat34>> result(pose_count, std::vector<Mat34>(joint_count));
  for (size_t k = 0; k < pose_count; ++k) {
    for (size_t j : order) {
      const Mat34 local = turn_about(turns[k][j], positions[j]);
      const int parent = character.joints[j].parent;
      result[k][j] = parent < 0 ? local : product(result[k][static_cast<size_t>(parent)], local);
    }
  }
  return result;
}

std::vector<Mat34> pose_palette(const Character& character, const std::vector<JointTurn>& turns) {
  const std::vector<size_t> order = parents_first(character);
  std::vector<Mat33> local(character.joints.size(), Mat33{1, 0, 0, 0, 1, 0, 0, 0, 1});
  for (const JointTurn& turn : turns) {
    if (turn.joint >= character.joints.size()) {
      throw Error(character.name + ": a pose turns joint " + std::to_string(turn.joint) + ", but there are " +
                  std::to_string(character.joints.size()) + " joints");
    }
    const Mat33 rx = axis_rotation({1, 0, 0}, turn.x * kRadiansPerDegree);
    const Mat33 ry = axis_rotation({0, 1, 0}, turn.y * kRadiansPerDegree);
    const Mat33 rz = axis_rotation({0, 0, 1}, turn.z * kRadiansPerDegree);
    local[turn.joint] = product(product(rz, product(ry, rx)), local[turn.joint]);
  }
  std::vector<Mat34> palette(character.joints.size());
  for (size_t j : order) {
    const Mat34 m = turn_about(local[j], rest_position(character.joints[j]));
    const int parent = character.joints[j].parent;
    palette[j] = parent < 0 ? m : product(palette[static_cast<size_t>(parent)], m);
  }
  return palette;
}

Character apply_pose(const Character& character, const std::vector<Mat34>& palette, bool dual_quaternion) {
  const size_t vertex_count = character.vertices.size(), joint_count = character.joints.size();
  if (character.influences.size() != vertex_count) {
    throw Error(character.name + ": posing needs weights for each of its " + std::to_string(vertex_count) +
                " vertices, found " + std::to_string(character.influences.size()) + " rows; bind it first");
  }
  if (palette.size() != joint_count) {
    throw Error(character.name + ": a pose needs one matrix per joint, expected " + std::to_string(joint_count) +
                ", found " + std::to_string(palette.size()));
  }
  size_t slots = 1;
  for (size_t v = 0; v < vertex_count; ++v) {
    for (const Influence& influence : character.influences[v]) {
      if (influence.joint >= joint_count) {
        throw Error(character.name + ": vertex " + std::to_string(v) + " is bound to joint " +
                    std::to_string(influence.joint) + ", but there are " + std::to_string(joint_count) + " joints");
      }
    }
    slots = std::max(slots, character.influences[v].size());
  }
  slots = std::min<size_t>(slots, SINEW_MAX_INFLUENCES);

  std::vector<uint16_t> joints(vertex_count * slots, 0), weights(vertex_count * slots, 0);
  std::vector<uint8_t> bound(vertex_count, 1);
  for (size_t v = 0; v < vertex_count; ++v) {
    uint16_t* row_weights = weights.data() + v * slots;
    if (!quantise_row(character.influences[v], slots, joints.data() + v * slots, row_weights)) {
      bound[v] = 0;
      row_weights[0] = 65535;  // the API wants a full row; the vertex is put back below
    }
  }
  std::vector<float> positions;
  positions.reserve(3 * vertex_count);
  for (const Vec3& p : character.vertices) positions.insert(positions.end(), {p.x, p.y, p.z});
  std::vector<float> matrices;
  matrices.reserve(12 * joint_count);
  for (const Mat34& m : palette)
    for (double x : m) matrices.push_back(static_cast<float>(x));

  std::vector<float> moved(positions.size());
  const auto skin = dual_quaternion ? sinew_skin_dual_quaternion : sinew_skin_linear;
  const sinew_status status =
      skin(positions.data(), static_cast<uint32_t>(vertex_count), joints.data(), weights.data(),
           static_cast<uint32_t>(slots), matrices.data(), static_cast<uint32_t>(joint_count), moved.data());
  if (status != SINEW_OK) throw Error(character.name + ": posing failed: " + sinew_status_text(status));

  Character posed = character;
  for (size_t v = 0; v < vertex_count; ++v)
    if (bound[v]) posed.vertices[v] = {moved[3 * v], moved[3 * v + 1], moved[3 * v + 2]};
  for (size_t j = 0; j < joint_count; ++j)
    posed.joints[j].position = to_vec3(transform(palette[j], character.joints[j].position));
  // Both belong to the rest pose: normals would shade wrongly, and the glTF source holds the rest positions.
  posed.corner_normals.clear();
  posed.gltf.reset();
  return posed;
}

}  // namespace sinew
