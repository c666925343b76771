// SPDX-License-Identifier: MIT
// Joint by joint, by its whole name, or by its position.
#include "core/read_skeleton.hpp"
#include "mapping/hierarchy.hpp"

namespace sinew::mapping {
namespace {

// The source's joint of that name, looked for from `first` on: rigs often have one order.
int32_t find_name(const sinew_skeleton& rig, const char* name, uint32_t first) {
  for (uint32_t k = 0; k < rig.joint_count; ++k) {
    const uint32_t j = (first + k) % rig.joint_count;
    if (rig.names[j] != nullptr && same_text(rig.names[j], name)) return static_cast<int32_t>(j);
  }
  return -1;
}

}  // namespace

bool is_same_rig(const sinew_skeleton& target, const sinew_skeleton& source, const Hierarchy& own,
                 const Hierarchy& other, int32_t* sources, int32_t* targets) {
  if (target.names == nullptr || source.names == nullptr) return false;
  for (int32_t j = 0; j < other.n; ++j) targets[j] = -1;
  int32_t same = 0, alone = 0, next = 0;
  for (int32_t k = 0; k < own.n; ++k) {  // parents first
    const int32_t i = own.order[k];
    int32_t above = own.parent[i];
    while (above >= 0 && sources[above] < 0) above = own.parent[above];
    const char* const name = target.names[i];
    sources[i] = name == nullptr || name[0] == 0 ? -1 : find_name(source, name, static_cast<uint32_t>(next));
    if (sources[i] < 0) {
      const bool may_lack = own.kid_count(i) == 0 || above < 0;
      if (!may_lack || 2 * ++alone > own.n) return false;
      continue;
    }
    const int32_t j = sources[i];
    int32_t other_above = other.parent[j];
    while (other_above >= 0 && targets[other_above] < 0) other_above = other.parent[other_above];
    if (targets[j] >= 0 || other_above != (above < 0 ? -1 : sources[above])) return false;
    targets[j] = i;
    next = j + 1 < other.n ? j + 1 : 0;
    ++same;
  }
  for (int32_t j = 0; j < other.n; ++j) {
    int32_t above = targets[j] < 0 ? other.parent[j] : -1;
    while (above >= 0 && targets[above] < 0) above = other.parent[above];
    if (above >= 0 && other.kid_count(j) > 0) return false;
  }
  return 2 * same >= own.n && 2 * same >= other.n;
}

namespace {

// Pairs the children of two joints, the most alike first. False where two are not.
bool pair_kids(const Hierarchy& own, const Hierarchy& other, int32_t i, int32_t j, double scale, int32_t* sources,
               int32_t* targets) {
  constexpr double kBone = 0.3, kAnyway = 0.01;  // of a bone and of the size
  constexpr int32_t kMostKids = 64;              // more are compared in their order
  const int32_t kids = own.kid_count(i);
  if (kids != other.kid_count(j)) return false;
  const auto unlike = [&](int32_t a, int32_t b, double* most) {
    const Point x = scale * (own.at[a] - own.at[i]), y = other.at[b] - other.at[j];
    *most = kAnyway * other.size + kBone * greater(length(x), length(y));
    return length(x - y) + (own.count[a] == other.count[b] ? 0 : kAnyway * other.size);
  };
  for (int32_t round = 0; round < kids; ++round) {
    int32_t best_a = -1, best_b = -1;
    double least = 0;
    const int32_t first = kids > kMostKids ? round : 0, end = kids > kMostKids ? round + 1 : kids;
    for (int32_t k = first; k < end; ++k) {
      for (int32_t m = first; m < end; ++m) {
        const int32_t a = own.kid(i, k), b = other.kid(j, m);
        if (sources[a] >= 0 || targets[b] >= 0) continue;
        double most = 0;
        const double off = unlike(a, b, &most);
        if (best_a >= 0 && !(off < least)) continue;
        best_a = a;
        best_b = b;
        least = off;
      }
    }
    double most = 0;
    if (unlike(best_a, best_b, &most) > most) return false;
    sources[best_a] = best_b;
    targets[best_b] = best_a;
  }
  return true;
}

}  // namespace

bool is_same_shape(const Hierarchy& own, const Hierarchy& other, int32_t* sources, int32_t* targets) {
  if (own.n != other.n || own.n < 4 || own.kid_count(own.n) != 1 || other.kid_count(other.n) != 1) return false;
  for (int32_t k = 0; k < own.n; ++k) sources[k] = targets[k] = -1;
  sources[own.first_root()] = other.first_root();
  targets[other.first_root()] = own.first_root();
  int32_t other_parts = 0;
  for (int32_t k = 0; k < own.n; ++k) {  // parents first
    const int32_t i = own.order[k], j = sources[i];
    if (!pair_kids(own, other, i, j, other.size / own.size, sources, targets)) return false;
    if (!own.has_names || !other.has_names) continue;
    const JointName &a = own.names[i], &b = other.names[j];
    if (a.side != 0 && b.side != 0 && a.side != b.side) return false;
    other_parts += a.plain != Part::kNone && b.plain != Part::kNone && a.plain != b.plain ? 1 : 0;
  }
  return 10 * other_parts <= own.n;
}

}  // namespace sinew::mapping
