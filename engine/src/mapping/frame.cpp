// SPDX-License-Identifier: MIT
// The mirror plane by joints: mirrored ones should lie near others of their depth. Up by where limbs end.
#include "mapping/frame.hpp"

#include "core/sort.hpp"

namespace sinew::mapping {
namespace {

constexpr double kNear = 0.05;  // share of the size: as near as this is a mirror image
constexpr double kOff = 0.02;   // share of the size: off the plane
constexpr double kAlone = 0.06, kAlonePrice = 0.3;
constexpr double kBetter = 0.3;   // a later normal has to be better by that
constexpr double kTilted = 0.26;  // sine of the most that a rig may lean
constexpr int kAxes = 3, kFromPairs = 12;
constexpr int kMostSiblings = 64;  // of a joint's children, those that carry most

struct Normals {
  Point at[kAxes + kFromPairs];
  int count = 0;
};

struct Sibling {
  int32_t weight, joint, a, b;  // joints of both, parent, the two

  bool before(const Sibling& o) const {
    if (weight != o.weight) return weight > o.weight;
    if (joint != o.joint) return joint < o.joint;
    return a != o.a ? a < o.a : b < o.b;
  }
};

// Axes, then the directions between siblings with subtrees of about equal size, largest first.
struct NormalFinder {
  const Hierarchy& rig;
  Point* middle;     // [n] mean position of a subtree
  int32_t* sibling;  // [n] scratch

  bool allocate(Arena& arena, uint32_t joints) {
    middle = arena.alloc<Point>(joints);
    sibling = arena.alloc<int32_t>(joints);
    return arena.ok();
  }
  Normals find() {
    Normals normals;
    normals.at[0] = {1, 0, 0};
    normals.at[1] = {0, 1, 0};
    normals.at[2] = {0, 0, 1};
    normals.count = kAxes;
    for (int32_t i = 0; i < rig.n; ++i) middle[i] = rig.at[i];
    for (int32_t k = rig.n - 1; k >= 0; --k) {
      const int32_t i = rig.order[k];
      if (rig.parent[i] >= 0) middle[rig.parent[i]] = middle[rig.parent[i]] + middle[i];
    }
    for (int32_t i = 0; i < rig.n; ++i) middle[i] = (1.0 / rig.count[i]) * middle[i];
    Sibling best[kFromPairs];
    int found = 0;
    for (int32_t i = 0; i < rig.n; ++i) {
      int32_t kids = 0;
      each_kid(rig, i, [&](int32_t k) { sibling[kids++] = k; });
      if (kids > kMostSiblings) {
        heap_sort(sibling, static_cast<size_t>(kids), [&](int32_t a, int32_t b) {
          return rig.count[a] != rig.count[b] ? rig.count[a] > rig.count[b] : a < b;
        });
        kids = kMostSiblings;
        sort_ascending(sibling, static_cast<size_t>(kids));
      }
      for (int32_t a = 0; a < kids; ++a) {
        for (int32_t b = a + 1; b < kids; ++b) {
          const int32_t x = rig.count[sibling[a]], y = rig.count[sibling[b]];
          if (10 * (x < y ? x : y) < 7 * (x < y ? y : x)) continue;
          const Sibling one = {x + y, i, sibling[a], sibling[b]};
          if (found == kFromPairs && !one.before(best[found - 1])) continue;
          if (!(length(middle[one.a] - middle[one.b]) > 0.03 * rig.size)) continue;
          int at = found < kFromPairs ? found++ : found - 1;
          for (; at > 0 && one.before(best[at - 1]); --at) best[at] = best[at - 1];
          best[at] = one;
        }
      }
    }
    for (int k = 0; k < found; ++k) {
      const Point d = middle[best[k].a] - middle[best[k].b];
      normals.at[normals.count++] = (1 / length(d)) * d;
    }
    return normals;
  }
};

struct MirrorScore {
  const Hierarchy& rig;
  double* along;     // [n] P.normal
  int32_t* line;     // [body] joints of the body by depth, then along the normal
  int32_t* first;    // [n + 1] where a depth begins in `line`
  int32_t* trial;    // [n]
  int32_t* mate;     // [n] of the best plane
  int32_t body = 0;  // joints of it
  double plane = 0;

