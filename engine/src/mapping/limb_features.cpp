// SPDX-License-Identifier: MIT
// Features by which limbs are compared: attachment, length, direction, names.
#include "mapping/anatomy.hpp"

namespace sinew::mapping {

// Legs of an insect may have one parent: they are distinguished by their ends.
double Anatomy::leg_rank(int32_t number) const {
  if (leg_count < 3 || !is_leg(number)) return -1;
  const auto reach = [&](int32_t k) {
    return ahead(limbs.last_point(limb(legs[k].a)) + limbs.last_point(limb(legs[k].b)));
  };
  double own = 0;
  for (int32_t k = 0; k < leg_count; ++k) {
    if (legs[k].a == number || legs[k].b == number) own = reach(k);
  }
  int32_t behind = 0;
  for (int32_t k = 0; k < leg_count; ++k) behind += reach(k) < own ? 1 : 0;
  return static_cast<double>(behind) / (leg_count - 1);
}

void Anatomy::find_features() {
  const Hierarchy& r = *rig;
  hashes_used = 0;
  for (int32_t k = 0; k < limbs.count; ++k) {
    const Limb& l = limb(k);
    LimbFeatures& f = features[k];
    f = LimbFeatures();
    const Point& start = limbs.point(l, 0);
    f.attach = trunk_position(start - (dot(start, frame.across) - frame.plane) * frame.across);
    f.log_length = logarithm(greater(l.length, 0.02 * r.size) / trunk);
    f.log_tree = logarithm(l.tree);
    const Point axis =
        direction(l.point_count > 1 ? limbs.last_point(l) - start : (l.attach >= 0 ? start - at(l.attach) : Point()));
    f.axis = {dot(axis, frame.across) * (l.side != 0 ? l.side : 1), dot(axis, frame.up), ahead(axis)};
    const double low = limbs.lowest(l, frame.up);
    f.point = l.point_count == 1;
    f.grounded = is_leg(k) || (!lying && low < ground + 0.12 * tall && dot(start, frame.up) - low > 0.1 * tall);
    f.hip = hip_pair.a == k || hip_pair.b == k;
    f.arm = arms.a == k || arms.b == k;
    f.rank = leg_rank(k);
    f.first_hash = hashes_used;
    if (!r.has_names) continue;
    for (int32_t i = 0; i < l.joint_count; ++i) {
      const JointName& name = r.names[limbs.joint(l, i)];
      const Part word = limb_part(name.plain);
      if (word != Part::kNone) f.parts |= uint64_t{1} << static_cast<uint32_t>(word);
      for (int32_t w = 0; w < name.count; ++w) {
        if ((name.long_mask >> w & 1) == 0) continue;
        bool known = false;
        for (int32_t h = f.first_hash; h < hashes_used; ++h) known = known || hashes[h] == name.hashes[w];
        if (!known) hashes[hashes_used++] = name.hashes[w];
      }
    }
    f.hash_count = hashes_used - f.first_hash;
  }
}

}  // namespace sinew::mapping
