// SPDX-License-Identifier: MIT
// Effects of a map on a body, part by part.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "motion/body_kind.hpp"
#include "motion/body_parts.hpp"
#include "sinew/rig.h"
#include "sinew_character/motion/motion_map.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"

namespace sinew {
namespace {

// Joints that carry a part's motion: collarbones, hip joints and toes may lack a source, and a neck moves the head.
bool is_essential(uint8_t joint_class) {
  return joint_class != SINEW_CLASS_CLAVICLE && joint_class != SINEW_CLASS_HIP && joint_class != SINEW_CLASS_TOE &&
         joint_class != SINEW_CLASS_NECK;
}

constexpr size_t kChain = 3;  // joints

class MapReader {
 public:
  MapReader(const MapRig& target, MaybeAxis target_up, const MapRig& source, MaybeAxis source_up,
            const std::vector<int>& sources)
      : target_(target),
        source_(source),
        to_(target, target_up),
        from_(source, source_up),
        to_kind_(body_kind(target, to_)),
        from_kind_(body_kind(source, from_)),
        sources_(sources) {
    used_.assign(source.joints.size(), 0);
    for (const int s : sources)
      if (s >= 0) used_[static_cast<size_t>(s)] = 1;
  }

  MapCover read() const {
    MapCover cover = read_parts();
    cover.kinds_apart = difference(to_kind_, from_kind_);
    if (cover.kinds_apart > 0)
      cover.warnings.insert(cover.warnings.begin(),
                            "the motion is that of " + text_of(from_kind_) + ", the character is " + text_of(to_kind_));
    return cover;
  }

 private:
  MapCover read_parts() const {
    MapCover cover;
    find_share(&cover);
    if (!to_.has(PartKind::kLeg) && !to_.has(PartKind::kArm) && !to_.has(PartKind::kWing)) {
      cover.warnings = idle_limbs();
      if (cover.warnings.empty()) cover.warnings = few_joints();
      return cover;
    }
    cover.warnings = part_warnings();
    cover.rigid = rigid_parts();
    const bool moves_legs = std::any_of(from_.all().begin(), from_.all().end(), [&](const BodyPart& part) {
      return part.kind == PartKind::kLeg && essential_movers(part) > 0;
    });
    cover.legless = to_.named() && moves_legs && !to_.has(PartKind::kLeg) && to_.has(PartKind::kArm);
    return cover;
  }

  size_t moved() const {
    return static_cast<size_t>(std::count_if(sources_.begin(), sources_.end(), [](int s) { return s >= 0; }));
  }
  // Share of the smaller skeleton's joints that move; half of the larger one's may have no source.
  double moved_share() const {
    size_t all = 0;
    for (size_t j = 0; j < sources_.size(); ++j) all += target_.ends.empty() || target_.ends[j] == 0 ? 1 : 0;
    const double target = static_cast<double>(std::max<size_t>(1, all)), count = static_cast<double>(moved());
    return std::min(count / std::min(target, static_cast<double>(source_.joints.size())), 2 * count / target);
  }
  bool is_mapped(int joint) const { return sources_[static_cast<size_t>(joint)] >= 0; }

  // Whether a joint and its source are of limbs that represent each other.
  bool is_limb_pair(int joint, int source) const {
    const PartKind own = to_.kind_of(joint), its = from_.kind_of(source);
    const bool animal = own == PartKind::kLeg || its == PartKind::kLeg ? !both_upright() : true;
    return own == its || its == PartKind::kNone || (is_limb(own) && is_limb(its) && animal);
  }
  // The share of essential joints of a limb that belong to its like, in the skeleton of which it is more; 0 where one has none.
  double reached(PartKind kind) const {
    std::vector<char> reached_by(source_.joints.size(), 0), reaches(sources_.size(), 0);
    for (size_t t = 0; t < sources_.size(); ++t) {
      if (sources_[t] < 0 || !is_limb_pair(static_cast<int>(t), sources_[t])) continue;
      reaches[t] = 1;
      if (is_limb(to_.kind_of(static_cast<int>(t)))) reached_by[static_cast<size_t>(sources_[t])] = 1;
    }
    const auto share = [&](const BodyParts& parts, const std::vector<char>& used) {
      double all = 0, own = 0;
      for (const BodyPart& part : parts.all())
        for (const int j : part.joints)
          if (part.kind == kind && is_essential(parts.class_of(j))) all += 1, own += used[static_cast<size_t>(j)];
      return all > 0 ? own / all : -1;
    };
    const double target = share(to_, reaches), source = share(from_, reached_by);
    return target < 0 || source < 0 ? std::max(0.0, target) : std::max(target, source);
  }

