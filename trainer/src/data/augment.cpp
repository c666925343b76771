// SPDX-License-Identifier: MIT
// Augmentation: changed copies of a training character. One human in 165 variants teaches little; what is the same
// under rotation, mirroring, stretching and another density is worth learning, and so are other skeletons and rest
// poses of the same body.
#include <algorithm>
#include <bit>
#include <cmath>

#include "core/random.hpp"
#include "data/sample_cache.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_data_sets/dataset.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

constexpr double kVertexJitter = 0.001, kJointJitter = 0.006;  // of the longest side, standard deviation
constexpr double kStretch = 0.2;

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

// Sum of reference weights per joint.
std::vector<double> joint_mass(const Character& character) {
  std::vector<double> mass(character.joints.size(), 0.0);
  for (const auto& row : character.influences) {
    for (const Influence& i : row) mass[i.joint] += static_cast<double>(i.weight);
  }
  return mass;
}

// Removes the marked joints; their weights go to the nearest ancestor that stays, their children too. A removed joint
// must have such an ancestor.
void remove_joints(Character* character, const std::vector<uint8_t>& removed) {
  const size_t count = character->joints.size();
  std::vector<int> heir(count), index(count, -1);
  for (size_t j = 0; j < count; ++j) {
    int at = static_cast<int>(j);
    while (removed[static_cast<size_t>(at)] != 0) at = character->joints[static_cast<size_t>(at)].parent;
    heir[j] = at;
  }
  std::vector<Joint> kept;
  for (size_t j = 0; j < count; ++j) {
    if (removed[j] != 0) continue;
    index[j] = static_cast<int>(kept.size());
    kept.push_back(character->joints[j]);
  }
  for (Joint& joint : kept) {
    if (joint.parent >= 0) joint.parent = index[static_cast<size_t>(heir[static_cast<size_t>(joint.parent)])];
  }
  for (auto& row : character->influences) {
    std::vector<Influence> merged;
    for (const Influence& i : row) {
      const auto joint = static_cast<uint32_t>(index[static_cast<size_t>(heir[i.joint])]);
      auto at = std::find_if(merged.begin(), merged.end(), [&](const Influence& m) { return m.joint == joint; });
      if (at == merged.end()) {
        merged.push_back({joint, i.weight});
      } else {
        at->weight += i.weight;
      }
    }
    row = std::move(merged);
  }
  character->joints = std::move(kept);
}

// Fewer joints: a share of those with a parent goes, or all end markers (leaves without weights).
void thin_skeleton(Character* character, Random* random) {
  const size_t count = character->joints.size();
  const std::vector<double> mass = joint_mass(*character);
  std::vector<uint8_t> leaf(count, 1), removed(count, 0);
  for (const Joint& joint : character->joints) {
    if (joint.parent >= 0) leaf[static_cast<size_t>(joint.parent)] = 0;
  }
  const bool ends = random->uniform() < 0.4;
  const double share = random->uniform() < 0.5 ? random->uniform(0.05, 0.3) : 0.0;
  size_t left = count;
  for (size_t j = 0; j < count; ++j) {
    const bool draw = random->uniform() < share;
    if (character->joints[j].parent < 0 || left <= 3) continue;
    if ((ends && leaf[j] != 0 && mass[j] <= 0) || draw) {
      removed[j] = 1;
      --left;
    }
  }
  if (left < count) remove_joints(character, removed);
}

// More joints, none of which deforms: a root on the floor, controls beside joints, ends of leaves.
void add_controls(Character* character, double side, Random* random) {
  const auto count = static_cast<uint32_t>(character->joints.size());
  const auto add = [&](const Vec3& position, int parent, const char* kind) {
    Joint joint;
    joint.name = std::string("sinew_") + kind + std::to_string(character->joints.size());
    joint.position = position;
    joint.parent = parent;
    character->joints.push_back(joint);
    return static_cast<int>(character->joints.size() - 1);
  };
  if (random->uniform() < 0.3) {
    std::vector<uint8_t> leaf(count, 1);
    for (uint32_t j = 0; j < count; ++j) {
      if (character->joints[j].parent >= 0) leaf[static_cast<size_t>(character->joints[j].parent)] = 0;
    }
    for (uint32_t j = 0; j < count; ++j) {
      const int parent = character->joints[j].parent;
      if (leaf[j] == 0 || parent < 0) continue;
      const Vec3 p = character->joints[j].position, q = character->joints[static_cast<size_t>(parent)].position;
      const float on = static_cast<float>(random->uniform(0.4, 1.0));
      add({p.x + on * (p.x - q.x), p.y + on * (p.y - q.y), p.z + on * (p.z - q.z)}, static_cast<int>(j), "end");
    }
  }
  if (random->uniform() < 0.3) {
    float low = character->vertices[0].y, x = 0, z = 0;
    for (const Vec3& p : character->vertices) low = std::min(low, p.y);
    for (uint32_t j = 0; j < count; ++j) {
      if (character->joints[j].parent < 0) x = character->joints[j].position.x, z = character->joints[j].position.z;
    }
    const int root = add({x, low, z}, -1, "root");
    for (uint32_t j = 0; j < count; ++j) {
      if (character->joints[j].parent < 0) character->joints[j].parent = root;
    }
  }
  if (random->uniform() < 0.25) {
    int root = 0;
    for (size_t j = 0; j < character->joints.size(); ++j) {
      if (character->joints[j].parent < 0) root = static_cast<int>(j);
    }
    for (uint32_t n = 1 + random->below(4); n > 0; --n) {
      const Vec3 p = character->joints[random->below(count)].position;
      add(jittered(p, 0.01 * side, random->next()), root, "control");
    }
  }
}

// Another rest pose: every joint rotates a little, the mesh follows its own weights.
void change_rest_pose(Character* character, Random* random) {
  const double amount = random->uniform(4, 16);  // degrees, standard deviation
  std::vector<JointRotation> turns;
  for (size_t j = 0; j < character->joints.size(); ++j) {
    if (character->joints[j].parent < 0) continue;
    const auto angle = [&] { return std::clamp(amount * random->normal(), -40.0, 40.0); };
    const double x = angle(), y = angle(), z = angle();
    turns.push_back({j, x, y, z});
  }
  *character = apply_pose(*character, pose_palette(*character, turns));
}

}  // namespace

Character augment(const Character& character, uint64_t seed) {
  Random random(mix_seeds(seed, 0x617567));
  const bool mirror = random.uniform() < 0.5;
  const double angle = random.uniform(0, 6.283185307179586);
  double stretch[3];
  for (double& s : stretch) s = random.uniform(1 - kStretch, 1 + kStretch);
  const double density = random.uniform();
  const bool thin = density<0.4, fine = density> 0.8;
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
  // Four times as many vertices take four times as long.
  if (fine && out.vertices.size() <= 1500) out = subdivide(out);

  if (random.uniform() < 0.5) thin_skeleton(&out, &random);
  if (random.uniform() < 0.4) change_rest_pose(&out, &random);
  const double side = box_of(out.vertices).longest_side();
  if (random.uniform() < 0.5) add_controls(&out, side, &random);
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
