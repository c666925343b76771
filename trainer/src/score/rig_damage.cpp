// SPDX-License-Identifier: MIT
// The table of damages, and which file does which.
#include "score/rig_damage.hpp"

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

const std::vector<DamageKind>& damage_kinds() {
  static const std::vector<DamageKind> kKinds = {
      {"unweighted-patch", "rows of a patch emptied", {"unweighted"}},
      {"scaled-sums", "rows of a patch times 0.7", {"weight-sum"}},
      {"long-rows", "rows of a patch spread evenly over eight joints", {"influences"}},
      {"speck", "one vertex given to a joint across the body", {"speck", "far-weight", "left-right", "leak"}},
      {"noise", "every vertex of a patch given to a joint drawn for it", {"speck", "far-weight", "leak", "left-right"}},
      {"far-patch", "a patch given to a joint across the body", {"far-weight", "left-right", "leak", "speck", "tear"}},
      {"other-side", "all of a limb's joint given to its twin", {"left-right", "far-weight", "leak"}},
      {"gap",
       "half of the weight of a patch given to the limb beside it, as a brush through a gap does",
       {"leak", "far-weight", "left-right"}},
      {"crack", "the border of a joint's faces doubled, with the joint's weight alone", {"crack"}},
      {"shuffled-rows",
       "rows moved on by a third of the vertices, as an exporter that renumbers does",
       {"speck", "far-weight", "tear", "leak"}},
      {"collapsed",
       "rows of a limb smoothed 100 times",
       {"lost-volume", "leak", "far-weight", "dead-joint", "unlike-weights"}},
      {"sides-all", "names of left and right exchanged", {"sides"}},
      {"sides-limb", "names of one limb's two sides exchanged", {"sides", "name-order"}},
      {"joint-outside", "a limb's joint moved out by a quarter of the size", {"joint-outside"}},
      {"zero-length", "a limb's joint put where its parent is", {"zero-length"}},
      {"dead-joint", "the weight of a limb's joint given to its parent", {"dead-joint"}},
      {"names-limb", "names within a limb exchanged", {"name-order"}},
      {"arms-for-legs", "names of arms and legs exchanged", {"name-place", "name-order"}},
      {"hung-wrong", "a hand or a foot hung on another limb", {"name-order"}},
      {"unlike-joints", "a joint moved by 6 % of the size on one side", {"unlike-joints", "joint-outside"}},
      {"unlike-weights", "half of a joint's vertices given to its parent on one side", {"unlike-weights"}},
      {"units", "the skeleton a hundred times as large", {"skeleton-apart", "joint-outside"}},
      {"bind-matrix", "one inverse bind matrix moved by a fifth of the size", {"bind-matrices"}},
      {"mirrored-scale", "the skeleton under a node scaled by -1", {"mirrored-scale"}},
      {"exploded-rest",
       "nodes four times as far from their parents, bind matrices unchanged",
       {"exploded-rest", "bind-matrices"}},
      {"uneven-scale", "a joint's node scaled by 1.5 along one axis", {"uneven-scale"}},
      {"foot-slide", "feet pulled along the floor in a walk", {"foot-slide"}},
      {"foot-float", "a walk 10 % of the height over the floor", {"foot-float"}},
      {"foot-sink", "a walk 6 % of the height under the floor", {"foot-sink"}},
      {"clip-flip", "a joint turned over in one frame", {"clip-flip"}},
      {"clip-jump", "the root moved by a quarter of the height in one frame", {"clip-jump"}},
  };
  return kKinds;
}

DamageNeeds needs_of(const DamageKind& kind) {
  return is_file_damage(kind.name)   ? DamageNeeds::kFile
         : is_clip_damage(kind.name) ? DamageNeeds::kWalk
                                     : DamageNeeds::kCharacter;
}

std::optional<DamagedRig> undamaged(const Character& character, DamageNeeds needs) {
  DamagedRig rig = {character, std::nullopt};
  if (needs == DamageNeeds::kFile) {
    Draws none(1);
    std::optional<Character> read = damage_file("", &none, character);
    if (!read) return std::nullopt;
    rig.character = std::move(*read);
  }
  if (needs == DamageNeeds::kWalk) {
    rig.motion = walk_of(character);
    if (!rig.motion) return std::nullopt;
  }
  return rig;
}

std::optional<DamagedRig> damaged(const DamagedRig& whole, const DamageKind& kind, uint32_t seed) {
  Draws draws(seed);
  const std::string name = kind.name;
  if (is_file_damage(name)) {
    std::optional<Character> read = damage_file(name, &draws, whole.character);
    return read ? std::optional<DamagedRig>(DamagedRig{std::move(*read), std::nullopt}) : std::nullopt;
  }
  DamagedRig rig = whole;
  if (is_clip_damage(name))
    return rig.motion && damage_clip(name, &draws, rig.character, &*rig.motion)
               ? std::optional<DamagedRig>(std::move(rig))
               : std::nullopt;
  if (damage_weights(name, &draws, &rig.character)) return rig;
  rig.character = whole.character;
  return damage_skeleton(name, &draws, &rig.character) ? std::optional<DamagedRig>(std::move(rig)) : std::nullopt;
}

std::vector<std::vector<uint32_t>> vertices_by_joint(const Character& character) {
  std::vector<std::vector<uint32_t>> out(character.joints.size());
  for (uint32_t v = 0; v < character.influences.size(); ++v) {
    const Influence* best = nullptr;
    for (const Influence& i : character.influences[v])
      if (best == nullptr || i.weight > best->weight) best = &i;
    if (best != nullptr && best->weight > 0) out[best->joint].push_back(v);
  }
  return out;
}

std::vector<size_t> limb_joints(const Character& character, const JointVerdicts& verdicts) {
  constexpr size_t kLeast = 8;
  const auto vertices = vertices_by_joint(character);
  std::vector<size_t> out;
  for (size_t j = 0; j < character.joints.size(); ++j) {
    const uint8_t one = verdicts.classes[j];
    const bool limb = one == SINEW_CLASS_UPPER_ARM || one == SINEW_CLASS_FOREARM || one == SINEW_CLASS_HAND ||
                      one == SINEW_CLASS_THIGH || one == SINEW_CLASS_CALF || one == SINEW_CLASS_FOOT;
    if (limb && verdicts.roles[j] == SINEW_ROLE_DEFORMS && vertices[j].size() >= kLeast &&
        character.joints[j].parent >= 0)
      out.push_back(j);
  }
  return out;
}

float longest_side(const Character& character) { return box_of(character.vertices).longest_side(); }

}  // namespace sinew
