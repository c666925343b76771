// SPDX-License-Identifier: MIT
// Owners of votes, costs of connections, Prim's tree, ends of bones.
#include "rig/folded_tree.hpp"

#include "core/vector_math.hpp"
#include "rig/body_ways.hpp"
#include "rig/class_prior.hpp"
#include "rig/coverage.hpp"
#include "rig/limbs.hpp"

namespace sinew::rigging {
namespace {

constexpr uint8_t kNoFoldedJoint = 0xFF;
constexpr uint32_t kOneQ15 = 32768;            // Q15
constexpr int64_t kOwnReach = 4 * kVoteWidth;  // from a vote to the joint that it is for
constexpr uint32_t kClassFloor = 983;          // Q15, 0.03: what a class counts that a vote says nothing of
constexpr int64_t kLogPerUnit = 3298;          // Q26: log2(e) / kVoteWidth
constexpr int32_t kNever = INT32_MAX / 2;
constexpr int64_t kAstray = 12 << 16, kSecond = 4 << 16;  // bits, Q16
constexpr int32_t kFromBeside = 283650;                   // Q16: 3 log2(e)
// Joints nearer to the plane than this are moved onto it for their child.
constexpr int32_t kMiddle = side_share(300), kPairMiddle = side_share(200);
constexpr int32_t kEndSnap = side_share(400);      // an end of a joint on the plane
constexpr int32_t kEndDistance = side_share(120);  // from an end to any joint
constexpr uint32_t kEndSeeds = 12;
constexpr int32_t kHandReach = side_share(600);  // no arm goes on farther behind a hand
constexpr int32_t kOnBone = side_share(200);     // from a joint to the bone that it lies on
constexpr int64_t kOneSided = 8;                 // times as many votes from one side as from the other,
constexpr int64_t kChanceVotes = 16384;          // and Q15 votes more than come about by chance
class FoldedTreeBuilder {
 public:
  FoldedTreeBuilder(const VotePool& pool, Cloud cloud, uint8_t* starts, uint8_t* ends, int32_t* between,
                    FoldedTree* tree)
      : pool_(pool),
        votes_(*pool.votes),
        cloud_(cloud),
        starts_(starts),
        ends_(ends),
        between_(between),
        tree_(*tree) {}

  // Who owns which votes, and on which sides joints are.
  void read_votes() {
    const uint32_t n = votes_.points;
    for (uint32_t p = 0; p < n; ++p) {
      starts_[p] = owner(votes_.start[p], votes_.start_class + size_t{p} * kJointClasses);
      ends_[p] = owner(votes_.end[p], votes_.end_class + size_t{p} * kEndClasses);
    }
    find_sides();
  }

  //   ways  [joints x joints] as find_body_ways() finds them, null without a body
  void run(BodyKind kind, const int32_t* ways) {
    ways_ = ways;
    grow();
    LimbVotes votes = {}, limbs;
    count_limbs(votes);
    if (tree_.mirrored && free_ears(heights(), votes, &tree_)) grow();
    copy(votes, limbs);
    settle_limbs(limbs, &tree_);
    if (steer_limbs(kind, &tree_, votes)) {
      grow();
      settle_limbs(votes, &tree_);
    }
    find_ends();
    divide_bones();
  }

 private:
  // A joint beside the plane whose votes come from one side of the body is on that side only: a raised arm, a tail that swings.
  SINEW_RARE void find_sides() {
    if (!tree_.mirrored || votes_.inside == nullptr) return;
    int64_t sides[kMaxFoldedJoints][2] = {};
    const auto count = [&](uint8_t joint, uint32_t p, Vec3i vote, uint32_t spread) {
      if (joint == kNoFoldedJoint) return;
      const bool left = (votes_.inside[p].x >= 0) == (vote.x >= 0);
      sides[joint][left ? 0 : 1] += trust_in(spread);
    };
    for (uint32_t p = 0; p < votes_.points; ++p) {
      count(starts_[p], p, votes_.start[p], votes_.start_spread[p]);
      count(ends_[p], p, votes_.end[p], votes_.end_spread[p]);
    }
    for (uint32_t j = 0; j < tree_.count; ++j) {
      const int64_t left = sides[j][0], right = sides[j][1];
      const auto outweighs = [](int64_t one, int64_t other) { return one > kOneSided * (other + kChanceVotes); };
      tree_.nodes[j].only = outweighs(left, right) ? 1 : outweighs(right, left) ? -1 : 0;
    }
  }