  bool allocate(Arena& arena, uint32_t joints) {
    along = arena.alloc<double>(joints);
    line = arena.alloc<int32_t>(joints);
    first = arena.alloc<int32_t>(size_t{joints} + 2);
    trial = arena.alloc<int32_t>(joints);
    mate = arena.alloc<int32_t>(joints);
    return arena.ok();
  }
  void prepare() {
    for (int32_t d = 0; d <= rig.n + 1; ++d) first[d] = 0;
    for (int32_t i = 0; i < rig.n; ++i) first[rig.depth[i] + 1] += rig.apart[i] == 0 ? 1 : 0;
    for (int32_t d = 0; d <= rig.n; ++d) first[d + 1] += first[d];
  }
  // Best of four planes across `normal`; leaves its mates.
  double score(const Point& normal) {
    double sum = 0;
    body = 0;
    for (int32_t i = 0; i < rig.n; ++i) {
      along[i] = dot(rig.at[i], normal);
      if (rig.apart[i] != 0) continue;
      line[body++] = i;
      sum += along[i];
    }
    heap_sort(line, static_cast<size_t>(body),
              [&](int32_t a, int32_t b) { return along[a] != along[b] ? along[a] < along[b] : a < b; });
    const double low = along[line[0]], high = along[line[body - 1]];
    const double median = 0.5 * (along[line[(body - 1) / 2]] + along[line[body / 2]]);
    heap_sort(line, static_cast<size_t>(body), [&](int32_t a, int32_t b) {
      if (rig.depth[a] != rig.depth[b]) return rig.depth[a] < rig.depth[b];
      return along[a] != along[b] ? along[a] < along[b] : a < b;
    });
    const double planes[4] = {along[rig.first_of_body()], sum / body, median, 0.5 * (low + high)};
    double best = -1e30;
    for (const double o : planes) {
      const double own = score_plane(normal, o);
      if (!(own > best + 1e-9)) continue;
      best = own;
      plane = o;
      for (int32_t i = 0; i < rig.n; ++i) mate[i] = trial[i];
    }
    return best;
  }

 private:
  double score_plane(const Point& normal, double o) {
    const double near = kNear * rig.size;
    double sum = 0;
    for (int32_t i = 0; i < rig.n; ++i) {
      trial[i] = -1;
      if (rig.apart[i] != 0) continue;
      const double off = along[i] - o;
      if (!(absolute(off) > kOff * rig.size)) continue;
      const Point image = rig.at[i] - (2 * off) * normal;
      const double low = o - off - near * 1.001, high = o - off + near * 1.001;
      int32_t from = first[rig.depth[i]], to = first[rig.depth[i] + 1];
      const int32_t last = to;
      while (from < to) {
        const int32_t half = (from + to) / 2;
        if (along[line[half]] < low) {
          from = half + 1;
        } else {
          to = half;
        }
      }
      double nearest = near * near;
      int32_t j = -1;
      for (; from < last && along[line[from]] <= high; ++from) {
        const Point d = image - rig.at[line[from]];
        const double squared = dot(d, d);
        if (squared < nearest || (squared == nearest && j >= 0 && line[from] < j)) {
          nearest = squared;
          j = line[from];
        }
      }
      if (j < 0 || j == i || !(off * (along[j] - o) < 0)) {
        // Joints without a sibling should lie in the plane.
        if (absolute(off) > kAlone * rig.size) sum -= kAlonePrice;
        continue;
      }
      trial[i] = j;
      const double x = rig.count[i], y = rig.count[j];
      sum += (1 - 0.7 * root(nearest) / near) * (lesser(x, y) / greater(x, y));  // images carry about as much
    }
    return sum;
  }
};

// Points to where limbs with a mirror image do not end: along which of the axes in the plane they end together lowest.
struct UpFinder {
  const Hierarchy& rig;
  const int32_t* mate;
  double* height;   // [n]
  double* descent;  // [n] of the limb that begins at a joint; below 0 = none

