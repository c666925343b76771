// SPDX-License-Identifier: MIT
// From branches that go together to a source for every joint: the cheapest, crossings, crossroads, what is left over.
#include "mapping/map.hpp"
#include "published/branches.hpp"
#include "sinew/published.h"

namespace sinew::mapping {
namespace {

constexpr int32_t kCrossroad = 3;                       // bones
constexpr uint64_t kMostAutoCells = uint64_t{1} << 22;  // pairs of joints that are compared without being asked

}  // namespace

// Calls body(t, s) for all pairs of joints of the chosen pairs of branches.
template <class Body>
void Branches::each_pair(bool target_first, const Body& body) {
  const int32_t count = target_first ? a_.branches : b_.branches;
  for (int32_t k = 0; k < count; ++k) {
    a_.take(target_first ? k : choice_[k]);
    b_.take(target_first ? choice_[k] : k);
    (void)compare(false);
    const bool turned = a_.length > b_.length;
    const int32_t n = turned ? b_.length : a_.length, m = turned ? a_.length : b_.length;
    for (int32_t i = n, j = m; i > 0; --i, --j) {
      while (better_[static_cast<size_t>(i) * (static_cast<size_t>(m) + 1) + static_cast<size_t>(j)] == 0) --j;
      body(turned ? a_.chain[j - 1] : a_.chain[i - 1], turned ? b_.chain[i - 1] : b_.chain[j - 1]);
    }
  }
}

void Branches::keep_pairs(bool target_first, int32_t* sources, double* costs) {
  each_pair(target_first, [&](int32_t t, int32_t s) {
    const double cost = stored_cost(t, s);
    if (!same_side(t, s) || (sources[t] >= 0 && !(cost < costs[t]))) return;
    sources[t] = s;
    costs[t] = cost;
  });
}

// A joint that crosses the path of one above gets the cheapest of its other sources that does not, else the other
// root.
void Branches::settle_crossings(bool target_first, int32_t* sources, double* costs) {
  const Hierarchy &a = *a_.rig, &b = *b_.rig;
  bool any = false;
  for (int32_t k = 0; k < a.n; ++k) {
    const int32_t t = a.order[k];
    open_[t] = 0;
    if (sources[t] < 0) continue;
    for (int32_t i = a.parent[t]; i >= 0; i = a.parent[i]) {
      if (sources[i] < 0 || sources[i] == sources[t] || !b.holds(sources[t], sources[i])) continue;
      open_[t] = 1;
    }
    if (open_[t] == 0) continue;
    any = true;
    sources[t] = -1;
  }
  if (!any) return;
  each_pair(target_first, [&](int32_t t, int32_t s) {
    if (open_[t] == 0 || !same_side(t, s)) return;
    const double cost = stored_cost(t, s);
    if (sources[t] >= 0 && !(cost < costs[t])) return;
    if (crosses(t, s, sources)) return;
    sources[t] = s;
    costs[t] = cost;
  });
  for (int32_t k = 0; k < a.n; ++k) {
    const int32_t t = a.order[k];
    if (open_[t] == 0 || sources[t] >= 0) continue;
    sources[t] = b_.root;
    costs[t] = stored_cost(t, b_.root);
  }
}

// A source joint that moves and has more than three bones, and that nothing follows, gets the target that costs least, crosses
// nothing and does not follow another such joint.
void Branches::serve_crossroads(const uint8_t* animated, int32_t* sources, double* costs) {
  const Hierarchy &a = *a_.rig, &b = *b_.rig;
  const auto is_crossroad = [&](int32_t s) {
    return b_.node[s] != 0 && b_.degree(s) > kCrossroad && (animated == nullptr || animated[s] != 0);
  };
  for (int32_t k = 0; k < b.n; ++k) {
    const int32_t s = b.order[k];
    if (!is_crossroad(s)) continue;
    bool served = false;
    for (int32_t t = 0; t < a.n && !served; ++t) served = sources[t] == s;
    if (served) continue;
    int32_t best = -1;
    double least = 0;
    for (int32_t t = 0; t < a.n; ++t) {
      if (a_.node[t] == 0 || t == a_.root || (sources[t] >= 0 && is_crossroad(sources[t]))) continue;
      const double cost = stored_cost(t, s);
      if (!same_side(t, s) || (best >= 0 && !(cost < least)) || crosses(t, s, sources)) continue;
      best = t;
      least = cost;
    }
    if (best < 0) continue;
    sources[best] = s;
    costs[best] = least;
  }
}

double Branches::run(uint32_t first, bool mean, const uint8_t* animated, int32_t* sources, double* costs) {
  const Hierarchy &a = *a_.rig, &b = *b_.rig;
  const uint64_t cells = static_cast<uint64_t>(a.n) * static_cast<uint64_t>(b.n);
  use_table_ = cells <= kMostBranchPairs;
  for (int32_t i = 0; i < a.n; ++i) {
    sources[i] = -1;
    costs[i] = 0;
    for (int32_t j = 0; j < b.n && use_table_; ++j) table_[i * b.n + j] = joint_cost(i, j);
  }
  for (int32_t i = 0; i < a_.branches; ++i) {
    a_.take(i);
    double* const row = costs_ + static_cast<size_t>(i) * static_cast<size_t>(b_.branches);
    for (int32_t j = 0; j < b_.branches; ++j) {
      b_.take(j);
      row[j] = compare(mean);
    }
  }
  bool target_first = first != SINEW_BRANCHES_SOURCE;
  if (first == SINEW_BRANCHES_BOTH) target_first = !(choose(false) < choose(true));
  (void)choose(target_first);
  keep_pairs(target_first, sources, costs);
  sources[a_.root] = b_.root;
  costs[a_.root] = stored_cost(a_.root, b_.root);
  settle_crossings(target_first, sources, costs);
  serve_crossroads(animated, sources, costs);
  double sum = 0;
  int32_t pairs = 0;
  for (int32_t i = 0; i < a.n; ++i) {
    if (sources[i] < 0) continue;
    sum += costs[i];
    ++pairs;
  }
  fill_in(sources, costs);
  map_outside(sources, costs);
  return sum / pairs;
}

// Whether t -> s would cross the path of an ancestor or of a descendant.
bool Branches::crosses(int32_t t, int32_t s, const int32_t* sources) const {
  const Hierarchy &a = *a_.rig, &b = *b_.rig;
  for (int32_t i = a.parent[t]; i >= 0; i = a.parent[i]) {
    if (sources[i] >= 0 && sources[i] != s && b.holds(s, sources[i])) return true;
  }
  for (int32_t k = a.position[t] + 1; k < a.position[t] + a.count[t]; ++k) {
    const int32_t below = sources[a.order[k]];
    if (below >= 0 && below != s && b.holds(below, s)) return true;
  }
  return false;
}

void Branches::fill_in(int32_t* sources, double* costs) {
  const Hierarchy &a = *a_.rig, &b = *b_.rig;
  for (int32_t k = a.n - 1; k >= 0; --k) {  // a child's, else the parent's
    const int32_t t = a.order[k];
    if (sources[t] >= 0 || a_.node[t] == 0) continue;
    int32_t taken = -1;
    each_kid(a, t, [&](int32_t kid) {
      if (taken < 0 && sources[kid] >= 0 && !crosses(t, sources[kid], sources)) taken = sources[kid];
    });
    const int32_t p = a.parent[t];
    if (taken < 0 && p >= 0 && sources[p] >= 0 && !crosses(t, sources[p], sources)) taken = sources[p];
    if (taken < 0) continue;
    sources[t] = taken;
    costs[t] = stored_cost(t, taken);
  }
  for (int32_t j = 0; j < b.n; ++j) used_[j] = 0;
  for (int32_t i = 0; i < a.n; ++i) {
    if (sources[i] >= 0) used_[sources[i]] = 1;
  }
  for (int32_t k = 0; k < a.n; ++k) {  // an idle joint for one of two on the same source
    const int32_t t = a.order[k], p = a.parent[t];
    if (p < 0 || sources[t] < 0 || sources[p] != sources[t]) continue;
    for (int32_t c = 0; c < b.kid_count(sources[p]); ++c) {
      const int32_t idle = b.kid(sources[p], c);
      if (used_[idle] != 0 || b_.node[idle] == 0 || !same_side(t, idle) || crosses(t, idle, sources)) continue;
      sources[t] = idle;
      costs[t] = stored_cost(t, idle);
      used_[idle] = 1;
      break;
    }
  }
}

// Joints that are no nodes: joints above the roots, from the roots up, and ends by the joints that they end.
void Branches::map_outside(int32_t* sources, double* costs) {
  const Hierarchy &a = *a_.rig, &b = *b_.rig;
  for (int32_t t = a.parent[a_.root], s = b.parent[b_.root]; t >= 0 && s >= 0; t = a.parent[t], s = b.parent[s]) {
    sources[t] = a.parent[t] < 0 ? b.first_root() : s;
    costs[t] = stored_cost(t, sources[t]);
  }
  for (int32_t j = 0; j < b.n; ++j) used_[j] = 0;
  for (int32_t k = 0; k < a.n; ++k) {
    const int32_t t = a.order[k], p = a.parent[t];
    if (a.end[t] == 0 || p < 0 || sources[t] >= 0 || sources[p] < 0) continue;
    double least = 0;
    each_kid(b, sources[p], [&](int32_t kid) {
      const double cost = distance(a_.at[t], b_.at[kid]);
      if (b.end[kid] == 0 || used_[kid] != 0 || (sources[t] >= 0 && !(cost < least))) return;
      sources[t] = kid;
      least = cost;
    });
    if (sources[t] < 0) continue;
    used_[sources[t]] = 1;
    costs[t] = stored_cost(t, sources[t]);
  }
}

sinew_status map_branches(const MapPlan& plan, const Anatomy& target, const Anatomy& source, bool wanted, Arena& arena,
                          int32_t* sources, double* costs, double* cost) {
  const ArenaScope scope(arena);
  const sinew_map_options& o = plan.options;
  Branches branches;
  if (!branches.allocate(arena, plan.target.joint_count, plan.source.joint_count)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring() || !wanted) return SINEW_OK;
  const bool asked = o.method == SINEW_MAP_BRANCHES;
  const uint64_t cells = branches.prepare(target, o.target_areas, source, o.source_areas);
  if (asked && cells == UINT64_MAX) return SINEW_ERROR_COUNT;
  if (asked || cells < kMostAutoCells)
    *cost = branches.run(o.branches_first, o.branches_cost == SINEW_BRANCHES_MEAN, o.source_animated, sources, costs);
  return SINEW_OK;
}

}  // namespace sinew::mapping
