// SPDX-License-Identifier: MIT
// Damages of joints and names.
#include <algorithm>
#include <cmath>
#include <utility>

#include "score/rig_damage.hpp"
#include "sinew_character/rig/joint_mirror.hpp"

namespace sinew {
namespace {

class SkeletonDamage {
 public:
  SkeletonDamage(Draws* draws, Character* character)
      : draws_(*draws),
        c_(*character),
        verdicts_(joint_verdicts(c_.joints)),
        of_(vertices_by_joint(c_)),
        limbs_(limb_joints(c_, verdicts_)),
        side_(longest_side(c_)) {}

  bool run(const std::string& kind) {
    if (kind == "units") {
      for (Joint& joint : c_.joints)
        joint.position = {100 * joint.position.x, 100 * joint.position.y, 100 * joint.position.z};
      return c_.joints.size() > 2;
    }
    if (limbs_.empty()) return false;
    if (kind == "sides-all") return sides(-1);
    if (kind == "sides-limb") return sides(static_cast<int>(draws_.below(2)));
    if (kind == "joint-outside") return move_out(0.25F, false);
    if (kind == "unlike-joints") return move_out(0.06F, true);
    if (kind == "zero-length") return zero_length();
    if (kind == "dead-joint") return dead();
    if (kind == "names-limb") return names_in_limb();
    if (kind == "arms-for-legs") return arms_for_legs();
    if (kind == "hung-wrong") return hung_wrong();
    return kind == "unlike-weights" && unlike_weights();
  }

 private:
  bool is_arm(size_t j) const {
    return verdicts_.classes[j] >= SINEW_CLASS_CLAVICLE && verdicts_.classes[j] <= SINEW_CLASS_HAND;
  }
  bool is_leg(size_t j) const {
    return verdicts_.classes[j] >= SINEW_CLASS_HIP && verdicts_.classes[j] <= SINEW_CLASS_TOE;
  }
  bool has_twin(size_t j) const {
    return verdicts_.partners[j] >= 0 && static_cast<size_t>(verdicts_.partners[j]) != j;
  }
  bool is_below(size_t joint, size_t above) const {
    for (int up = static_cast<int>(joint); up >= 0; up = c_.joints[static_cast<size_t>(up)].parent)
      if (static_cast<size_t>(up) == above) return true;
    return false;
  }

  //   limb  -1: all, 0: arms, 1: legs, with their children
  bool sides(int limb) {
    bool any = false;
    for (size_t j = 0; j < c_.joints.size(); ++j) {
      if (!has_twin(j) || verdicts_.sides[j] != 1) continue;
      const size_t twin = static_cast<size_t>(verdicts_.partners[j]);
      bool within = limb < 0;
      for (int up = static_cast<int>(j); up >= 0 && !within; up = c_.joints[static_cast<size_t>(up)].parent)
        within = limb == 0 ? is_arm(static_cast<size_t>(up)) : is_leg(static_cast<size_t>(up));
      if (!within) continue;
      std::swap(c_.joints[j].name, c_.joints[twin].name);
      any = any || std::find(limbs_.begin(), limbs_.end(), j) != limbs_.end();
    }
    return any;
  }

  bool move_out(float share, bool one_side) {
    std::vector<size_t> may;
    for (const size_t j : limbs_)
      if (!one_side || (has_twin(j) && verdicts_.images[j] == verdicts_.partners[j])) may.push_back(j);
    if (may.empty()) return false;
    const size_t joint = draws_.of(may);
    const uint32_t axis = 2 - verdicts_.mirror_axis;  // to the front or the back
    component(&c_.joints[joint].position, axis == verdicts_.mirror_axis ? 2 : axis) +=
        (draws_.below(2) == 0 ? -1.0F : 1.0F) * share * side_;
    return true;
  }

  bool zero_length() {
    std::vector<size_t> may;
    for (const size_t j : limbs_)
      if (std::find(limbs_.begin(), limbs_.end(), static_cast<size_t>(c_.joints[j].parent)) != limbs_.end())
        may.push_back(j);
    if (may.empty()) return false;
    const size_t joint = draws_.of(may);
    c_.joints[joint].position = c_.joints[static_cast<size_t>(c_.joints[joint].parent)].position;
    return true;
  }

