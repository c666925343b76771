// SPDX-License-Identifier: MIT
// Nearest bones, ties, the visibility rule and the strength of sources (stage 4).
#include "heat/sources.hpp"

#include <string.h>

namespace sinew {
namespace {

constexpr int kCosineBits = 26;
constexpr int64_t kCosineOffset = 67175973;  // 1.001 in Q26
constexpr int64_t kCosineFloor = 67109;      // 0.001 in Q26: reached when the normal points straight at the bone
constexpr uint64_t kTried = ~static_cast<uint64_t>(0);
constexpr uint64_t kAnywhere = kTried - 1;
constexpr uint32_t kNoBone = 0xFFFFFFFFu;

struct Bone {
  Vec3i head, tail, along;
  int64_t length2;        // |along|^2 <= 3 * 2^48
  int64_t length2_short;  // length2 >> shift, below 2^31
  int shift;
  uint16_t joint;
};

struct BoneList {
  Bone* bones = nullptr;                // [J]
  int32_t *low[3] = {}, *high[3] = {};  // [J] boxes around the bones, a grid unit wider for the sake of rounding
  // Of the current vertex, [J] for every lane: Euclid^2 in Q12, or a lower bound of it until `known` is 1.
  uint64_t* euclid2 = nullptr;
  uint8_t* known = nullptr;
  uint16_t* near = nullptr;  // [J] for every lane: those that may matter to the vertex, ascending
  uint32_t count = 0;

  bool allocate(Arena& arena, const Counts& counts) {
    bones = arena.alloc<Bone>(counts.joints);
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = arena.alloc<int32_t>(counts.joints);
      high[axis] = arena.alloc<int32_t>(counts.joints);
    }
    euclid2 = arena.alloc<uint64_t>(static_cast<size_t>(counts.joints) * counts.threads.lane_count());
    known = arena.alloc<uint8_t>(static_cast<size_t>(counts.joints) * counts.threads.lane_count());
    near = arena.alloc<uint16_t>(static_cast<size_t>(counts.joints) * counts.threads.lane_count());
    return arena.ok();
  }
  void build(const Skeleton& skeleton, const uint8_t* source_joints) {
    count = 0;
    for (uint32_t j = 0; j < skeleton.joint_count; ++j) {
      if (source_joints[j] == 0) continue;
      const int32_t ends[2][3] = {{skeleton.positions[j].x, skeleton.positions[j].y, skeleton.positions[j].z},
                                  {skeleton.bone_tail[j].x, skeleton.bone_tail[j].y, skeleton.bone_tail[j].z}};
      for (int axis = 0; axis < 3; ++axis) {
        const bool falls = ends[1][axis] < ends[0][axis];
        low[axis][count] = ends[falls ? 1 : 0][axis] - 1;
        high[axis][count] = ends[falls ? 0 : 1][axis] + 1;
      }
      Bone& bone = bones[count++];
      bone.head = skeleton.positions[j];
      bone.tail = skeleton.bone_tail[j];
      bone.along = bone.tail - bone.head;
      bone.length2 = dot(bone.along, bone.along);
      bone.shift = 0;
      while ((bone.length2 >> bone.shift) >> 31 != 0) ++bone.shift;
      bone.length2_short = bone.length2 >> bone.shift;
      bone.joint = static_cast<uint16_t>(j);
    }
  }
};

// From the nearest point of the bone to the vertex, Q6. Components stay below 2^30.
Vec3i offset_from_bone(const Bone& bone, Vec3i vertex) {
  const Vec3i from_head = vertex - bone.head;
  const int64_t along = dot(from_head, bone.along);
  constexpr int32_t one = 1 << kDistanceBits;
  if (along <= 0) return {from_head.x * one, from_head.y * one, from_head.z * one};
  if (along >= bone.length2) {
    const Vec3i from_tail = vertex - bone.tail;
    return {from_tail.x * one, from_tail.y * one, from_tail.z * one};
  }
  const int64_t t = ((along >> bone.shift) << 30) / bone.length2_short;  // Q30
  return {
      static_cast<int32_t>(static_cast<int64_t>(from_head.x) * one - round_shift(t * bone.along.x, 30 - kDistanceBits)),
      static_cast<int32_t>(static_cast<int64_t>(from_head.y) * one - round_shift(t * bone.along.y, 30 - kDistanceBits)),
      static_cast<int32_t>(static_cast<int64_t>(from_head.z) * one -
                           round_shift(t * bone.along.z, 30 - kDistanceBits))};
}

int64_t euclid_q6(uint64_t euclid2) { return static_cast<int64_t>(isqrt64(euclid2)); }

// Euclid / (0.5 (cos + 1.001)), Q6; below 2^42.
int64_t cosine_distance(Vec3i offset, uint64_t euclid2, Vec3i normal) {
  const int64_t euclid = euclid_q6(euclid2);
  if (euclid == 0) return 0;
  const int64_t cosine = dot(offset, normal) * (1 << (kCosineBits - kNormalBits)) / euclid;  // |dot| < 2^46
  const int64_t lifted = cosine + kCosineOffset;
  return (euclid << (kCosineBits + 1)) / (lifted < kCosineFloor ? kCosineFloor : lifted);
}

// Ties are 1e-4 of the smallest distance wide. Distances are below 2^42.
bool tied(int64_t distance, int64_t smallest) { return 10000 * distance <= 10001 * smallest; }

// The point of the bone that the vertex looks at, on the grid.
Vec3i seen_point(Vec3i vertex, Vec3i offset) {
  return {vertex.x - static_cast<int32_t>(round_shift(offset.x, kDistanceBits)),
          vertex.y - static_cast<int32_t>(round_shift(offset.y, kDistanceBits)),
          vertex.z - static_cast<int32_t>(round_shift(offset.z, kDistanceBits))};
}

class SourceFinder {
 public:
  SourceFinder(const Mesh& mesh, const FaceTree& tree, const BoneList& list, uint32_t lane, HeatSources& out)
      : mesh_(mesh),
        tree_(tree),
        list_(list),
        euclid2_(list.euclid2 + static_cast<size_t>(list.count) * lane),
        known_(list.known + static_cast<size_t>(list.count) * lane),
        near_(list.near + static_cast<size_t>(list.count) * lane),
        out_(out) {}

