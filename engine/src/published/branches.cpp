// SPDX-License-Identifier: MIT
// Node costs, the cheapest order-preserving assignment of two branches, and which branch goes with which.
#include "published/branches.hpp"

namespace sinew::mapping {
namespace {

// Weights as published; that of the surface is ours.
constexpr double kPosition = 10, kRatio = 2, kCentrality = 0.2, kDegree = 1, kArea = 10;
constexpr double kUsualBranches = 25;  // of these, because rigs with and without fingers have to be compared
constexpr double kMirrored = 0.1;      // branches that are less alike are no pair
constexpr double kSecondBest = 2;      // times the cost: what a branch pays for one of its own
constexpr int32_t kMostRounds = 20;

uint64_t table_cells(uint64_t target, uint64_t source) {
  return target * source < kMostBranchPairs ? target * source : kMostBranchPairs;
}

// The first joint below the root, or the root, with two or more children that are not leaves; the root where none is.
int32_t first_branching(const Hierarchy& rig) {
  for (int32_t joint = rig.first_root(), only = joint; only >= 0; joint = only) {
    int32_t count = 0;
    only = -1;
    each_kid(rig, joint, [&](int32_t kid) {
      if (rig.end[kid] != 0) return;
      only = kid;
      ++count;
    });
    if (count > 1) return joint;
  }
  return rig.first_root();
}

}  // namespace

bool Branches::Rig::allocate(Arena& arena, uint32_t joints) {
  node = arena.alloc<uint8_t>(joints);
  at = arena.alloc<Point>(joints);
  area = arena.alloc<double>(joints);
  root_distance = arena.alloc<double>(joints);
  depth = arena.alloc<int32_t>(joints);
  kids = arena.alloc<int32_t>(joints);
  leaves = arena.alloc<int32_t>(joints);
  mirror = arena.alloc<int32_t>(joints);
  through = arena.alloc<int32_t>(joints);
  chain = arena.alloc<int32_t>(joints);
  ratio = arena.alloc<double>(joints);
  side = arena.alloc<int8_t>(joints);
  return arena.ok();
}

void Branches::Rig::prepare(const Anatomy& anatomy, const float* areas) {
  rig = anatomy.rig;
  joint_side = anatomy.side;
  const Frame& frame = anatomy.frame;
  root = first_branching(*rig);
  const Point root_at = rig->at[anatomy.hip];
  double farthest = 0, whole = 0;
  for (int32_t i = 0; i < rig->n; ++i) {
    node[i] = i == root || (rig->holds(root, i) && rig->end[i] == 0) ? 1 : 0;
    kids[i] = 0;
    through[i] = 0;
    area[i] = areas != nullptr ? static_cast<double>(areas[i]) : 0;
    whole += area[i];
    if (node[i] != 0) farthest = greater(farthest, distance(rig->at[i], root_at));
  }
  for (int32_t k = 0; k < rig->n; ++k) {
    const int32_t i = rig->order[k], p = rig->parent[i];
    const Point q = (1 / greater(farthest, 1e-9)) * (rig->at[i] - root_at);
    at[i] = {dot(q, frame.across), dot(q, frame.up), dot(q, frame.front)};
    if (whole > 0) area[i] /= whole;
    if (p >= 0 && node[i] != 0 && i != root && node[p] == 0) node[i] = 0;  // below an end
    depth[i] = i == root || node[i] == 0 ? 0 : depth[p] + 1;
    root_distance[i] = i == root || node[i] == 0 ? 0 : root_distance[p] + rig->bone(i, p);
    if (i != root && node[i] != 0) ++kids[p];
  }
  branches = 0;
  for (int32_t i = 0; i < rig->n; ++i) {
    if (node[i] != 0 && kids[i] == 0) leaves[branches++] = i;
  }
  for (int32_t k = rig->n - 1; k >= 0; --k) {
    const int32_t i = rig->order[k];
    if (node[i] == 0) continue;
    if (kids[i] == 0) through[i] = 1;
    if (i != root) through[rig->parent[i]] += through[i];
  }
  for (int32_t k = 0; k < branches; ++k) side[k] = anatomy.side[leaves[k]];
  find_mirrors();
}

void Branches::Rig::take(int32_t branch) {
  const int32_t leaf = leaves[branch];
  length = depth[leaf] + 1;
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
      const int32_t longer = depth[leaves[j]] - depth[leaves[i]];
      const double own = distance(image, at[leaves[j]]) + (longer < 0 ? -longer : longer);
      if (best >= 0 && !(own < least)) continue;
      best = j;
      least = own;
    }
    mirror[i] = least < kMirrored && best != i ? best : -1;
  }
  for (int32_t i = 0; i < branches; ++i) {  // in both directions
    if (mirror[i] >= 0 && mirror[mirror[i]] != i) mirror[i] = -1;
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
  choice_ = arena.alloc<int32_t>(longest);
  holders_ = arena.alloc<int32_t>(longest);
  used_ = arena.alloc<uint8_t>(source_joints);
  open_ = arena.alloc<uint8_t>(target_joints);
  return arena.ok();
}