  double value(const Point& up) {
    double low = 0, lowest = 0, highest = 0, center = 0;
    int32_t pairs = 0, singles = 0;
    for (int32_t i = 0; i < rig.n; ++i) {
      height[i] = dot(rig.at[i], up);
      descent[i] = -1;
      if (rig.apart[i] != 0) continue;
      lowest = pairs + singles == 0 ? height[i] : lesser(lowest, height[i]);
      highest = pairs + singles == 0 ? height[i] : greater(highest, height[i]);
      if (mate[i] >= 0) {
        low = pairs++ == 0 ? height[i] : lesser(low, height[i]);
      } else {
        center += height[i];
        ++singles;
      }
    }
    const double extent = greater(highest - lowest, 1e-9);
    double value = 0;
    if (pairs > 0) {
      for (int32_t i = 0; i < rig.n; ++i) {
        if (mate[i] < 0 || !(height[i] < low + 0.08 * extent)) continue;
        int32_t j = i;
        double sum = 0;
        while (rig.parent[j] >= 0 && mate[rig.parent[j]] >= 0) {
          sum += greater(0, height[rig.parent[j]] - height[j]);
          j = rig.parent[j];
        }
        descent[j] = greater(descent[j], sum);
      }
      int32_t limbs = 0;
      for (int32_t i = 0; i < rig.n; ++i) {
        if (descent[i] < 0) continue;
        value += descent[i];
        ++limbs;
      }
      value = value / rig.size + 0.02 * (limbs < 4 ? limbs : 4);
    }
    return value + 0.1 * ((singles > 0 ? center / singles : 0) - lowest) / extent;
  }
};

}  // namespace

bool Frame::allocate(Arena& arena, uint32_t joints) {
  mate = arena.alloc<int32_t>(joints);
  side = arena.alloc<int8_t>(joints);
  return arena.ok();
}

bool find_frame(const Hierarchy& rig, const Point* up, Arena& arena, Frame* frame) {
  const ArenaScope scope(arena);
  const uint32_t joints = static_cast<uint32_t>(rig.n);
  NormalFinder finder = {rig, nullptr, nullptr};
  MirrorScore mirror = {rig, nullptr, nullptr, nullptr, nullptr, nullptr};
  (void)finder.allocate(arena, joints);
  (void)mirror.allocate(arena, joints);
  double* const descent = arena.alloc<double>(joints);
  if (!arena.ok()) return false;
  if (arena.measuring()) return true;
  mirror.prepare();
  const Normals normals = finder.find();
  bool found = false;
  for (int k = 0; k < normals.count; ++k) {
    Point normal = normals.at[k];
    if (up != nullptr) {
      const double lean = dot(normal, *up);
      if (absolute(lean) > kTilted) normal = normal - lean * *up;
      const double l = length(normal);
      if (l < 0.5) continue;
      normal = (1 / l) * normal;
    }
    const double score = mirror.score(normal);
    if (found && !(score > frame->symmetry + kBetter)) continue;
    found = true;
    frame->symmetry = score;
    frame->plane = mirror.plane;
    frame->across = normal;
    for (int32_t i = 0; i < rig.n; ++i) frame->mate[i] = mirror.mate[i];
  }
  take_twins(rig, up, mirror.trial, frame);
  if (up != nullptr) {
    frame->up = *up;
  } else {
    UpFinder guess = {rig, frame->mate, mirror.along, descent};
    frame->up = {0, 1, 0};
    int64_t best = 0;
    bool any = false;
    for (int k = 0; k < 2 * kAxes; ++k) {
      Point u = normals.at[k / 2];
      u = u - dot(u, frame->across) * frame->across;
      const double l = length(u);
      if (!(l > 0.7)) continue;
      u = (k % 2 == 0 ? 1 / l : -1 / l) * u;
      const int64_t value = rounded(guess.value(u));
      if (any && value <= best) continue;
      any = true;
      best = value;
      frame->up = u;
    }
  }
  frame->front = cross(frame->across, frame->up);
  return true;
}

}  // namespace sinew::mapping
