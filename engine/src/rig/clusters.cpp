// SPDX-License-Identifier: MIT
// Modes of every class, duplicates, modes of what is left.
#include "rig/clusters.hpp"

#include "core/sort.hpp"
#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

// Shares of the weight that all votes would have at most, 2 N in Q15, in parts of 10,000.
constexpr int64_t kLeastClass = 12;  // probability of a class, summed
constexpr int64_t kLeastMass = 3;    // of a mode
constexpr int64_t kLeastRest = 40;   // around a mode of unexplained votes
bool reaches(int64_t mass, int64_t least, uint32_t votes) { return mass * 10000 >= least * 32768 * votes; }

constexpr uint32_t kLeastProbability = 4915;  // Q15: 0.15
constexpr int64_t kHalfTrust = 3277;          // Q16: the spread of 0.05 whose trust is a quarter

constexpr int32_t kMassReach = kVoteWidth * 5 / 2;
// Two joints of one class: the lighter has at least this share of the heaviest (percent) and lies this far away.
constexpr int64_t kChainShare = 25, kOtherShare = 60;
constexpr int32_t kChainDistance = side_share(400), kOtherDistance = side_share(500);
// Joints of two classes; of a paired and another class, which may meet at the plane.
constexpr int32_t kCrossDistance = side_share(220), kCrossPairDistance = side_share(120);

constexpr int32_t kExplained = 2 * kVoteWidth;  // from a joint to the votes that it explains
constexpr int32_t kRestWidth = side_share(300), kRestReach = side_share(450), kRestPairDistance = side_share(1200);
constexpr uint32_t kLeastRestWeight = 655;  // Q15: 0.02
constexpr uint32_t kRestSeeds = 24;

constexpr int32_t kSnap = side_share(140), kPairSnap = side_share(50);

bool joint_comes_before(const FoldedJoint& a, const FoldedJoint& b) {
  if (a.mass != b.mass) return a.mass > b.mass;
  if (a.joint_class != b.joint_class) return a.joint_class < b.joint_class;
  return comes_before(a.at, b.at);
}

bool is_far(Vec3i p, const FoldedJoint* joints, uint32_t count, int32_t distance) {
  for (uint32_t j = 0; j < count; ++j) {
    if (square_distance(p, joints[j].at) < square(distance)) return false;
  }
  return true;
}

class ClusterFinder {
 public:
  ClusterFinder(const VotePool& pool, Cloud cloud, FoldedJoint* found, FoldedJoint* joints)
      : pool_(pool), cloud_(cloud), found_(found), joints_(joints) {}

  SINEW_RARE uint32_t run() {
    for (uint32_t c = 0; c < kJointClasses; ++c) add_class(c);
    heap_sort(found_, found_count_,
              [](const FoldedJoint& a, const FoldedJoint& b) { return joint_comes_before(a, b); });
    for (uint32_t i = 0; i < found_count_ && count_ < kMaxFoldedJoints; ++i) {
      if (is_new(found_[i])) joints_[count_++] = found_[i];
    }
    add_unexplained();
    for (uint32_t j = 0; j < count_ && pool_.mirrored; ++j) {
      if (joints_[j].at.x < (is_paired_class(joints_[j].joint_class) ? kPairSnap : kSnap)) joints_[j].at.x = 0;
    }
    return count_;
  }

 private:
  void add_class(uint32_t c) {
    cloud_.clear();
    int64_t sum = 0;
    for (uint32_t i = 0; i < pool_.count; ++i) {
      const uint32_t probability = pool_.probability(i, c);
      if (probability <= kLeastProbability) continue;
      sum += probability;
      const uint32_t weight = (pool_.trust[i] * probability + (1u << 14)) >> 15;
      if (weight > 0) cloud_.add(pool_.at[i], weight);
    }
    if (!reaches(sum, kLeastClass, pool_.count)) return;
    Mode modes[kMaxModes];
    const uint32_t count = find_modes(cloud_, kVoteWidth, pool_.mirrored && !is_paired_class(c), kMaxModes, modes);
    FoldedJoint* const first = found_ + found_count_;
    for (uint32_t m = 0; m < count; ++m) first[m] = {modes[m].at, static_cast<uint8_t>(c), 0};
    for (uint32_t i = 0; i < cloud_.count; ++i) {
      int64_t nearest = square(kMassReach);
      FoldedJoint* owner = nullptr;
      for (uint32_t m = 0; m < count; ++m) {
        const int64_t distance = square_distance(cloud_.at[i], first[m].at);
        if (distance >= nearest) continue;
        nearest = distance;
        owner = first + m;
      }
      if (owner != nullptr) owner->mass += cloud_.weight[i];
    }
    heap_sort(first, count, [](const FoldedJoint& a, const FoldedJoint& b) { return joint_comes_before(a, b); });
    const bool chain = is_chain_class(c);
    uint32_t kept = 0;
    for (uint32_t m = 0; m < count; ++m) {
      const FoldedJoint mode = first[m];
      if (!reaches(mode.mass, kLeastMass, pool_.count)) break;
      if (kept > 0 && mode.mass * 100 < (chain ? kChainShare : kOtherShare) * first[0].mass) break;
      if (is_far(mode.at, first, kept, chain ? kChainDistance : kOtherDistance)) first[kept++] = mode;
    }
    found_count_ += kept;
  }

