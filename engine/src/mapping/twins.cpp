// SPDX-License-Identifier: MIT
// Bones of the same lengths on two children of one joint, found from the root down.
#include "mapping/frame.hpp"

namespace sinew::mapping {
namespace {

constexpr double kSame = 0.02;        // of a length, and of the rig's size for short ones a fifth of it
constexpr int32_t kFewestJoints = 3;  // joints of a limb
constexpr int32_t kMostTwins = 16;

struct Twins {
  const Hierarchy& rig;
  int32_t* mate;  // [n]
  int32_t roots[kMostTwins][2];
  int32_t root_count = 0, joints = 0;

  bool same(double a, double b) const { return absolute(a - b) <= kSame * greater(a, 0.2 * rig.size); }
  bool alike(int32_t a, int32_t b) const {
    return rig.count[a] == rig.count[b] && same(rig.reach[a], rig.reach[b]) &&
           same(rig.bone(a, rig.parent[a]), rig.bone(b, rig.parent[b]));
  }
  // The only child of a joint that is like `kid`; -1 = none or several, as of a spider.
  int32_t only_like(int32_t joint, int32_t kid) const {
    int32_t found = -1, count = 0;
    each_kid(rig, joint, [&](int32_t k) {
      if (k == kid || !alike(k, kid)) return;
      found = k;
      ++count;
    });
    return count == 1 ? found : -1;
  }
  void find() {
    for (int32_t i = 0; i < rig.n; ++i) mate[i] = -1;
    for (int32_t k = 0; k < rig.n; ++k) {
      const int32_t i = rig.order[k], p = rig.parent[i];
      if (p < 0 || mate[i] >= 0) continue;
      if (mate[p] < 0) {
        begin(i);
      } else {
        go_on(i, mate[p]);
      }
    }
  }

 private:
  void begin(int32_t i) {
    if (rig.count[i] < kFewestJoints || !(rig.reach[i] > 0.1 * rig.size) || root_count == kMostTwins) return;
    const int32_t other = only_like(rig.parent[i], i);
    if (other < 0) return;
    roots[root_count][0] = i;
    roots[root_count++][1] = other;
    pair(i, other);
  }
  void go_on(int32_t i, int32_t above) {
    int32_t best = -1;
    double least = 0;
    each_kid(rig, above, [&](int32_t k) {
      const double off = absolute(rig.bone(k, above) - rig.bone(i, rig.parent[i]));
      if (mate[k] >= 0 || !alike(k, i) || (best >= 0 && !(off < least))) return;
      best = k;
      least = off;
    });
    if (best >= 0) pair(i, best);
  }
  void pair(int32_t a, int32_t b) {
    mate[a] = b;
    mate[b] = a;
    joints += 2;
  }
};

}  // namespace

void take_twins(const Hierarchy& rig, const Point* up, int32_t* twin, Frame* frame) {
  Twins twins = {rig, twin, {}};
  twins.find();
  int32_t mirrored = 0;
  for (int32_t i = 0; i < rig.n; ++i) mirrored += twin[i] >= 0 && frame->mate[i] == twin[i] ? 1 : 0;
  frame->posed = twins.root_count >= 2 && 5 * twins.joints >= 2 * rig.n && 3 * mirrored < twins.joints;
  if (!frame->posed) return;
  Point sum, middle;
  for (int32_t k = 0; k < twins.root_count; ++k) {
    int32_t* const pair = twins.roots[k];
    Point d = direction(rig.at[pair[0]] - rig.at[pair[1]]);
    const int8_t said = rig.names[pair[0]].side;
    if (rig.has_names && said != 0 ? said < 0 : dot(d, sum) < 0) {
      const int32_t first = pair[0];
      pair[0] = pair[1];
      pair[1] = first;
      d = -d;
    }
    sum = sum + d;
    middle = middle + rig.at[rig.parent[pair[0]]];
  }
  if (up != nullptr) sum = sum - dot(sum, *up) * *up;
  if (!(length(sum) > 0.3)) {
    frame->posed = false;
    return;
  }
  frame->across = direction(sum);
  frame->plane = dot((1.0 / twins.root_count) * middle, frame->across);
  for (int32_t i = 0; i < rig.n; ++i) {
    frame->mate[i] = twin[i];
    twin[i] = 0;  // from here on the side
  }
  for (int32_t k = 0; k < twins.root_count; ++k) {
    twin[twins.roots[k][0]] = 1;
    twin[twins.roots[k][1]] = -1;
  }
  for (int32_t i = 0; i < rig.n; ++i) frame->side[i] = static_cast<int8_t>(twin[i]);
}

}  // namespace sinew::mapping