  Heights heights() const {
    Heights heights;
    for (uint32_t p = 0; p < votes_.points; ++p) {
      if (starts_[p] == kNoFoldedJoint) continue;
      ++heights.points[starts_[p]];
      heights.sum[starts_[p]] += (int64_t{votes_.start[p].y} + votes_.end[p].y) / 2;
    }
    return heights;
  }

  void grow() {
    count_votes();
    choose_root();
    connect();
    if (tree_.mirrored) tree_.nodes[tree_.root].at.x = 0;
  }

  static void copy(const LimbVotes& from, LimbVotes& to) {
    for (uint32_t j = 0; j < kMaxFoldedJoints; ++j)
      for (uint32_t k = 0; k < kLimbs; ++k) to[j][k] = from[j][k];
  }

  // The joint that makes exp(-distance / width) (probability of its class + 0.03) greatest.
  uint8_t owner(Vec3i vote, const uint16_t* classes) const {
    const Vec3i at = folded_position(vote, tree_.mirrored);
    uint8_t best = kNoFoldedJoint;
    int64_t best_score = INT64_MIN;
    for (uint32_t j = 0; j < tree_.count; ++j) {
      const int64_t distance_2 = square_distance(at, tree_.nodes[j].at);
      if (distance_2 >= square(kOwnReach)) continue;
      const int64_t distance = isqrt64(static_cast<uint64_t>(distance_2));
      const int64_t score =
          log2_q16(classes[tree_.nodes[j].joint_class] + kClassFloor) - ((distance * kLogPerUnit) >> 10);
      if (score <= best_score) continue;
      best_score = score;
      best = static_cast<uint8_t>(j);
    }
    return best;
  }

  uint32_t tip(uint32_t point) const { return votes_.end_class[size_t{point} * kEndClasses + kClassTip]; }

  void count_votes() {
    const uint32_t j = tree_.count;
    for (uint32_t i = 0; i < j * j; ++i) between_[i] = 0;
    for (uint32_t i = 0; i < j; ++i) points_[i] = tips_[i] = 0;
    int64_t trust[kMaxFoldedJoints] = {}, votes[kMaxFoldedJoints] = {};
    for (uint32_t p = 0; p < votes_.points; ++p) {
      const uint8_t from = starts_[p], to = ends_[p];
      if (from != kNoFoldedJoint) {
        ++points_[from];
        tips_[from] += tip(p);
        trust[from] += trust_in(votes_.start_spread[p]);
        ++votes[from];
      }
      if (to != kNoFoldedJoint) {
        trust[to] += trust_in(votes_.end_spread[p]);
        ++votes[to];
      }
      if (from == kNoFoldedJoint || to == kNoFoldedJoint || from == to || 2 * tip(p) >= kOneQ15) continue;
      between_[from * j + to] += static_cast<int32_t>(kOneQ15 - tip(p));  // at most 2^12 * 2^15
    }
    for (uint32_t i = 0; i < j; ++i) {
      tree_.nodes[i].confidence = static_cast<uint16_t>(votes[i] > 0 ? trust[i] / votes[i] : 0);
    }
  }

  SINEW_RARE void choose_root() {
    bool on_plane = false;
    for (uint32_t j = 0; j < tree_.count; ++j) on_plane = on_plane || !tree_.beside(j);
    const Vec3i mean = {tree_.mirrored ? 0 : votes_.mean.x, votes_.mean.y, votes_.mean.z};
    bool found = false, pelvis = false;
    int64_t best = 0;
    for (uint32_t j = 0; j < tree_.count; ++j) {
      if (on_plane && tree_.beside(j)) continue;
      const FoldedNode& node = tree_.nodes[j];
      const bool is_pelvis = node.joint_class == kClassPelvis;
      if (pelvis && !is_pelvis) continue;
      // The distance to the mean less half the share of the points that the joint owns.
      const int64_t badness =
          is_pelvis ? -points_[j]
                    : static_cast<int64_t>(length(node.at - mean)) - points_[j] * (kSide / 2) / votes_.points;
      if (found && pelvis == is_pelvis && badness >= best) continue;
      found = true;
      pelvis = is_pelvis;
      best = badness;
      tree_.root = j;
    }
  }