  void run(uint32_t vertex) {
    vertex_ = vertex;
    position_ = mesh_.positions[vertex];
    const uint32_t part = mesh_.part[vertex];
    first_ = tree_.part_first[part];
    last_ = tree_.part_first[part + 1];
    own_hint_ = FaceTree::kNoGroup;
    bound_distances();
    with_cosine();
    soft();
  }

 private:
  // At most one of both is positive. By masks, which compilers make vector code of.
  static uint64_t squared_gap(int32_t low, int32_t value, int32_t high) {
    const int32_t under = low - value, over = value - high;
    const uint32_t gap = static_cast<uint32_t>((under & ~(under >> 31)) | (over & ~(over >> 31)));
    return uint64_t{gap} * gap;
  }
  // Most bones are so far away that their boxes say enough.
  void bound_distances() {
    const Vec3i p = position_;
    const int32_t *const low_x = list_.low[0], *const low_y = list_.low[1], *const low_z = list_.low[2];
    const int32_t *const high_x = list_.high[0], *const high_y = list_.high[1], *const high_z = list_.high[2];
    uint64_t* const euclid2 = euclid2_;
    for (uint32_t b = 0, count = list_.count; b < count; ++b) {
      euclid2[b] = (squared_gap(low_x[b], p.x, high_x[b]) + squared_gap(low_y[b], p.y, high_y[b]) +
                    squared_gap(low_z[b], p.z, high_z[b]))
                   << (2 * kDistanceBits);
    }
    memset(known_, 0, list_.count);
  }
  // Keeps only those that may be within `limit`.
  void gather(uint64_t limit) {
    uint32_t count = 0;
    for (uint32_t b = 0; b < list_.count; ++b) {
      near_[count] = static_cast<uint16_t>(b);
      count += euclid2_[b] <= limit;
    }
    near_count_ = count;
    near_limit_ = limit;
  }
  uint64_t euclid2(uint32_t bone) {
    if (known_[bone] == 0) {
      known_[bone] = 1;
      const Vec3i offset = offset_from_bone(list_.bones[bone], position_);
      euclid2_[bone] = static_cast<uint64_t>(dot(offset, offset));
    }
    return euclid2_[bone];
  }
  bool beyond(uint32_t bone, uint64_t limit) { return euclid2_[bone] > limit || euclid2(bone) > limit; }