  bool dead() {
    std::vector<size_t> may;
    for (const size_t j : limbs_)
      if (!of_[static_cast<size_t>(c_.joints[j].parent)].empty()) may.push_back(j);
    if (may.empty()) return false;
    const size_t joint = draws_.of(may);
    const auto parent = static_cast<uint32_t>(c_.joints[joint].parent);
    for (auto& row : c_.influences)
      for (size_t i = 0; i < row.size(); ++i) {
        if (row[i].joint != joint) continue;
        row[i].joint = parent;
        for (size_t k = 0; k < row.size(); ++k)
          if (k != i && row[k].joint == parent) {
            row[k].weight += row[i].weight;
            row.erase(row.begin() + static_cast<std::ptrdiff_t>(i));
            break;
          }
        break;
      }
    return true;
  }

  bool names_in_limb() {
    std::vector<std::pair<size_t, size_t>> may;
    for (const size_t j : limbs_)
      for (const size_t other : limbs_)
        if (j != other && is_below(j, other) && verdicts_.classes[j] != verdicts_.classes[other] &&
            is_arm(j) == is_arm(other))
          may.emplace_back(j, other);
    if (may.empty()) return false;
    const auto& [a, b] = draws_.of(may);
    std::swap(c_.joints[a].name, c_.joints[b].name);
    return true;
  }

  bool arms_for_legs() {
    static constexpr std::pair<uint8_t, uint8_t> kLike[] = {{SINEW_CLASS_UPPER_ARM, SINEW_CLASS_THIGH},
                                                            {SINEW_CLASS_FOREARM, SINEW_CLASS_CALF},
                                                            {SINEW_CLASS_HAND, SINEW_CLASS_FOOT}};
    size_t done = 0;
    for (const auto& [arm, leg] : kLike)
      for (const size_t j : limbs_)
        for (const size_t other : limbs_)
          if (verdicts_.classes[j] == arm && verdicts_.classes[other] == leg &&
              verdicts_.sides[j] == verdicts_.sides[other] && verdicts_.sides[j] != 0 && !swapped_[j] &&
              !swapped_[other]) {
            std::swap(c_.joints[j].name, c_.joints[other].name);
            swapped_[j] = swapped_[other] = true;
            ++done;
          }
    return done >= 6;
  }

  bool hung_wrong() {
    std::vector<std::pair<size_t, size_t>> may;
    for (const size_t j : limbs_) {
      if (verdicts_.classes[j] != SINEW_CLASS_HAND && verdicts_.classes[j] != SINEW_CLASS_FOOT) continue;
      for (const size_t other : limbs_)
        if ((is_arm(j) && is_leg(other)) || (is_leg(j) && is_arm(other))) may.emplace_back(j, other);
    }
    if (may.empty()) return false;
    const auto& [joint, on] = draws_.of(may);
    c_.joints[joint].parent = static_cast<int>(on);
    return true;
  }

  bool unlike_weights() {
    std::vector<size_t> may;
    for (const size_t j : limbs_)
      if (has_twin(j) && verdicts_.images[j] == verdicts_.partners[j] && of_[j].size() >= 20) may.push_back(j);
    if (may.empty()) return false;
    const size_t joint = draws_.of(may);
    for (size_t k = 0; k < of_[joint].size() / 2; ++k)
      c_.influences[of_[joint][k]] = {{static_cast<uint32_t>(c_.joints[joint].parent), 1.0F}};
    return true;
  }

  Draws& draws_;
  Character& c_;
  JointVerdicts verdicts_;
  std::vector<std::vector<uint32_t>> of_;
  std::vector<size_t> limbs_;
  float side_;
  std::vector<bool> swapped_ = std::vector<bool>(c_.joints.size(), false);
};

}  // namespace

bool damage_skeleton(const std::string& kind, Draws* draws, Character* character) {
  return SkeletonDamage(draws, character).run(kind);
}

}  // namespace sinew