  // In bits, Q16: -log2(chance by the votes + 0.01), the path through the body, -0.7 log2(chance of the classes).
  SINEW_RARE void find_costs() {
    const uint32_t n = tree_.count;
    // Twenty times what the votes add up to, so that the share of the opposite direction, 0.15, is an integer: below
    // 2^38.
    int64_t total[kMaxFoldedJoints];
    for (uint32_t j = 0; j < n; ++j) {
      total[j] = int64_t{votes_.points} * kOneQ15 * 20 / 500;
      for (uint32_t k = 0; k < n; ++k) total[j] += int64_t{20} * between_[k * n + j] + int64_t{3} * between_[j * n + k];
    }
    const auto cost = [&](uint32_t from, uint32_t to, int64_t votes) {
      const FoldedNode &a = tree_.nodes[from], &b = tree_.nodes[to];
      const int64_t surprise =
          log2_q16(static_cast<uint64_t>(100 * total[to])) - log2_q16(static_cast<uint64_t>(100 * votes + total[to]));
      const int64_t way = ways_ != nullptr ? ways_[from * n + to] : straight_cost(a.at, b.at);
      const int64_t classes = int64_t{kParentSurprise[a.joint_class][b.joint_class]} * 56 / 5;
      return static_cast<int32_t>(surprise + way + classes);
    };
    // Both directions at once: each needs the other's votes.
    for (uint32_t i = 0; i < n; ++i) {
      for (uint32_t j = 0; j < i; ++j) {
        const int64_t there = between_[i * n + j], back = between_[j * n + i];
        between_[i * n + j] = cost(i, j, 20 * there + 3 * back);
        between_[j * n + i] = cost(j, i, 20 * back + 3 * there);
      }
    }
  }

  // A joint beside the plane that is the parent of one on it was meant to lie there as well, if it is near. Others may
  // not be: of two images only one would have the child.
  SINEW_RARE void connect() {
    find_costs();
    find_parents(kFromBeside);
    for (bool moved = tree_.mirrored; moved;) {
      moved = false;
      for (uint32_t j = 0; j < tree_.count; ++j) {
        if (tree_.beside(j) || tree_.nodes[j].parent < 0) continue;
        FoldedNode& parent = tree_.nodes[tree_.nodes[j].parent];
        if (parent.at.x >= (is_paired_class(parent.joint_class) ? kPairMiddle : kMiddle)) continue;
        moved = moved || parent.at.x > 0;
        parent.at.x = 0;
      }
      if (moved) find_parents(kFromBeside);
    }
    find_parents(kNever);
  }

  // Where a joint is: 1 at +x, 2 at -x, 3 on both sides or on the plane.
  uint8_t sides_of(uint32_t node) const {
    const int8_t only = tree_.only(node);
    return only > 0 ? 1 : only < 0 ? 2 : 3;
  }

  //   continued  of each joint the sides on which a limb goes on from it
  int64_t limb_cost(uint32_t from, uint32_t to, const uint8_t* continued) const {
    const FoldedNode &a = tree_.nodes[from], &b = tree_.nodes[to];
    const bool beyond = limb_of(b.joint_class) == LimbClass::kArm && a.joint_class == kClassHand &&
                        square_distance(a.at, b.at) > square(int64_t{kHandReach});
    const bool astray = lies_across(a, b) || leaves_limb(a.joint_class, b.joint_class) || beyond;
    const bool second = (continued[from] & sides_of(to)) != 0 && continues_limb(a.joint_class, b.joint_class);
    const bool apart = (sides_of(from) & sides_of(to)) == 0;  // no joint on one side has a parent on the other
    return (astray ? kAstray : 0) + (second ? kSecond : 0) + (apart ? kNever : 0);
  }