  bool hidden_by_own(uint32_t bone) {
    const Vec3i target = seen_point(position_, offset_from_bone(list_.bones[bone], position_));
    return tree_.hidden(mesh_, vertex_, target, first_, last_, false, &own_hint_);
  }
  bool hidden_by_others(uint32_t bone) {
    const Vec3i target = seen_point(position_, offset_from_bone(list_.bones[bone], position_));
    return tree_.hidden(mesh_, vertex_, target, first_, last_, true, &other_hint_);
  }
  int64_t distance_of(uint32_t bone) {
    return cosine_distance(offset_from_bone(list_.bones[bone], position_), euclid2(bone), mesh_.normals[vertex_]);
  }
  // No bone with a larger Euclid^2 can have a distance tied with `distance`: the cosine divides by at most 1.0005.
  static uint64_t reach2(int64_t distance) {
    const int64_t reach = distance + (distance >> 9) + 1;
    const uint64_t bounded = reach > 0x7FFFFFFF ? 0x7FFFFFFFu : static_cast<uint64_t>(reach);
    return bounded * bounded;
  }

  void with_cosine() {
    uint32_t best = last_best_ < list_.count ? last_best_ : 0;  // the neighbor's bone prunes most of the others at once
    int64_t smallest = distance_of(best);
    uint64_t limit = reach2(smallest);
    gather(limit);
    for (uint32_t i = 0; i < near_count_; ++i) {
      const uint32_t b = near_[i];
      if (b == best || beyond(b, limit)) continue;
      const int64_t distance = distance_of(b);
      if (distance < smallest || (distance == smallest && b < best)) {
        best = b;
        smallest = distance;
        limit = reach2(smallest);
      }
    }
    last_best_ = best;
    uint16_t* ties = out_.ties[0] + static_cast<size_t>(vertex_) * kMaxTies;
    uint8_t parts = 0, merged = 0;
    tie_count_ = 0;
    for (uint32_t i = 0; i < near_count_ && tie_count_ < kMaxTies; ++i) {
      const uint32_t b = near_[i];
      if (beyond(b, limit) || (b != best && !tied(distance_of(b), smallest))) continue;
      tie_bones_[tie_count_] = b;
      ties[tie_count_] = list_.bones[b].joint;
      if (!hidden_by_own(b)) {
        parts = static_cast<uint8_t>(parts | 1u << tie_count_);
        if (!hidden_by_others(b)) merged = static_cast<uint8_t>(merged | 1u << tie_count_);
      }
      ++tie_count_;
    }
    for (uint32_t t = tie_count_; t < kMaxTies; ++t) ties[t] = kNoJoint;
    out_.distance[0][vertex_] = smallest;
    out_.nearest[0][vertex_] = list_.bones[best].joint;
    out_.mask[kFieldRule][vertex_] = merged;
    out_.mask[kFieldParts][vertex_] = parts;
  }

  bool seen_past_own(uint32_t bone) {
    for (uint32_t t = 0; t < tie_count_; ++t) {  // already answered
      if (tie_bones_[t] == bone) return (out_.mask[kFieldParts][vertex_] >> t & 1) != 0;
    }
    return !hidden_by_own(bone);
  }

  // kNoBone when all were tried.
  uint32_t nearest_untried() {
    for (;;) {
      uint64_t least = kTried;
      uint32_t best = kNoBone;
      for (uint32_t i = 0; i < near_count_; ++i) {
        const uint32_t b = near_[i];
        best = euclid2_[b] < least ? b : best;
        least = euclid2_[b] < least ? euclid2_[b] : least;
      }
      if (least > near_limit_) {
        if (near_limit_ == kAnywhere) return kNoBone;
        gather(kAnywhere);
        continue;
      }
      if (known_[best] != 0) return best;
      (void)euclid2(best);  // a bound was the smallest: it may not stay so
    }
  }