  void find_share(MapCover* cover) const {
    const auto least = [&](double share, const char* missing) {
      if (static_cast<float>(share) >= cover->share) return;
      cover->share = static_cast<float>(share);
      cover->missing = missing;
    };
    const auto has_limbs = [](const BodyParts& parts) {
      return parts.has(PartKind::kLeg) || parts.has(PartKind::kArm) || parts.has(PartKind::kWing);
    };
    double limbs = 0;
    for (const PartKind kind : {PartKind::kLeg, PartKind::kArm, PartKind::kWing})
      limbs = std::max(limbs, reached(kind));
    // Fish, spiders: if the limbs of one body are unknown, the share of the target's joints counts.
    if (!has_limbs(to_) || !has_limbs(from_)) limbs = moved_share();
    if (has_limbs(to_) || has_limbs(from_)) least(limbs, "no legs, arms or wings");
    if (to_.lean() && from_.lean()) {
      const double a = *to_.lean(), b = *from_.lean();
      const double cosine = a * b + std::sqrt(std::max(0.0, 1 - a * a)) * std::sqrt(std::max(0.0, 1 - b * b));
      least(std::max(0.0, cosine), "one is upright, the other is not");
    }
  }

  // If the parts are unknown.
  std::vector<std::string> few_joints() const {
    if (3 * moved() >= 2 * std::min(source_.joints.size(), target_.joints.size())) return {};
    return {"only " + std::to_string(moved()) + " of its " + std::to_string(target_.joints.size()) + " joints move"};
  }

  // Limbs of the source that move nothing, if the target's limbs have no class by name.
  std::vector<std::string> idle_limbs() const {
    std::vector<std::string> texts;
    for (const BodyPart& part : from_.all()) {
      const auto used = [&](int j) { return used_[static_cast<size_t>(j)] != 0; };
      if (is_limb(part.kind) && essential_movers(part) > 0 &&
          std::none_of(part.joints.begin(), part.joints.end(), used))
        texts.push_back(from_.text(part) + " of the motion moves nothing");
    }
    return texts;
  }
  size_t essential_movers(const BodyPart& of_source) const {
    return static_cast<size_t>(std::count_if(of_source.joints.begin(), of_source.joints.end(), [&](int j) {
      const bool moves = source_.animated.empty() || source_.animated[static_cast<size_t>(j)] != 0;
      return moves && is_essential(from_.class_of(j));
    }));
  }

  // The parts of the source that could move a part of the target.
  bool could_move(const BodyPart& part, const BodyPart& other) const {
    if (part.side != 0 && other.side != 0 && part.side != other.side) return false;
    if (part.kind == other.kind) return true;
    const auto stands_for = [&](PartKind own, PartKind its) {
      return part.kind == own && other.kind == its && !to_.has(its) && !from_.has(own);
    };
    return stands_for(PartKind::kWing, PartKind::kArm) || stands_for(PartKind::kArm, PartKind::kWing);
  }
  // Essential joints of the source's parts that could move a part, those that move alone.
  size_t movers_of(const BodyPart& part) const {
    size_t most = 0;
    for (const BodyPart& other : from_.all()) {
      if (could_move(part, other)) most = std::max(most, essential_movers(other));
    }
    return most;
  }