double Branches::joint_cost(int32_t i, int32_t j) const {
  const int32_t degree = a_.degree(i) - b_.degree(j);
  const double central =
      absolute(static_cast<double>(a_.through[i]) / a_.branches - static_cast<double>(b_.through[j]) / b_.branches);
  return kPosition * distance(a_.at[i], b_.at[j]) + kCentrality * kUsualBranches * central +
         kDegree * (degree < 0 ? -degree : degree) + kArea * absolute(a_.area[i] - b_.area[j]);
}

uint64_t Branches::prepare(const Anatomy& target, const float* target_areas, const Anatomy& source,
                           const float* source_areas) {
  const bool areas = target_areas != nullptr && source_areas != nullptr;
  a_.prepare(target, areas ? target_areas : nullptr);
  b_.prepare(source, areas ? source_areas : nullptr);
  uint64_t lengths[2] = {0, 0};
  for (int r = 0; r < 2; ++r) {
    const Rig& rig = r == 0 ? a_ : b_;
    for (int32_t k = 0; k < rig.branches; ++k) lengths[r] += static_cast<uint64_t>(rig.depth[rig.leaves[k]]) + 1;
  }
  const uint64_t pairs = static_cast<uint64_t>(a_.branches) * static_cast<uint64_t>(b_.branches);
  if (pairs > kMostBranchPairs || lengths[0] * lengths[1] > kMostBranchCells) return UINT64_MAX;
  return lengths[0] * lengths[1];
}

// In the two current branches every joint of the shorter gets one of the longer. Returns early if a later choice is
// better.
double Branches::compare(bool mean) {
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
  return mean ? before[m] / n : before[m];
}

// Mirrored branches only to mirrored ones, of the same side.
bool Branches::may_pair(int32_t i, int32_t k) const {
  return (first_->mirror[i] >= 0) == (second_->mirror[k] >= 0) && first_->side[i] == second_->side[k];
}

// Cost of matching branch i of the first rig to branch k of the other, and i's mirror image to that of k.
double Branches::mirrored_cost(int32_t i, int32_t k) const {
  const Rig &one = *first_, &other = *second_;
  const int32_t twin = one.mirror[i], image = other.mirror[k];
  return choice_cost(i, k) + (twin >= 0 && image >= 0 ? choice_cost(twin, image) : 0);
}

void Branches::take_over(int32_t i, int32_t k) {
  if (choice_[i] >= 0) --holders_[choice_[i]];
  choice_[i] = k;
  ++holders_[k];
}

void Branches::give(int32_t i, int32_t k) {
  const int32_t twin = first_->mirror[i], image = second_->mirror[k];
  take_over(i, k);
  if (twin >= 0) take_over(twin, image >= 0 ? image : k);
}

// Returns the cheapest branch of the other rig for branch i of the first: one of its kind, else any. `free`: only
// unassigned ones.
int32_t Branches::cheapest(int32_t i, bool free) const {
  for (int pass = 0; pass < 2; ++pass) {
    double least = 0;
    int32_t best = -1;
    for (int32_t k = 0; k < second_->branches; ++k) {
      if ((pass == 0 && !may_pair(i, k)) || (free && holders_[k] > 0)) continue;
      const double own = mirrored_cost(i, k);
      if (best >= 0 && !(own < least)) continue;
      best = k;
      least = own;
    }
    if (best >= 0 || free) return best;
  }
  return -1;
}

// A branch of the other rig for each of the first one's. Returns the mean of their costs.
double Branches::choose(bool target_first) {
  first_ = target_first ? &a_ : &b_;
  second_ = target_first ? &b_ : &a_;
  const int32_t count = first_->branches;
  for (int32_t i = 0; i < count; ++i) choice_[i] = -1;
  for (int32_t k = 0; k < second_->branches; ++k) holders_[k] = 0;
  const auto leads = [&](int32_t i) {
    return first_->mirror[i] < 0 || first_->mirror[i] > i;
  };  // of two that go together
  for (int32_t i = 0; i < count; ++i) {
    if (leads(i)) give(i, cheapest(i, false));
  }
  bool changed = true;
  for (int32_t round = 0; changed && round < kMostRounds; ++round) {
    changed = false;
    for (int32_t i = 0; i < count; ++i) {
      if (!leads(i) || !is_outbid(i)) continue;
      const int32_t other = cheapest(i, true);
      if (other < 0 || !(mirrored_cost(i, other) < kSecondBest * mirrored_cost(i, choice_[i]))) continue;
      give(i, other);
      changed = true;
    }
  }
  double sum = 0;
  for (int32_t i = 0; i < count; ++i) sum += choice_cost(i, choice_[i]);
  return sum / count;
}

// Whether another branch has the same one more cheaply.
bool Branches::is_outbid(int32_t i) const {
  for (int32_t j = 0; j < first_->branches; ++j) {
    if (j != i && j != first_->mirror[i] && choice_[j] == choice_[i] &&
        choice_cost(j, choice_[j]) < choice_cost(i, choice_[i])) {
      return true;
    }
  }
  return false;
}

}  // namespace sinew::mapping
