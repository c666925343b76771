// SPDX-License-Identifier: MIT
// Votes as a network would give them, from a skeleton that is known or from chance.
#ifndef SINEW_TESTS_SUPPORT_RIG_VOTES_HPP
#define SINEW_TESTS_SUPPORT_RIG_VOTES_HPP

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "arena_block.hpp"
#include "grid/grid_quantizer.hpp"
#include "random.hpp"
#include "rig/tree.hpp"

namespace sinew_test {

inline int32_t units(double share) { return static_cast<int32_t>(std::lround(share * sinew::kSide)); }
inline sinew::Vec3i grid_point(double x, double y, double z) { return {units(x), units(y), units(z)}; }

// Owns what Votes borrows.
struct VoteScene {
  std::vector<sinew::Vec3i> starts, ends;
  std::vector<uint16_t> start_spreads, end_spreads, start_classes, end_classes;
  bool folded = true;
  std::vector<sinew::Vec3i> inside;  // a position in the body for each point, or none

  // A row of probabilities: `share` for one class, the rest for all of them alike.
  static void add_row(std::vector<uint16_t>* rows, uint32_t classes, uint32_t joint_class, double share) {
    for (uint32_t c = 0; c < classes; ++c) {
      const double rest = (1 - share) / classes;
      rows->push_back(static_cast<uint16_t>(32768 * (c == joint_class ? share + rest : rest)));
    }
  }
  void add(sinew::Vec3i start, uint32_t start_class, sinew::Vec3i end, uint32_t end_class, double spread = 0.02,
           double share = 0.9) {
    starts.push_back(start);
    ends.push_back(end);
    start_spreads.push_back(static_cast<uint16_t>(spread * 65536));
    end_spreads.push_back(static_cast<uint16_t>(spread * 65536));
    add_row(&start_classes, sinew::rigging::kJointClasses, start_class, share);
    add_row(&end_classes, sinew::rigging::kEndClasses, end_class, share);
  }
  sinew::rigging::Votes votes() const {
    sinew::rigging::Votes v;
    v.points = static_cast<uint32_t>(starts.size());
    v.folded = folded;
    v.start = starts.data();
    v.end = ends.data();
    v.start_spread = start_spreads.data();
    v.end_spread = end_spreads.data();
    v.start_class = start_classes.data();
    v.end_class = end_classes.data();
    v.mean = grid_point(0, 0.5, 0.01);
    if (inside.size() == starts.size()) {
      v.inside = inside.data();
    }
    return v;
  }
  // The same points in another order.
  VoteScene shuffled(uint32_t seed) const {
    std::vector<size_t> order(starts.size());
    std::iota(order.begin(), order.end(), size_t{0});
    sinew::test::Random random(seed);
    for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(static_cast<uint32_t>(i))]);
    VoteScene scene;
    scene.folded = folded;
    for (const size_t i : order) {
      scene.starts.push_back(starts[i]);
      scene.ends.push_back(ends[i]);
      scene.start_spreads.push_back(start_spreads[i]);
      scene.end_spreads.push_back(end_spreads[i]);
      const auto row = [i](const std::vector<uint16_t>& from, size_t width, std::vector<uint16_t>* to) {
        to->insert(to->end(), from.begin() + static_cast<ptrdiff_t>(i * width),
                   from.begin() + static_cast<ptrdiff_t>((i + 1) * width));
      };
      row(start_classes, sinew::rigging::kJointClasses, &scene.start_classes);
      row(end_classes, sinew::rigging::kEndClasses, &scene.end_classes);
    }
    return scene;
  }
};

// A joint of a creature, on the plane or at +x for both sides. A bone end has the class kClassTip.
struct KnownJoint {
  double x, y, z;
  uint32_t joint_class;
  int parent;
};

inline std::vector<KnownJoint> known_humanoid() {
  using namespace sinew::rigging;
  return {{0, .52, 0, kClassPelvis, -1},    {0, .60, -.01, kClassSpine, 0},   {0, .70, -.02, kClassSpine, 1},
          {0, .82, 0, kClassNeck, 2},       {0, .88, .01, kClassHead, 3},     {0, .99, .01, kClassTip, 4},
          {.04, .79, 0, kClassClavicle, 2}, {.12, .79, 0, kClassUpperArm, 6}, {.27, .79, 0, kClassForearm, 7},
          {.42, .79, 0, kClassHand, 8},     {.49, .79, .01, kClassTip, 9},    {.07, .49, 0, kClassThigh, 0},
          {.07, .28, .01, kClassCalf, 11},  {.07, .07, 0, kClassFoot, 12},    {.07, .02, .09, kClassToe, 13},
          {.07, .02, .15, kClassTip, 14}};
}

