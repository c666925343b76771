// SPDX-License-Identifier: MIT
// Augmentation: changed copies of a training character. One human in 165 variants teaches little; what is the same
// under turning, mirroring, stretching and another density is worth learning.
#include "augment.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "random.hpp"
#include "sinew_formats/dataset.hpp"

namespace sinew {
namespace {

constexpr double kVertexJitter = 0.001, kJointJitter = 0.006;  // of the longest side, standard deviation
constexpr double kStretch = 0.15;

uint64_t position_seed(const Vec3& p, uint64_t seed) {
  const uint64_t xy = uint64_t{std::bit_cast<uint32_t>(p.x)} << 32 | std::bit_cast<uint32_t>(p.y);
  return mix_seeds(seed, xy, std::bit_cast<uint32_t>(p.z));
}

// The draw depends on the position alone, so that seams and coincident joints do not come apart.
Vec3 jittered(const Vec3& p, double amount, uint64_t seed) {
  Random random(position_seed(p, seed));
  return {static_cast<float>(p.x + amount * random.normal()), static_cast<float>(p.y + amount * random.normal()),
          static_cast<float>(p.z + amount * random.normal())};
}

double longest_side(const Character& character) {
  Vec3 low = character.vertices[0], high = low;
  for (const Vec3& p : character.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

}  // namespace

Character augment(const Character& character, uint64_t seed) {
  Random random(mix_seeds(seed, 0x617567));
  const bool mirror = random.uniform() < 0.5;
  const double angle = random.uniform(0, 6.283185307179586);
  double stretch[3];
  for (double& s : stretch) s = random.uniform(1 - kStretch, 1 + kStretch);
  const bool thin = random.uniform() < 0.4;
  const double ratio = random.uniform(0.4, 0.9);

  Character out;
  out.name = character.name;
  out.vertices = character.vertices;
  out.face_offsets = character.face_offsets;
  out.face_vertices = character.face_vertices;
  out.joints = character.joints;
  out.influences = character.influences;
  if (out.vertices.empty()) return out;
  // A mesh of a few hundred vertices has none to spare.
  if (thin && out.vertices.size() > 400 && out.face_count() > 0) out = decimate(out, ratio);

  const double side = longest_side(out);
  const double c = std::cos(angle), s = std::sin(angle);
  const auto moved = [&](Vec3 p, double jitter, uint64_t jitter_seed) {
    p = jittered(p, jitter * side, jitter_seed);
    const double x = (mirror ? -1 : 1) * stretch[0] * static_cast<double>(p.x),
                 z = stretch[2] * static_cast<double>(p.z);
    return Vec3{static_cast<float>(c * x + s * z), static_cast<float>(stretch[1] * static_cast<double>(p.y)),
                static_cast<float>(c * z - s * x)};
  };
  const uint64_t vertex_seed = random.next(), joint_seed = random.next();
  for (Vec3& p : out.vertices) p = moved(p, kVertexJitter, vertex_seed);
  for (Joint& joint : out.joints) joint.position = moved(joint.position, kJointJitter, joint_seed);
  if (mirror) {
    for (size_t f = 0; f < out.face_count(); ++f) {
      std::reverse(out.face_vertices.begin() + out.face_offsets[f],
                   out.face_vertices.begin() + out.face_offsets[f + 1]);
    }
  }
  return out;
}

}  // namespace sinew
