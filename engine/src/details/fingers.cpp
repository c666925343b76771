// SPDX-License-Identifier: MIT
// Modes of finger joints and of their ends.
#include "details/fingers.hpp"

#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kSeeds = 8;
constexpr uint32_t kLeastFingerProbability = 2500;  // Q15: 0.08
constexpr int32_t kFingerReach = kVoteWidth * 5 / 2;
// Limits of a joint: the weight around it, in parts of 10,000 of the largest possible weight of all votes; and its
// share of the votes of its class, each counted by its probability, Q15.
constexpr int64_t kLeastFingerMass = 10;
constexpr int64_t kLeastShare = 3277;
constexpr int32_t kLeastFingerBone = side_share(200);  // from joint to joint
constexpr int32_t kApart = side_share(350);            // from a finger's second joint or end to another's

struct Joint {
  Vec3i at = {0, 0, 0};
  int64_t mass = 0;         // Q15
  uint16_t confidence = 0;  // Q15: kLeastShare's
};

class FingerFinder {
 public:
  FingerFinder(const VotePool& pool, Cloud cloud, Finger* fingers) : pool_(pool), cloud_(cloud), fingers_(fingers) {}

  SINEW_RARE void run() {
    for (uint32_t f = 0; f < kFingers; ++f) {
      fingers_[f] = Finger();
      find_finger(f);
    }
    for (uint32_t f = 0; f < kFingers; ++f) {
      for (uint32_t g = 0; g < f; ++g) {
        if (fingers_[f].joints == 0 || fingers_[g].joints == 0) continue;
        if (square_distance(fingers_[f].at[1], fingers_[g].at[1]) >= square(kApart)) continue;
        fingers_[mass_[f] > mass_[g] ? g : f] = Finger();
      }
    }
    uint32_t count = 0;
    for (uint32_t f = 0; f < kFingers; ++f) {
      count += fingers_[f].joints > 0 ? 1 : 0;
      for (uint32_t g = 0; g < f; ++g) drop_one_end(&fingers_[f], &fingers_[g]);
    }
    for (uint32_t f = 0; f < kFingers && count < kFewestFingers; ++f) fingers_[f] = Finger();
  }

 private:
  static void drop_one_end(Finger* a, Finger* b) {
    if (!a->has_end || !b->has_end || square_distance(a->at[a->joints], b->at[b->joints]) >= square(kApart)) return;
    Finger* const less = a->confidence[a->joints] < b->confidence[b->joints] ? a : b;
    less->has_end = false;
  }

  // The densest position of the cloud; `all` is what its votes would weigh if all of them agreed.
  bool find_joint(int64_t all, Joint* joint) {
    Mode modes[kMaxModes];
    if (find_modes(cloud_, kVoteWidth, false, kSeeds, modes) == 0) return false;
    joint->at = modes[0].at;
    joint->mass = 0;
    for (uint32_t i = 0; i < cloud_.count; ++i) {
      if (square_distance(cloud_.at[i], joint->at) < square(kFingerReach)) joint->mass += cloud_.weight[i];
    }
    joint->confidence = static_cast<uint16_t>(all > 0 ? joint->mass * 32767 / all : 0);
    return joint->mass * 10000 >= kLeastFingerMass * 32768 * pool_.count && joint->confidence >= kLeastShare;
  }

  void find_finger(uint32_t f) {
    Finger& finger = fingers_[f];
    uint32_t last = 0;
    mass_[f] = 0;
    for (uint32_t k = 0; k < kFingerJoints; ++k) {
      const uint32_t c = finger_class(f, k);
      cloud_.clear();
      int64_t all = 0;
      for (uint32_t i = 0; i < pool_.count; ++i) {
        const uint32_t probability = pool_.probability(i, c);
        if (probability <= kLeastFingerProbability) continue;
        all += probability;
        const uint32_t weight = (pool_.trust[i] * probability + (1u << 14)) >> 15;
        if (weight > 0) cloud_.add(pool_.at[i], weight);
      }
      Joint joint;
      if (!find_joint(all, &joint)) continue;
      if (finger.joints > 0 && square_distance(joint.at, finger.at[finger.joints - 1]) < square(kLeastFingerBone))
        continue;
      finger.at[finger.joints] = joint.at;
      finger.confidence[finger.joints++] = joint.confidence;
      mass_[f] += joint.mass;
      last = k;
    }
    if (finger.joints < kFewestFingerJoints) {
      finger = Finger();
      return;
    }
    find_end(finger_class(f, last), &finger);
  }

  // The tips of bones that start at the finger's last joint.
  void find_end(uint32_t c, Finger* finger) {
    cloud_.clear();
    int64_t all = 0;
    for (uint32_t i = 0; i < pool_.count; ++i) {
      if ((pool_.source[i] & 1) == 0) continue;
      const uint32_t probability =
          (pool_.probability(i, kClassTip) *
               pool_.votes->start_class[static_cast<size_t>(pool_.source[i] >> 1) * kJointClasses + c] +
           (1u << 14)) >>
          15;
      if (probability <= kLeastFingerProbability) continue;
      all += probability;
      const uint32_t weight = (pool_.trust[i] * probability + (1u << 14)) >> 15;
      if (weight > 0) cloud_.add(pool_.at[i], weight);
    }
    Joint end;
    if (!find_joint(all, &end)) return;
    if (square_distance(end.at, finger->at[finger->joints - 1]) < square(kLeastFingerBone)) return;
    finger->has_end = true;
    finger->at[finger->joints] = end.at;
    finger->confidence[finger->joints] = end.confidence;
  }

  const VotePool& pool_;
  Cloud cloud_;
  Finger* const fingers_;
  int64_t mass_[kFingers] = {};
};

}  // namespace

sinew_status find_fingers(const VotePool& pool, Arena& arena, Finger (&fingers)[kFingers]) {
  const ArenaScope scope(arena);
  Cloud cloud;
  if (!cloud.allocate(arena, pool.count)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  FingerFinder(pool, cloud, fingers).run();
  return SINEW_OK;
}

}  // namespace sinew::rigging