// `each` points a bone and side; both ends are off by a Gaussian of `noise` along each axis.
inline VoteScene votes_for(const std::vector<KnownJoint>& joints, uint32_t each, double noise, uint32_t seed) {
  VoteScene scene;
  sinew::test::Random random(seed);
  for (const KnownJoint& end : joints) {
    if (end.parent < 0) continue;
    const KnownJoint& start = joints[static_cast<size_t>(end.parent)];
    for (uint32_t i = 0; i < 2 * each; ++i) {
      const double side = i % 2 == 0 ? 1 : -1;
      const auto vote = [&](const KnownJoint& joint) {
        return grid_point(side * joint.x + noise * random.normal(), joint.y + noise * random.normal(),
                          joint.z + noise * random.normal());
      };
      const sinew::Vec3i from = vote(start);
      scene.add(from, start.joint_class, vote(end), end.joint_class);
    }
  }
  return scene;
}

// Votes for nothing: anywhere, of any class, as sure as they like. `gathered` of them per 100 lie at one of a few
// positions.
inline VoteScene random_votes(uint32_t points, uint32_t gathered, uint32_t seed) {
  VoteScene scene;
  sinew::test::Random random(seed);
  const auto anywhere = [&] { return grid_point(random.uniform() - 0.5, random.uniform(), random.uniform() - 0.5); };
  std::vector<sinew::Vec3i> positions;
  for (uint32_t i = random.below(70) + 1; i > 0; --i) positions.push_back(anywhere());
  const auto vote = [&] {
    if (random.below(100) >= gathered) return anywhere();
    const uint32_t p = random.below(static_cast<uint32_t>(positions.size()));
    return positions[p] +
           sinew::Vec3i{random.between(-9000, 9000), random.between(-9000, 9000), random.between(-9000, 9000)};
  };
  for (uint32_t i = 0; i < points; ++i) {
    const sinew::Vec3i start = vote();
    scene.add(start, random.below(sinew::rigging::kJointClasses), vote(), random.below(sinew::rigging::kEndClasses),
              0.001 + 0.3 * random.uniform() * random.uniform(), random.uniform());
  }
  scene.folded = random.below(4) != 0;
  return scene;
}

inline bool same_joints(const std::vector<sinew::rigging::RigJoint>& a,
                        const std::vector<sinew::rigging::RigJoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const sinew::rigging::RigJoint& p, const sinew::rigging::RigJoint& q) {
                      return p.position == q.position && p.parent == q.parent && p.partner == q.partner &&
                             p.joint_class == q.joint_class && p.tip == q.tip && p.confidence == q.confidence &&
                             p.parent_confidence == q.parent_confidence;
                    });
}

// What find_rig() makes of votes, in a block of the size that it asks for less `missing` bytes.
struct FoundRig {
  sinew_status status;
  std::vector<sinew::rigging::RigJoint> joints;
  uint16_t spread = 0;

  explicit FoundRig(const VoteScene& scene, const sinew::rigging::RigOptions& options = {}, size_t missing = 0) {
    const sinew::rigging::Votes votes = scene.votes();
    sinew::rigging::Rig rig;
    sinew::Arena measuring;
    rig.allocate(measuring);
    status = find_rig(votes, options, nullptr, measuring, &rig);
    Block block(measuring.high_water() - missing);
    rig.allocate(block.arena);
    const size_t used = block.arena.used();
    status = find_rig(votes, options, nullptr, block.arena, &rig);
    if (status != SINEW_OK) return;
    scratch_kept = block.arena.used() != used;
    joints.assign(rig.joints, rig.joints + rig.count);
    spread = rig.spread;
  }
  bool scratch_kept = false;

  uint32_t count_of(uint32_t joint_class, bool tips = false) const {
    return static_cast<uint32_t>(std::count_if(joints.begin(), joints.end(), [&](const sinew::rigging::RigJoint& j) {
      return j.joint_class == joint_class && (j.tip != 0) == tips;
    }));
  }
};

}  // namespace sinew_test
#endif