  // Nearest visible bones by plain distance; euclid2 is used up.
  void soft() {
    uint16_t* ties = out_.ties[1] + static_cast<size_t>(vertex_) * kMaxTies;
    uint32_t count = 0;
    uint8_t mask = 0;
    const uint32_t nearest = nearest_untried();
    int64_t smallest = euclid_q6(euclid2_[nearest]);
    out_.nearest[1][vertex_] = list_.bones[nearest].joint;
    // Without a visible bone the tied nearest ones stay, masked out, for parts that see nothing at all.
    if (reach2(smallest) > near_limit_) gather(kAnywhere);
    for (uint32_t i = 0; i < near_count_ && count < kMaxTies; ++i) {
      const uint32_t b = near_[i];
      if (!beyond(b, reach2(smallest)) && tied(euclid_q6(euclid2_[b]), smallest)) ties[count++] = list_.bones[b].joint;
    }
    for (;;) {
      const uint32_t bone = nearest_untried();
      if (bone == kNoBone) break;
      if (!seen_past_own(bone)) {
        euclid2_[bone] = kTried;
        continue;
      }
      smallest = euclid_q6(euclid2_[bone]);
      count = 0;
      if (reach2(smallest) > near_limit_) gather(kAnywhere);
      for (uint32_t i = 0; i < near_count_ && count < kMaxTies; ++i) {
        const uint32_t b = near_[i];
        if (beyond(b, reach2(smallest)) || !tied(euclid_q6(euclid2_[b]), smallest)) continue;
        if (b != bone && !seen_past_own(b)) continue;
        mask = static_cast<uint8_t>(mask | 1u << count);
        ties[count++] = list_.bones[b].joint;
      }
      break;
    }
    for (uint32_t t = count; t < kMaxTies; ++t) ties[t] = kNoJoint;
    out_.distance[1][vertex_] = smallest;
    out_.mask[kFieldSoft][vertex_] = mask;
  }

  const Mesh& mesh_;
  const FaceTree& tree_;
  const BoneList& list_;
  uint64_t* const euclid2_;
  uint8_t* const known_;
  uint16_t* const near_;  // [list_.count] the lane's
  uint32_t near_count_ = 0;
  uint64_t near_limit_ = 0;  // Euclid^2 of every bone that is not among them is larger, or was tried
  HeatSources& out_;
  uint32_t vertex_ = 0;
  Vec3i position_ = {0, 0, 0};
  uint32_t first_ = 0, last_ = 0;
  uint32_t own_hint_ = FaceTree::kNoGroup, other_hint_ = FaceTree::kNoGroup;
  uint32_t last_best_ = 0;
  uint32_t tie_count_ = 0;
  uint32_t tie_bones_[kMaxTies] = {};
};

uint8_t full_mask(const uint16_t* ties) {
  uint8_t mask = 0;
  for (uint32_t t = 0; t < kMaxTies; ++t) {
    if (ties[t] != kNoJoint) mask = static_cast<uint8_t>(mask | 1u << t);
  }
  return mask;
}

void open_part(const Mesh& mesh, uint32_t part, const uint16_t* ties, uint8_t* mask) {
  for (uint32_t i = mesh.part_offsets[part]; i < mesh.part_offsets[part + 1]; ++i) {
    const uint32_t v = mesh.part_vertices[i];
    mask[v] = full_mask(ties + static_cast<size_t>(v) * kMaxTies);
  }
}

// Merged when more than a tenth of the part has a source, else parts, else open; a field whose part has no
// source at all is open there, too.
void apply_rule(const Mesh& mesh, HeatSources* out) {
  for (uint32_t c = 0; c < mesh.part_count; ++c) {
    uint32_t counts[kFieldCount] = {};
    for (uint32_t i = mesh.part_offsets[c]; i < mesh.part_offsets[c + 1]; ++i) {
      for (uint32_t f = 0; f < kFieldCount; ++f) counts[f] += out->mask[f][mesh.part_vertices[i]] != 0;
    }
    const uint32_t size = mesh.part_sizes[c];
    out->part_rule[c] = 0;
    if (static_cast<uint64_t>(counts[kFieldRule]) * 10 <= size) {
      out->part_rule[c] = static_cast<uint64_t>(counts[kFieldParts]) * 10 > size ? 1 : 2;
    }
    if (counts[kFieldParts] == 0) open_part(mesh, c, out->ties[0], out->mask[kFieldParts]);
    if (counts[kFieldSoft] == 0) open_part(mesh, c, out->ties[1], out->mask[kFieldSoft]);
    if (out->part_rule[c] == 2) open_part(mesh, c, out->ties[0], out->mask[kFieldRule]);
    if (out->part_rule[c] == 1) {
      for (uint32_t i = mesh.part_offsets[c]; i < mesh.part_offsets[c + 1]; ++i) {
        const uint32_t v = mesh.part_vertices[i];
        out->mask[kFieldRule][v] = out->mask[kFieldParts][v];
      }
    }
  }
}

bool allocate_scratch(Arena& arena, const Counts& counts, FaceTree* tree, BoneList* list) {
  return tree->allocate(arena, counts) && list->allocate(arena, counts);
}

}  // namespace