  // The source's part that most joints of a part follow, where it is another one than names say; null: none.
  const BodyPart* followed(const BodyPart& part) const {
    if (!to_.named() || !from_.named()) return nullptr;
    size_t mapped = 0;
    for (const int j : part.joints) mapped += is_mapped(j) ? 1 : 0;
    for (const BodyPart& other : from_.all()) {
      if (could_move(part, other) || !contradict(part, other)) continue;
      size_t own = 0;
      for (const int j : part.joints)
        own += std::count(other.joints.begin(), other.joints.end(), sources_[static_cast<size_t>(j)]) > 0 ? 1 : 0;
      if (2 * own > mapped) return &other;
    }
    return nullptr;
  }
  bool both_upright() const {
    constexpr double kUpright = 0.7;  // sine
    return to_.lean() && from_.lean() && *to_.lean() > kUpright && *from_.lean() > kUpright;
  }
  // A trunk may move as a neck, hair as an ear; of animals names do not tell front legs from hind legs for sure.
  bool contradict(const BodyPart& part, const BodyPart& other) const {
    const bool legs_and_arms = (part.kind == PartKind::kLeg && other.kind == PartKind::kArm) ||
                               (part.kind == PartKind::kArm && other.kind == PartKind::kLeg);
    if (legs_and_arms && !both_upright()) return false;
    const auto family = [](PartKind kind) {
      return kind == PartKind::kHead ? PartKind::kTrunk : kind == PartKind::kWing ? PartKind::kArm : kind;
    };
    if (part.kind == PartKind::kHair || part.kind == PartKind::kNone || other.kind == PartKind::kNone) return false;
    const bool sides = part.side != 0 && other.side != 0 && part.side != other.side;
    return sides || family(part.kind) != family(other.kind);
  }

  // A joint above a limb, of its side, that is called otherwise: Back_Leg_Pelvis.L.
  bool carried_by(const BodyPart& part) const {
    if (part.side == 0) return false;
    const auto above = [&](int j) { return target_.joints[static_cast<size_t>(j)].parent; };
    for (int j = above(part.joints[0]); j >= 0 && to_.side_of(j) == part.side; j = above(j))
      if (is_mapped(j)) return true;
    return false;
  }

  // A hand or foot with another parent, of inverse kinematics: it goes with its limb.
  bool is_end_of_moved(const BodyPart& part) const {
    const auto is_end = [&](int j) {
      const uint8_t own = to_.class_of(j);
      return own == SINEW_CLASS_HAND || own == SINEW_CLASS_FOOT || own == SINEW_CLASS_TOE;
    };
    const auto moves = [&](int j) { return is_mapped(j); };
    return std::all_of(part.joints.begin(), part.joints.end(), is_end) &&
           std::any_of(to_.all().begin(), to_.all().end(), [&](const BodyPart& other) {
             return other.kind == part.kind && other.side == part.side &&
                    std::any_of(other.joints.begin(), other.joints.end(), moves);
           });
  }

  struct Finding {
    const BodyPart* part;
    std::string singular, plural;  // text for one, and for both of a pair
  };

  std::optional<Finding> finding_of(const BodyPart& part) const {
    if (const BodyPart* other = followed(part)) {
      const std::string text = " " + from_.text(*other);
      return Finding{&part, "follows" + text, "follow" + text};
    }
    size_t own = 0, mapped = 0;
    for (const int j : part.joints) {
      if (!is_essential(to_.class_of(j))) continue;
      ++own;
      mapped += is_mapped(j) ? 1 : 0;
    }
    if (own == 0) return std::nullopt;  // a neck, a collarbone
    size_t any_mapped = carried_by(part) ? 1 : 0;
    any_mapped += static_cast<size_t>(std::count_if(part.joints.begin(), part.joints.end(), [&](int j) {
      return is_mapped(j) && to_.class_of(j) != SINEW_CLASS_TOE;
    }));
    const bool idle = any_mapped == 0;
    if (idle && is_end_of_moved(part)) return std::nullopt;
    const bool needed = is_limb(part.kind) || part.kind == PartKind::kTrunk || part.kind == PartKind::kHead;
    const size_t movers = movers_of(part);
    if (idle && movers == 0) {
      if (from_.all().empty() || (part.kind != PartKind::kLeg && part.kind != PartKind::kArm)) return std::nullopt;
      return Finding{&part, "has no motion in the source", "have no motion in the source"};
    }
    if (mapped == 0 && !idle && movers > 0 && part.kind == PartKind::kHead)
      return Finding{&part, "moves with the neck", ""};
    if (idle && (needed || part.kind == PartKind::kTail)) return Finding{&part, "does not move", "do not move"};
    if (bends_elsewhere(part))
      return Finding{&part, "bends at other joints than in the motion", "bend at other joints than in the motion"};
    if (is_limb(part.kind) && 2 * any_mapped < std::min(own, movers))  // a leg of one joint may move a shoulder
      return Finding{&part, "hardly moves, " + std::to_string(mapped) + " of its " + std::to_string(own) + " joints",
                     "hardly move, " + std::to_string(mapped) + " of " + std::to_string(own) + " joints each"};
    return std::nullopt;
  }