  // Whether no joint is where this one would be.
  bool is_new(const FoldedJoint& joint) const {
    const bool paired = is_paired_class(joint.joint_class);
    for (uint32_t j = 0; j < count_; ++j) {
      const bool apart = pool_.mirrored && paired != is_paired_class(joints_[j].joint_class);
      const int64_t least = square(apart ? kCrossPairDistance : kCrossDistance);
      if (square_distance(joint.at, joints_[j].at) <= least) return false;
    }
    return true;
  }

  // Votes that no joint explains, whatever their class: the densest position becomes a joint of the class that most of
  // them are for, and explains what is around it.
  SINEW_RARE void add_unexplained() {
    uint16_t* const left = pool_.order;
    uint32_t left_count = 0;
    for (uint32_t i = 0; i < pool_.count; ++i) {
      if (rest_weight(i) > 0 && is_far(pool_.at[i], joints_, count_, kExplained + 1))
        left[left_count++] = static_cast<uint16_t>(i);
    }
    for (uint32_t round = 0; round < kMaxFoldedJoints && count_ < kMaxFoldedJoints; ++round) {
      cloud_.clear();
      for (uint32_t i = 0; i < left_count; ++i) {
        const uint32_t weight = rest_weight(left[i]);
        if (weight > kLeastRestWeight) cloud_.add(pool_.at[left[i]], weight);
      }
      Mode modes[kMaxModes];
      if (find_modes(cloud_, kRestWidth, pool_.mirrored, kRestSeeds, modes) == 0) return;
      FoldedJoint joint = {modes[0].at, 0, 0};
      int64_t classes[kJointClasses] = {};  // below 2^43
      uint32_t kept = 0;
      for (uint32_t i = 0; i < left_count; ++i) {
        const uint32_t vote = left[i];
        const int64_t distance = square_distance(pool_.at[vote], joint.at);
        if (distance < square(kRestReach)) {
          const int64_t weight = rest_weight(vote);
          joint.mass += weight;
          for (uint32_t c = 0; c < kJointClasses; ++c) classes[c] += weight * pool_.probability(vote, c);
        }
        if (distance > square(kExplained)) left[kept++] = left[i];
      }
      if (!reaches(joint.mass, kLeastRest, pool_.count)) return;
      for (uint32_t c = 1; c < kJointClasses; ++c) {
        if (classes[c] > classes[joint.joint_class]) joint.joint_class = static_cast<uint8_t>(c);
      }
      if (is_far_from_all(joint)) joints_[count_++] = joint;
      left_count = kept;
    }
  }
  uint32_t rest_weight(uint32_t vote) const {
    return (pool_.trust[vote] * (32768u - pool_.probability(vote, kClassTip)) + (1u << 14)) >> 15;
  }
  bool is_far_from_all(const FoldedJoint& joint) const {
    for (uint32_t j = 0; j < count_; ++j) {
      const bool rival = is_paired_class(joint.joint_class) && joints_[j].joint_class == joint.joint_class;
      if (square_distance(joint.at, joints_[j].at) <= square(rival ? kRestPairDistance : kCrossDistance)) return false;
    }
    return true;
  }

  const VotePool& pool_;
  Cloud cloud_;
  FoldedJoint* const found_;
  FoldedJoint* const joints_;
  uint32_t found_count_ = 0;
  uint32_t count_ = 0;
};

}  // namespace

uint32_t trust_in(uint32_t spread) {
  const int64_t root = (kHalfTrust << 15) / (kHalfTrust + spread);
  return static_cast<uint32_t>(round_shift(root * root, 15));
}

bool VotePool::build(const Votes& v, bool mirror, Arena& arena) {
  votes = &v;
  mirrored = mirror;
  count = 2 * v.points;
  at = arena.alloc<Vec3i>(count);
  trust = arena.alloc<uint16_t>(count);
  source = arena.alloc<uint16_t>(count);
  order = arena.alloc<uint16_t>(count);
  if (!arena.ok()) return false;
  if (arena.measuring()) return true;
  const auto position = [&](uint32_t s) {
    return folded_position((s & 1) != 0 ? v.end[s >> 1] : v.start[s >> 1], mirror);
  };
  for (uint32_t i = 0; i < count; ++i) source[i] = static_cast<uint16_t>(i);
  heap_sort(source, count, [&](uint16_t a, uint16_t b) { return comes_before(position(a), position(b)); });
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t point = source[i] >> 1;
    at[i] = position(source[i]);
    trust[i] = static_cast<uint16_t>(trust_in((source[i] & 1) != 0 ? v.end_spread[point] : v.start_spread[point]));
  }
  return true;
}

SINEW_RARE sinew_status find_folded_joints(const VotePool& pool, Arena& arena, FoldedJoint* joints, uint32_t* count) {
  const ArenaScope scope(arena);
  Cloud cloud;
  const bool fits = cloud.allocate(arena, pool.count);
  FoldedJoint* const found = arena.alloc<FoldedJoint>(kJointClasses * kMaxModes);
  if (!fits || !arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  *count = ClusterFinder(pool, cloud, found, joints).run();
  return SINEW_OK;
}

}  // namespace sinew::rigging