bool HeatSources::allocate(Arena& arena, const Counts& counts) {
  HeatFields fields;
  for (HeatField& field : fields.field) {
    field.nearest = arena.alloc<uint16_t>(counts.vertices);
    field.has_source = arena.alloc<uint8_t>(counts.vertices);
  }
  fields.part_rule = arena.alloc<uint8_t>(counts.vertices);
  return allocate_beside(arena, counts, fields);
}

bool HeatSources::allocate_beside(Arena& arena, const Counts& counts, const HeatFields& fields) {
  for (int m = 0; m < 2; ++m) {
    ties[m] = arena.alloc<uint16_t>(static_cast<size_t>(counts.vertices) * kMaxTies);
    distance[m] = arena.alloc<int64_t>(counts.vertices);
    nearest[m] = fields.field[m == 0 ? kFieldRule : kFieldSoft].nearest;
  }
  for (uint32_t f = 0; f < kFieldCount; ++f) mask[f] = fields.field[f].has_source;
  part_rule = fields.part_rule;
  return arena.ok();
}

sinew_status find_sources(const Mesh& mesh, const Skeleton& skeleton, const uint8_t* source_joints,
                          const Counts& counts, BoxKernel boxes_met, const Progress& progress, uint32_t permille_end,
                          Arena& arena, HeatSources* sources) {
  const ArenaScope scope(arena);
  FaceTree tree;
  BoneList list;
  if (!allocate_scratch(arena, counts, &tree, &list)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  tree.boxes_met = boxes_met;
  tree.build(mesh);
  list.build(skeleton, source_joints);
  // The previous vertex changes a finder's time, never its result.
  constexpr uint32_t kVertexPiece = 128;
  const uint32_t round = 1024 * counts.threads.lane_count();  // vertices between two reports
  for (uint32_t first = 0; first < mesh.welded_count; first += round) {
    if (!progress.report(static_cast<uint32_t>(static_cast<uint64_t>(first) * permille_end / mesh.welded_count)))
      return SINEW_ERROR_CANCELLED;
    const uint32_t rest = mesh.welded_count - first;
    counts.threads.ranges(rest < round ? rest : round, kVertexPiece, [&](uint32_t begin, uint32_t end, uint32_t lane) {
      SourceFinder finder(mesh, tree, list, lane, *sources);
      for (uint32_t v = first + begin; v < first + end; ++v) finder.run(v);
    });
  }
  apply_rule(mesh, sources);
  return SINEW_OK;
}

int64_t source_pull_q40(uint64_t area, int64_t distance, uint32_t field) {
  constexpr uint64_t kLargestArea = static_cast<uint64_t>(1) << 56;
  const uint64_t d = static_cast<uint64_t>(distance < kMinDistance ? kMinDistance : distance);
  const uint64_t tenths = field == kFieldSoft ? 7 : 40;
  // tenths / 10 * area * (2^6)^2 / d^2 in Q40. Divided twice, each time from a dividend with its top bit at 62, so that
  // at least 17 bits are left whatever d is.
  uint64_t value = (area < 1 ? 1 : area > kLargestArea ? kLargestArea : area) * tenths;
  int exponent = 2 * kDistanceBits + 40;
  const uint64_t divisors[2] = {d, 10 * d};
  for (const uint64_t divisor : divisors) {
    while (value >> 62 == 0) {
      value <<= 1;
      --exponent;
    }
    value /= divisor;
  }
  constexpr int64_t kLargest = static_cast<int64_t>(1) << 62;
  while (exponent > 0) {
    if (value >> 61 != 0) return kLargest;
    value <<= 1;
    --exponent;
  }
  if (exponent < -62) return 1;
  const int64_t pull = round_shift(static_cast<int64_t>(value), -exponent);
  return pull < 1 ? 1 : pull;
}

}  // namespace sinew
