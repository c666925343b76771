// SPDX-License-Identifier: MIT
// Once front is known: hips, spine, chains beside it, arms, chest.
#include "mapping/anatomy.hpp"

namespace sinew::mapping {

void Anatomy::find_body() {
  const Hierarchy& r = *rig;
  if (quad && leg_count >= 2) {
    for (int32_t k = 1; k < leg_count; ++k) {  // from the rear, stable
      const LimbPair pair = legs[k];
      int32_t at_k = k;
      for (; at_k > 0 && pair_ahead(legs[at_k - 1]) > pair_ahead(pair); --at_k) legs[at_k] = legs[at_k - 1];
      legs[at_k] = pair;
    }
    hip_pair = legs[0];
    const int32_t a = limb(hip_pair.a).attach, b = limb(hip_pair.b).attach;
    const int32_t both = a >= 0 && b >= 0 ? r.common(b, a) : -1;
    if (both >= 0) hip = both;
    climb_to_trunk();
  }
  find_lying();
  take_spine(pick_spine());
  take_hips_from_floor();
  find_others();
  find_arms();
  find_chest();
  find_head();
}

// Fish, snakes: a body without legs that is longer than high. From the rear to the front it is its own line.
void Anatomy::find_lying() {
  lying = false;
  if (leg_count > 0) return;
  bool any = false;
  double rear = 0, front = 0, low = 0, high = 0;
  for (int32_t i = 0; i < rig->n; ++i) {
    if (side[i] != 0 || rig->apart[i] != 0) continue;
    const double a = ahead(at(i)), h = height[i];
    rear = any ? lesser(rear, a) : a;
    front = any ? greater(front, a) : a;
    low = any ? lesser(low, h) : h;
    high = any ? greater(high, h) : h;
    any = true;
  }
  lying = front - rear > high - low;
  const double half = greater(0.5 * (front - rear), 0.05 * rig->size);
  for (int32_t k = 0; k < 3 && lying; ++k) line[k] = at(hip) + (rear + k * half - ahead(at(hip))) * frame.front;
  if (lying) trunk = half;
}

int32_t Anatomy::pick_spine() {
  open_paths();
  double first = 0, last = 0;
  for (int32_t k = 0; k < leg_count; ++k) {
    first = k == 0 ? pair_ahead(legs[k]) : lesser(first, pair_ahead(legs[k]));
    last = k == 0 ? pair_ahead(legs[k]) : greater(last, pair_ahead(legs[k]));
  }
  const double size = rig->size;
  int32_t best = -1;
  double most = 0;
  for (int32_t k = rig->position[hip]; k < rig->position[hip] + rig->count[hip]; ++k) {
    const int32_t leaf = rig->order[k];
    if (!is_path_end(leaf)) continue;
    double carried = 0, top = height[leaf], foremost = 0;  // over the hips
    int32_t inner = 0;
    for (int32_t i = leaf; i != hip; i = rig->parent[i]) {
      for (int32_t b = limb_head[i]; b >= 0; b = limb_next[b])
        carried += 0.05 * root(limb(b).tree) + limb(b).length / size;
      top = greater(top, height[i]);
      foremost = greater(foremost, ahead(at(i) - at(hip)));
      inner += is_inner(ahead(at(i)), first, last) ? 1 : 0;
    }
    const double path = path_length(leaf), rise = top - height[hip], forward = ahead(at(leaf) - at(hip));
    double score = 2 * carried;
    score += quad ? (0.4 * path + 0.8 * rise + 1.5 * forward) / size : (0.6 * path + 1.5 * rise + 0.3 * forward) / size;
    if (lying) score = forward / size + 0.01 * path / size;    // what leads to the head
    if (leg_count > 2) score = 10 * carried + forward / size;  // of insects what carries jaws and feelers
    if (leg_count == 0 && !lying) score += 1.5 * path / size;
    if (quad) {
      score += 0.5 * inner;
      if (ahead(at(leaf)) > last - 0.15 * (last - first)) score += 1;
    }
    score += path_names(leaf);
    if (leads_to_legs(leaf)) score -= 20;
    if (lying && !(foremost > 0)) continue;  // a tail alone
    if (best >= 0 && !(score > most + 1e-9)) continue;
    best = leaf;
    most = score;
  }
  return best;
}

// A root on the floor with the legs on it: its child that leads on is the body.
void Anatomy::take_hips_from_floor() {
  if (leg_count == 0) return;
  int32_t from = 0;
  while (spine_count - from > 1 && height[hip] < ground + 0.06 * tall && height[spine[from]] > ground + 0.15 * tall) {
    hip = spine[from++];
  }
  // All legs on one joint between them: the hips are where the spine begins near the hind legs.
  if (quad && from == 0 && spine_count > 1 && common_attach(legs[leg_count - 1]) == hip) {
    const double hind = pair_ahead(legs[0]);
    if (absolute(ahead(at(spine[0])) - hind) < absolute(ahead(at(hip)) - hind)) hip = spine[from++];
  }
  for (int32_t k = from; k < spine_count; ++k) spine[k - from] = spine[k];
  spine_count -= from;
}

// Chains in the plane beside the spine: tail, jaw.
void Anatomy::find_others() {
  const Hierarchy& r = *rig;
  others_first = limbs.count;
  const auto look_at = [&](int32_t i) {
    each_kid(r, i, [&](int32_t kid) {
      if (side[kid] != 0 || r.end[kid] != 0 || r.holds(kid, hip)) return;
      for (int32_t k = 0; k < spine_count; ++k) {
        if (spine[k] == kid) return;
      }
      if (limbs.count - others_first < kMostSideLimbs) (void)limbs.begin(r, kid, 0, i);
    });
  };
  look_at(hip);
  for (int32_t k = 0; k < spine_count; ++k) look_at(spine[k]);
  for (int32_t i = r.parent[hip]; i >= 0; i = r.parent[i]) look_at(i);
  others_count = limbs.count - others_first;
  limbs.grow(r, side, others_first);
}

// Whiskers, ears: a child of a joint called head or jaw is not an arm.
bool Anatomy::is_on_face(int32_t number) const {
  const int32_t attach = limb(number).attach;
  if (!rig->has_names || attach < 0) return false;
  const Part part = rig->part(attach);
  return part == Part::kHead || part == Part::kJaw || part == Part::kHair;
}

// Short branches at the end of the spine: a bird's whiskers.
bool Anatomy::is_at_end(int32_t number) const {
  return leg_count > 0 && spine_count > 3 && limb(number).attach == spine[spine_count - 1] &&
         limb(number).length < 0.25 * limb(hip_pair.a).length;
}

void Anatomy::find_arms() {
  arms = LimbPair();
  double best = 0;
  for (int32_t k = 0; k < limbs.pair_count; ++k) {
    const LimbPair& pair = limbs.pairs[k];
    const Limb& a = limb(pair.a);
    if (pair.a == hip_pair.a || (is_leg(pair.a) && !quad) || is_on_face(pair.a) || is_at_end(pair.a)) continue;
    const double own = 0.02 * a.tree + a.length / rig->size;
    if (arms.a >= 0 && !(own > best || (own == best && limbs.joint(a, 0) < limbs.joint(limb(arms.a), 0)))) continue;
    best = own;
    arms = pair;
  }
  if (arms.a >= 0 && !(best > 0.12) && !is_leg(arms.a)) arms = LimbPair();
}

void Anatomy::find_chest() {
  const Hierarchy& r = *rig;
  chest = -1;
  if (arms.a >= 0 && spine_count > 0) {
    const int32_t attach = limb(arms.a).attach;
    for (int32_t k = 0; k < spine_count; ++k) {
      if (spine[k] == attach) chest = k;
    }
    if (chest < 0 && attach >= 0 && r.holds(attach, hip)) {
      const Point middle = 0.5 * (limbs.point(limb(arms.a), 0) + limbs.point(limb(arms.b), 0));
      double nearest = 0;
      for (int32_t k = 0; k < spine_count; ++k) {
        const double d = distance(middle, at(spine[k]));
        if (chest >= 0 && !(d < nearest)) continue;
        chest = k;
        nearest = d;
      }
      if (chest > 0 && chest == spine_count - 1 && !quad) --chest;  // something is left for the head
    }
  }
  const auto above_chest = [&](int32_t joint) {
    const Part word = r.part(joint);
    return r.has_names && (word == Part::kNeck || word == Part::kHead);
  };
  while (chest >= 0 && above_chest(spine[chest])) --chest;
  if (chest > 0 && !quad) {  // the neck is the parent of the arms: the chest is the joint below
    const double level = 0.5 * dot(limbs.point(limb(arms.a), 0) + limbs.point(limb(arms.b), 0), frame.up);
    if (chest + 1 < spine_count && head_of(chest + 1, spine[chest]) == chest + 1 &&
        height[spine[chest]] > level + 0.01 * tall && height[spine[chest - 1]] < level) {
      --chest;
    }
  }
  if (chest < 0 || quad || leg_count == 0) return;
  // A joint or two above the legs' common one in the hierarchy, on the same spot or on the legs' level: they are the hips.
  const double up_to_chest = greater(dot(at(spine[chest]) - at(hip), frame.up), 1e-9);
  const double level = 0.5 * dot(limbs.point(limb(hip_pair.a), 0) + limbs.point(limb(hip_pair.b), 0), frame.up);
  for (int32_t p = r.parent[hip]; p >= 0; p = r.parent[p]) {
    int32_t kids = 0;
    each_kid(r, p, [&](int32_t k) { kids += r.end[k] == 0 ? 1 : 0; });
    const bool on_level = absolute(height[p] - level) < 0.5 * absolute(height[hip] - level);
    if ((!on_level && !(absolute(height[p] - height[hip]) < 0.15 * up_to_chest + 1e-9)) || kids != 1 ||
        (r.parent[p] < 0 && !(height[p] > ground + 0.2 * tall)) || (r.has_names && r.part(hip) == Part::kHips)) {
      break;
    }
    for (int32_t k = spine_count; k > 0; --k) spine[k] = spine[k - 1];
    spine[0] = hip;
    ++spine_count;
    ++chest;
    hip = p;
  }
}

void Anatomy::find_head() {
  const Hierarchy& r = *rig;
  head = other_head = -1;
  if (lying) {  // one chain without landmarks
    chest = -1;
    arms = LimbPair();
    line_count = 3;
    return;
  }
  line_count = 1;
  line[0] = at(hip);
  const int32_t first = chest + 1;
  if (first < spine_count) {
    head = head_of(first, first > 0 ? spine[first - 1] : hip);
  } else if (chest >= 0 && quad) {
    head = spine_count - 1;
  }
  if (chest >= 0 && head >= 0 && head <= chest) chest = head > 0 ? head - 1 : -1;
  const int32_t upper = chest >= 0  ? spine[chest]
                        : head >= 0 ? spine[head]
                                    : (spine_count > 0 ? spine[spine_count - 1] : hip);
  Point top = at(upper);
  if (chest >= 0 && !quad &&
      arms.a >= 0) {  // one long bone from the hips to the shoulders: the chest is where arms begin
    const Point shoulders = 0.5 * (limbs.point(limb(arms.a), 0) + limbs.point(limb(arms.b), 0));
    const double level = dot(shoulders - at(hip), frame.up);
    if (level > 0.1 * tall && dot(top - at(hip), frame.up) < 0.6 * level) top = at(hip) + level * frame.up;
  }
  trunk = greater(distance(at(hip), top), 0.05 * r.size);
  if (head >= 0 && !r.has_names && head - 1 >= first && head == spine_count - 1 && !r.has_end_kid(spine[head]))
    other_head = head - 1;
  if (chest >= 0) line[line_count++] = top;
  if (head >= 0) line[line_count++] = at(spine[head]);
}

// Index in spine, from `first` on, of what is most likely a head; `base` is the joint before.
int32_t Anatomy::head_of(int32_t first, int32_t base) const {
  const Hierarchy& r = *rig;
  int32_t count = spine_count;
  for (int32_t k = first; k < count && r.has_names; ++k) {
    if (r.part(spine[k]) == Part::kHead && !r.names[spine[k]].is_end_of_map()) return k;
  }
  for (int32_t k = first; k < count; ++k) {
    int32_t kids = 0, central = 0, sided = 0;
    Point sum;
    each_kid(r, spine[k], [&](int32_t kid) {
      if (r.end[kid] != 0 || is_arm_root(kid)) return;
      ++kids;
      if (side[kid] == 0) {
        ++central;
      } else {
        ++sided;
        sum = sum + at(kid);
      }
    });
    if (kids < 2) continue;
    if (k + 1 < count && sided > 0 && central == 1) {  // ears that sit nearer to the next joint: that one is the head
      const Point ears = (1.0 / sided) * sum;
      if (distance(ears, at(spine[k + 1])) < 0.7 * distance(ears, at(spine[k]))) return k + 1;
    }
    return k;
  }
  if (count - first == 1) return first;
  const Point trunk_way = at(base) - at(hip);
  if (!quad && dot(trunk_way, frame.up) >= 0.5 * length(trunk_way)) {  // a plait hangs down: the head is before it
    for (int32_t k = first + 1; k < count; ++k) {
      if (height[spine[k]] < height[spine[k - 1]] - 1e-6 * r.size) {
        count = k;
        break;
      }
    }
  }
  if (count - first == 1) return first;
  const int32_t last = spine[count - 1], before = spine[count - 2];
  const double bone = r.bone(last, before), bone_before = r.bone(before, count - 3 >= first ? spine[count - 3] : base);
  return bone > 1.15 * bone_before && !r.has_end_kid(last) ? count - 2 : count - 1;
}

double Anatomy::head_ratio(int32_t spine_index) const {
  const auto second = [&](int32_t l) {
    return limbs.point(limb(l), limb(arms.a).point_count > 1 && limb(l).point_count > 1 ? 1 : 0);
  };
  const Point shoulders = 0.5 * (second(arms.a) + second(arms.b));
  return distance(at(spine[spine_index]), shoulders) / greater(distance(shoulders, at(hip)), 1e-9);
}

double Anatomy::trunk_position(const Point& p) const {
  double nearest = 0, position = 0;
  for (int32_t k = 0; k + 1 < line_count; ++k) {
    const Point d = line[k + 1] - line[k];
    const double t =
        clamped(dot(p - line[k], d) / greater(dot(d, d), 1e-12), k == 0 ? -1 : 0, k + 2 < line_count ? 1 : 2);
    const double e = distance(p, line[k] + t * d);
    if (k > 0 && !(e < nearest - 1e-9)) continue;
    nearest = e;
    position = k + t;
  }
  return position;
}

int32_t Anatomy::thumb(const Limb& hand, const int32_t* fingers, int32_t count) const {
  const Point w = wrist(hand);
  Point sum;
  for (int32_t k = 0; k < count; ++k) sum = sum + limbs.last_point(limb(fingers[k]));
  Point along = (1.0 / count) * sum - w;
  const double l = length(along);
  if (l < 1e-9) return fingers[0];
  along = (1 / l) * along;
  double reach = 0;
  for (int32_t k = 0; k < count; ++k) {
    const Limb& f = limb(fingers[k]);
    for (int32_t i = 0; i < f.point_count; ++i) {
      const double own = dot(limbs.point(f, i) - w, along);
      reach = k == 0 && i == 0 ? own : greater(reach, own);
    }
  }
  if (reach == 0) reach = 1;
  int32_t best = fingers[0];
  double least = 0;
  for (int32_t k = 0; k < count; ++k) {
    const Limb& f = limb(fingers[k]);
    const Point own = f.point_count > 1 ? limbs.last_point(f) - limbs.point(f, 0) : limbs.point(f, 0) - w;
    const double score =
        dot(limbs.mean_point(f) - w, along) / reach + 0.7 * dot(own, along) / greater(length(own), 1e-9);
    if (k > 0 && !(score < least)) continue;
    least = score;
    best = fingers[k];
  }
  return best;
}

}  // namespace sinew::mapping