  // An arm or leg of a person whose joints follow others of its kind: a hand that moves as a forearm.
  bool bends_elsewhere(const BodyPart& part) const {
    if (!both_upright() || !to_.named() || !from_.named()) return false;
    size_t other = 0;
    for (const int j : part.joints) {
      const int s = sources_[static_cast<size_t>(j)];
      if (s < 0 || !is_essential(to_.class_of(j)) || from_.kind_of(s) != part.kind ||
          from_.class_of(s) == SINEW_CLASS_TOE)
        continue;
      other += to_.class_of(j) != from_.class_of(s) ? 1 : 0;
    }
    return other > 1;
  }

  std::vector<std::string> part_warnings() const {
    std::vector<Finding> findings;
    for (const BodyPart& part : to_.all())
      if (std::optional<Finding> one = finding_of(part)) findings.push_back(std::move(*one));
    std::vector<std::string> texts;
    std::vector<char> told(findings.size(), 0);
    for (size_t a = 0; a < findings.size(); ++a) {
      if (told[a] != 0) continue;
      const Finding& one = findings[a];
      std::string text = to_.text(*one.part) + " " + one.singular;
      for (size_t b = a + 1; b < findings.size(); ++b) {
        const Finding& other = findings[b];
        if (!is_limb(one.part->kind) || other.part->kind != one.part->kind || other.plural != one.plural) continue;
        told[b] = 1;
        text = to_.text_of_pair(one.part->kind) + " " + one.plural;
      }
      if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(std::move(text));
    }
    return texts;
  }

  // Joints without a source because the source has nothing like them: hair, ropes, tails.
  std::string rigid_parts() const {
    std::vector<std::string> words;
    const auto add = [&](const std::string& word) {
      if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
    };
    for (const BodyPart& part : to_.all()) {
      if (std::any_of(part.joints.begin(), part.joints.end(), [&](int j) { return is_mapped(j); })) continue;
      if (part.kind == PartKind::kHair) add(to_.class_of(part.joints[0]) == SINEW_CLASS_EAR ? "ears" : "hair");
      if (part.kind == PartKind::kTail && movers_of(part) == 0) add("tail");
      if (part.kind == PartKind::kWing && movers_of(part) == 0) add("wings");
    }
    const size_t others = other_joints();
    if (others >= kChain) words.push_back(std::to_string(others) + " other joints");
    std::string text;
    for (size_t k = 0; k < words.size(); ++k) text += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words[k];
    return text;
  }

  // Ropes, cloth: joints that are no part of a body, no end and no helper of another.
  size_t other_joints() const {
    const JointVerdicts verdicts = joint_verdicts(target_.joints);
    size_t count = 0;
    for (size_t j = 0; j < target_.joints.size(); ++j) {
      const bool end = !target_.ends.empty() && target_.ends[j] != 0;
      const bool other = verdicts.roles[j] == SINEW_ROLE_DEFORMS && to_.kind_of(static_cast<int>(j)) == PartKind::kNone;
      count += other && !end && sources_[j] < 0 ? 1 : 0;
    }
    return count;
  }

  const MapRig &target_, &source_;
  const BodyParts to_, from_;
  const BodyKind to_kind_, from_kind_;
  const std::vector<int>& sources_;
  std::vector<char> used_;  // [source J]
};

}  // namespace

MapCover map_cover(const MapRig& target, MaybeAxis target_up, const MapRig& source, MaybeAxis source_up,
                   const std::vector<int>& sources) {
  return MapReader(target, target_up, source, source_up, sources).read();
}

}  // namespace sinew