  // Prim's algorithm; from_beside is the extra cost of a path from beside the plane to it.
  SINEW_RARE void find_parents(int32_t from_beside) {
    const uint32_t n = tree_.count;
    bool inside[kMaxFoldedJoints] = {};
    uint8_t continued[kMaxFoldedJoints] = {};
    int64_t best[kMaxFoldedJoints];
    for (int64_t& b : best) b = INT64_MAX;
    const auto offer = [&](uint32_t i, uint32_t j) {
      const bool leaves = tree_.beside(i) && !tree_.beside(j);
      const int64_t cost = int64_t{between_[i * n + j]} + (leaves ? from_beside : 0) + limb_cost(i, j, continued);
      if (cost >= best[j]) return;
      best[j] = cost;
      tree_.nodes[j].parent = static_cast<int16_t>(i);
    };
    tree_.nodes[tree_.root].parent = -1;
    tree_.nodes[tree_.root].parent_confidence = kOneQ15;
    uint32_t last = tree_.root;
    for (uint32_t taken = 1; taken < n; ++taken) {
      inside[last] = true;
      const int16_t above = tree_.nodes[last].parent;
      const bool goes_on = above >= 0 && continues_limb(tree_.nodes[above].joint_class, tree_.nodes[last].joint_class);
      const uint8_t sides = goes_on ? sides_of(last) : uint8_t{0};
      const bool second = goes_on && (continued[above] & sides) != sides;  // from now on
      if (goes_on) continued[above] = static_cast<uint8_t>(continued[above] | sides);
      uint32_t next = n;
      for (uint32_t j = 0; j < n; ++j) {
        if (inside[j]) continue;
        if (second && tree_.nodes[j].parent == above) {
          best[j] = INT64_MAX;
          for (uint32_t i = 0; i < n; ++i)
            if (inside[i]) offer(i, j);
        }
        offer(last, j);
        if (next == n || best[j] < best[next]) next = j;
      }
      tree_.nodes[next].parent_confidence = static_cast<uint16_t>(exp2_negative(best[next]) >> 15);
      last = next;
    }
  }

  SINEW_RARE void count_limbs(LimbVotes& votes) const {
    for (uint32_t p = 0; p < votes_.points; ++p) {
      for (uint32_t c = 0; c < kJointClasses; ++c) {
        const LimbClass limb = limb_of(c);
        if (limb == LimbClass::kNone) continue;
        const auto k = static_cast<uint32_t>(limb);
        if (starts_[p] != kNoFoldedJoint) votes[starts_[p]][k] += votes_.start_class[size_t{p} * kJointClasses + c];
        if (ends_[p] != kNoFoldedJoint) votes[ends_[p]][k] += votes_.end_class[size_t{p} * kEndClasses + c];
      }
    }
  }

  SINEW_RARE void find_ends() {
    bool leaf[kMaxFoldedJoints];
    for (bool& l : leaf) l = true;
    for (uint32_t j = 0; j < tree_.count; ++j) {
      if (tree_.nodes[j].parent >= 0) leaf[tree_.nodes[j].parent] = false;
    }
    for (uint32_t j = 0; j < tree_.count; ++j) {
      // The mean chance of a tip is at least 1/4 for a leaf, 1/2 for others.
      if (points_[j] == 0 || tips_[j] * (leaf[j] ? 4 : 2) < points_[j] * kOneQ15) continue;
      cloud_.clear();
      int64_t trust = 0;
      for (uint32_t i = 0; i < pool_.count; ++i) {
        const uint32_t point = pool_.source[i] >> 1;
        if ((pool_.source[i] & 1) == 0 || starts_[point] != j) continue;
        const uint32_t weight = (pool_.trust[i] * tip(point) + (1u << 14)) >> 15;
        trust += int64_t{pool_.trust[i]} * tip(point);
        if (weight > 0) cloud_.add(pool_.at[i], weight);
      }
      Mode modes[kMaxModes];
      if (find_modes(cloud_, kVoteWidth, tree_.mirrored, kEndSeeds, modes) == 0) continue;
      Vec3i end = modes[0].at;
      if (tree_.mirrored && !tree_.beside(j) && end.x < kEndSnap) end.x = 0;
      bool is_far = true;
      for (uint32_t k = 0; k < tree_.count; ++k) {
        is_far = is_far && square_distance(end, tree_.nodes[k].at) >= square(kEndDistance);
      }
      if (!is_far) continue;
      tree_.nodes[j].has_end = true;
      tree_.nodes[j].end = end;
      tree_.nodes[j].end_confidence = static_cast<uint16_t>(trust / tips_[j]);
    }
  }

