// SPDX-License-Identifier: MIT
// Node costs, the cheapest order-preserving assignment of two branches, mirrored branches together, fill-in.
#include "mapping/branches.hpp"

namespace sinew::mapping {
namespace {

constexpr double kPosition = 10, kRatio = 2, kCentrality = 0.2, kDegree = 1;  // weights as published
constexpr double kMirrored = 0.1;  // branches that are less alike are no pair

uint64_t table_cells(uint64_t target, uint64_t source) {
  return target * source < kMostBranchPairs ? target * source : kMostBranchPairs;
}

}  // namespace

bool Branches::Rig::allocate(Arena& arena, uint32_t joints) {
  at = arena.alloc<Point>(joints);
  root_distance = arena.alloc<double>(joints);
  leaves = arena.alloc<int32_t>(joints);
  mirror = arena.alloc<int32_t>(joints);
  through = arena.alloc<int32_t>(joints);
  chain = arena.alloc<int32_t>(joints);
  ratio = arena.alloc<double>(joints);
  return arena.ok();
}

void Branches::Rig::prepare(const Hierarchy& hierarchy, const Frame& frame) {
  rig = &hierarchy;
  const Point root_at = rig->at[rig->first_root()];
  double farthest = 0;
  for (int32_t i = 0; i < rig->n; ++i) farthest = greater(farthest, distance(rig->at[i], root_at));
  branches = 0;
  for (int32_t i = 0; i < rig->n; ++i) {
    const Point p = (1 / greater(farthest, 1e-9)) * (rig->at[i] - root_at);
    at[i] = {dot(p, frame.across), dot(p, frame.up), dot(p, frame.front)};
    through[i] = 0;
    if (rig->kid_count(i) == 0) leaves[branches++] = i;
  }
  for (int32_t k = 0; k < rig->n; ++k) {
    const int32_t i = rig->order[k], p = rig->parent[i];
    root_distance[i] = p >= 0 ? root_distance[p] + rig->bone(i, p) : 0;
  }
  for (int32_t k = rig->n - 1; k >= 0; --k) {
    const int32_t i = rig->order[k];
    if (rig->kid_count(i) == 0) through[i] = 1;
    if (rig->parent[i] >= 0) through[rig->parent[i]] += through[i];
  }
  find_mirrors();
}

void Branches::Rig::take(int32_t branch) {
  const int32_t leaf = leaves[branch];
  length = rig->depth[leaf] + 1;
  const double whole = greater(root_distance[leaf], 1e-9);
  for (int32_t i = leaf, k = length; k > 0; i = rig->parent[i]) {
    chain[--k] = i;
    ratio[k] = root_distance[i] / whole;
  }
}

void Branches::Rig::find_mirrors() {
  for (int32_t i = 0; i < branches; ++i) {
    const Point& p = at[leaves[i]];
    const Point image = {-p.x, p.y, p.z};
    double least = 0;
    int32_t best = -1;
    for (int32_t j = 0; j < branches; ++j) {
      const int32_t longer = rig->depth[leaves[j]] - rig->depth[leaves[i]];
      const double own = distance(image, at[leaves[j]]) + (longer < 0 ? -longer : longer);
      if (best >= 0 && !(own < least)) continue;
      best = j;
      least = own;
    }
    mirror[i] = least < kMirrored && best != i ? best : -1;
  }
}

bool Branches::allocate(Arena& arena, uint32_t target_joints, uint32_t source_joints) {
  (void)a_.allocate(arena, target_joints);
  (void)b_.allocate(arena, source_joints);
  const size_t cells = static_cast<size_t>(table_cells(target_joints, source_joints));
  table_ = arena.alloc<double>(cells);
  costs_ = arena.alloc<double>(cells);
  const size_t longest = target_joints > source_joints ? target_joints : source_joints;
  row_ = arena.alloc<double>(2 * (longest + 1));
  better_ = arena.alloc<uint8_t>((size_t{target_joints} + 1) * (size_t{source_joints} + 1));
  choice_ = arena.alloc<int32_t>(target_joints);
  used_ = arena.alloc<uint8_t>(source_joints);
  return arena.ok();
}

double Branches::joint_cost(int32_t i, int32_t j) const {
  const int32_t through = a_.through[i] - b_.through[j], degree = a_.degree(i) - b_.degree(j);
  return kPosition * distance(a_.at[i], b_.at[j]) + kCentrality * (through < 0 ? -through : through) +
         kDegree * (degree < 0 ? -degree : degree);
}

uint64_t Branches::prepare(const Hierarchy& target, const Frame& target_frame, const Hierarchy& source,
                           const Frame& source_frame) {
  uint64_t lengths[2] = {0, 0}, leaves[2] = {0, 0};
  for (int r = 0; r < 2; ++r) {
    const Hierarchy& rig = r == 0 ? target : source;
    for (int32_t i = 0; i < rig.n; ++i) {
      if (rig.kid_count(i) > 0) continue;
      ++leaves[r];
      lengths[r] += static_cast<uint64_t>(rig.depth[i]) + 1;
    }
  }
  if (leaves[0] * leaves[1] > kMostBranchPairs || lengths[0] * lengths[1] > kMostBranchCells) return UINT64_MAX;
  a_.prepare(target, target_frame);
  b_.prepare(source, source_frame);
  return lengths[0] * lengths[1];
}

// Of the two branches in hand: every joint of the shorter gets one of the longer. Leaves where a later place is better.
double Branches::compare() {
  const bool turned = a_.length > b_.length;
  const Rig &s = turned ? b_ : a_, &l = turned ? a_ : b_;
  const int32_t n = s.length, m = l.length;
  double* before = row_;
  double* now = row_ + m + 1;
  for (int32_t j = 0; j <= m; ++j) before[j] = 0;
  for (int32_t i = 1; i <= n; ++i) {
    uint8_t* const better = better_ + static_cast<size_t>(i) * (static_cast<size_t>(m) + 1);
    double least = 1e300;
    now[i - 1] = 1e300;
    for (int32_t j = i; j <= m; ++j) {
      const int32_t p = s.chain[i - 1], q = l.chain[j - 1];
      const double own = before[j - 1] + (turned ? stored_cost(q, p) : stored_cost(p, q)) +
                         kRatio * absolute(s.ratio[i - 1] - l.ratio[j - 1]);
      better[j] = own < least ? 1 : 0;
      if (own < least) least = own;
      now[j] = least;
    }
    double* const swap = before;
    before = now;
    now = swap;
  }
  return before[m];
}

// The pairs of what compare() left, where they are cheaper than those of other branches.
void Branches::keep_pairs(int32_t* sources, double* costs) {
  const bool turned = a_.length > b_.length;
  const int32_t n = turned ? b_.length : a_.length, m = turned ? a_.length : b_.length;
  for (int32_t i = n, j = m; i > 0; --i, --j) {
    while (better_[static_cast<size_t>(i) * (static_cast<size_t>(m) + 1) + static_cast<size_t>(j)] == 0) --j;
    const int32_t t = turned ? a_.chain[j - 1] : a_.chain[i - 1], s = turned ? b_.chain[i - 1] : b_.chain[j - 1];
    const double cost = stored_cost(t, s);
    if (sources[t] >= 0 && !(cost < costs[t])) continue;
    sources[t] = s;
    costs[t] = cost;
  }
}

double Branches::run(int32_t* sources, double* costs) {
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
    choice_[i] = 0;
    double* const row = costs_ + static_cast<size_t>(i) * static_cast<size_t>(b_.branches);
    for (int32_t j = 0; j < b_.branches; ++j) {
      b_.take(j);
      row[j] = compare();
      if (row[j] < row[choice_[i]]) choice_[i] = j;
    }
  }
  for (int32_t i = 0; i < a_.branches; ++i) {  // mirrored branches together
    const int32_t other = a_.mirror[i];
    if (other <= i) continue;
    double least = 0;
    int32_t best = -1;
    for (int32_t k = 0; k < b_.branches; ++k) {
      if (b_.mirror[k] < 0) continue;
      const double own =
          costs_[static_cast<size_t>(i) * static_cast<size_t>(b_.branches) + static_cast<size_t>(k)] +
          costs_[static_cast<size_t>(other) * static_cast<size_t>(b_.branches) + static_cast<size_t>(b_.mirror[k])];
      if (best >= 0 && !(own < least)) continue;
      best = k;
      least = own;
    }
    if (best < 0) continue;
    choice_[i] = best;
    choice_[other] = b_.mirror[best];
  }
  for (int32_t i = 0; i < a_.branches; ++i) {
    a_.take(i);
    b_.take(choice_[i]);
    (void)compare();
    keep_pairs(sources, costs);
  }
  const int32_t top = a.first_root();
  if (sources[top] != b.first_root()) {
    sources[top] = b.first_root();
    costs[top] = stored_cost(top, sources[top]);
  }
  double sum = 0;
  int32_t pairs = 0;
  for (int32_t i = 0; i < a.n; ++i) {
    if (sources[i] < 0) continue;
    sum += costs[i];
    ++pairs;
  }
  fill_in(sources, costs);
  return sum / pairs;
}

// Whether t -> s would cross the way of an ancestor or of a joint below.
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
    if (sources[t] >= 0) continue;
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
      if (used_[idle] != 0 || crosses(t, idle, sources)) continue;
      sources[t] = idle;
      costs[t] = stored_cost(t, idle);
      used_[idle] = 1;
      break;
    }
  }
}

}  // namespace sinew::mapping
