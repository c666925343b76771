// SPDX-License-Identifier: MIT
// Chains by sinew's own names, from the body outwards.
#include <algorithm>
#include <array>
#include <string>

#include "sinew_character/predict/edit_skeleton.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

struct Link {
  const char* name;  // @ represents the side; null: no more links
  float share;       // of the path from the chain's parent to its limb's end
};
struct Chain {
  const char* root;  // null: the parent of the neck or the head
  std::array<Link, 4> links;
};
constexpr Chain kChains[] = {{nullptr, {{{"@Arm", 0.25f}, {"@ForeArm", 0.62f}, {"@Hand", 1}, {nullptr, 0}}}},
                             {"Hips", {{{"@UpLeg", 0.12f}, {"@Leg", 0.56f}, {"@Foot", 1}, {"@ToeBase", 1.15f}}}},
                             {nullptr, {{{"Neck", 0.4f}, {"Head", 1}, {nullptr, 0}, {nullptr, 0}}}},
                             {"Head", {{{"@Ear", 1}, {nullptr, 0}, {nullptr, 0}, {nullptr, 0}}}},
                             {"Head", {{{"Hair", 1}, {nullptr, 0}, {nullptr, 0}, {nullptr, 0}}}},
                             {nullptr, {{{"@Wing", 1}, {nullptr, 0}, {nullptr, 0}, {nullptr, 0}}}},
                             {"Hips", {{{"Tail", 1}, {nullptr, 0}, {nullptr, 0}, {nullptr, 0}}}}};

std::string with_side(const std::string& pattern, const std::string& side) {
  return pattern[0] == '@' ? side + pattern.substr(1) : pattern;
}

const Joint* find(const std::vector<Joint>& joints, const std::string& name) {
  const auto found = std::find_if(joints.begin(), joints.end(), [&](const Joint& one) { return one.name == name; });
  return found == joints.end() ? nullptr : &*found;
}

const Joint& chain_root(const std::vector<Joint>& joints, const Chain& chain, const std::string& wanted) {
  if (chain.root != nullptr) {
    if (const Joint* root = find(joints, chain.root)) return *root;
    throw Error(in_quotes(wanted) + " is a child of " + in_quotes(chain.root) +
                ", which the skeleton lacks; set that first");
  }
  for (const char* name : {"Neck", "Head"}) {
    const Joint* above = find(joints, name);
    if (above != nullptr && above->parent >= 0) return joints[static_cast<size_t>(above->parent)];
  }
  const Joint* last = find(joints, "Hips");
  for (const Joint& one : joints)
    if (one.name.rfind("Spine", 0) == 0 && one.name.find("_end") == std::string::npos) last = &one;
  if (last == nullptr)
    throw Error(in_quotes(wanted) +
                " is a child of the spine, which the skeleton lacks; set Hips, or add it with --add");
  return *last;
}

}  // namespace

std::vector<SkeletonEdit> marker_edits(const std::vector<Joint>& joints, const SkeletonEdit& marker) {
  for (const Chain& chain : kChains) {
    for (const std::string side : {"Left", "Right"}) {
      size_t at = 0;
      while (at < chain.links.size() && chain.links[at].name != nullptr &&
             with_side(chain.links[at].name, side) != marker.joint)
        ++at;
      if (at == chain.links.size() || chain.links[at].name == nullptr) continue;
      size_t first = at;  // of those that are missing
      while (first > 0 && find(joints, with_side(chain.links[first - 1].name, side)) == nullptr) --first;
      const Joint& root = first > 0 ? *find(joints, with_side(chain.links[first - 1].name, side))
                                    : chain_root(joints, chain, marker.joint);
      const float begin = first > 0 ? chain.links[first - 1].share : 0, end = chain.links[at].share;
      std::vector<SkeletonEdit> edits;
      std::string parent = root.name;
      for (size_t k = first; k <= at; ++k) {
        const float share = (chain.links[k].share - begin) / (end - begin);
        const Vec3 &from = root.position, &to = marker.position;
        SkeletonEdit edit;
        edit.kind = EditKind::kAdd;
        edit.joint = with_side(chain.links[k].name, side);
        edit.other = parent;
        edit.position = {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
                         from.z + share * (to.z - from.z)};
        parent = edit.joint;
        edits.push_back(std::move(edit));
      }
      return edits;
    }
  }
  throw Error("unknown joint " + in_quotes(marker.joint) +
              "; new joints can be Arm, ForeArm, Hand, UpLeg, Leg, Foot, ToeBase, Ear and Wing, with Left or Right "
              "before them, Neck, Head, Hair and Tail; use --add for others");
}

}  // namespace sinew