  // A childless joint without an end that lies on a bone of its limb, and whose class stands between those of the
  // bone's two ends, divides that bone. It was left over, because the two have more votes for each other than either
  // has for the joint between them.
  SINEW_RARE void divide_bones() {
    for (uint32_t j = 0; j < tree_.count; ++j) {
      FoldedNode& node = tree_.nodes[j];
      bool left_over = node.parent >= 0 && !node.has_end;
      for (uint32_t k = 0; k < tree_.count; ++k)
        left_over = left_over && tree_.nodes[k].parent != static_cast<int16_t>(j);
      int64_t nearest = square(int64_t{kOnBone});
      uint32_t divided = kNoIndex;  // twice a joint: the bone to it; and 1: the bone from it to its end
      for (uint32_t i = 0; left_over && i < 2 * tree_.count; ++i) {
        const uint32_t k = i / 2;
        const FoldedNode& other = tree_.nodes[k];
        const bool at_end = i % 2 != 0;
        if (k == j || (at_end ? !other.has_end : other.parent < 0) || tree_.beside(k) != tree_.beside(j) ||
            tree_.only(k) != tree_.only(j) || limb_of(other.joint_class) != limb_of(node.joint_class))
          continue;
        const FoldedNode& above = at_end ? other : tree_.nodes[other.parent];
        if (above.joint_class > node.joint_class || (!at_end && node.joint_class > other.joint_class)) continue;
        const Vec3i bone = (at_end ? other.end : other.at) - above.at, way = node.at - above.at;
        const int64_t whole = dot(bone, bone), along = dot(way, bone);
        if (along <= 0 || along >= whole) continue;
        // Pythagoras, shifted so that the square of what is along fits 64 bits.
        const int64_t off = dot(way, way) - square(along >> 11) / ((whole >> 22) + 1);
        if (off >= nearest) continue;
        nearest = off;
        divided = i;
      }
      if (divided == kNoIndex) continue;
      FoldedNode& other = tree_.nodes[divided / 2];
      if (divided % 2 != 0) {
        node.has_end = true;
        node.end = other.end;
        node.end_confidence = other.end_confidence;
        other.has_end = false;
        node.parent = static_cast<int16_t>(divided / 2);
      } else {
        node.parent = other.parent;
        node.parent_confidence = other.parent_confidence;
        other.parent = static_cast<int16_t>(j);
      }
    }
  }

  const VotePool& pool_;
  const Votes& votes_;
  Cloud cloud_;
  uint8_t* const starts_;   // [N] joint of the start vote, or kNoFoldedJoint
  uint8_t* const ends_;     // [N]
  int32_t* const between_;  // [joints x joints] from, to: votes in Q15, then costs
  const int32_t* ways_ = nullptr;
  FoldedTree& tree_;
  int64_t points_[kMaxFoldedJoints] = {};  // that start at the joint
  int64_t tips_[kMaxFoldedJoints] = {};    // Q15: their chances of a tip, summed
};

}  // namespace

sinew_status grow_tree(const VotePool& pool, const FoldedJoint* joints, uint32_t count, BodyKind kind,
                       Interior* interior, Arena& arena, FoldedTree* tree) {
  const ArenaScope scope(arena);
  Cloud cloud;
  const bool fits = cloud.allocate(arena, pool.count);
  uint8_t* const starts = arena.alloc<uint8_t>(pool.count / 2);
  uint8_t* const ends = arena.alloc<uint8_t>(pool.count / 2);
  int32_t* const between = arena.alloc<int32_t>(size_t{kMaxFoldedJoints} * kMaxFoldedJoints);
  int32_t* const ways =
      interior != nullptr ? arena.alloc<int32_t>(size_t{kMaxFoldedJoints} * kMaxFoldedJoints) : nullptr;
  if (!fits || !arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring())
    return interior == nullptr || (find_body_ways(tree, arena, interior, ways) && cover_body(arena, interior, tree))
               ? SINEW_OK
               : SINEW_ERROR_WORKSPACE;
  *tree = {};
  tree->mirrored = pool.mirrored;
  tree->count = count;
  for (uint32_t j = 0; j < count; ++j) {
    tree->nodes[j].at = joints[j].at;
    tree->nodes[j].joint_class = joints[j].joint_class;
  }
  FoldedTreeBuilder builder(pool, cloud, starts, ends, between, tree);
  builder.read_votes();
  if (interior != nullptr && !find_body_ways(tree, arena, interior, ways)) return SINEW_ERROR_WORKSPACE;
  builder.run(kind, ways);
  if (interior != nullptr && !cover_body(arena, interior, tree)) return SINEW_ERROR_WORKSPACE;
  return SINEW_OK;
}

}  // namespace sinew::rigging
