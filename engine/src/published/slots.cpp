// SPDX-License-Identifier: MIT
// Points to joints by attention, joints to pairs, pairs to a tree. Integers only.
#include "published/slots.hpp"

#include "core/vector_math.hpp"
#include "votes/point_voter.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kSlotSets = 4;  // of points, whose joints are averaged
constexpr int kLogitBits = 10;
constexpr int32_t kLog2E = 94548;  // Q16

// 1 / (1 + e^-x) of a logit in Q10; Q15.
uint16_t probability(int32_t logit) {
  const int64_t size = abs64(logit);
  const int64_t power = exp2_negative((size * kLog2E) >> kLogitBits);  // Q30 of e^-|x|
  const int64_t small = (power << 15) / ((int64_t{1} << 30) + power);
  return static_cast<uint16_t>(logit >= 0 ? (1 << 15) - small : small);
}

// The mesh's own memory of both runs.
struct SlotScratch {
  Interior interior;
  PointSet set;
  PointRows points;
  int16_t *features, *outputs, *pairs;
  int64_t* attention;
  SlotJoints* joints;
  uint16_t* pair_joints;
  uint32_t *pair_part, *pair_vertices, *pair_offsets;

  bool allocate(Arena& arena) {
    (void)interior.allocate(arena);
    (void)set.allocate(arena);
    (void)points.allocate(arena);
    features = arena.alloc<int16_t>(size_t{kSetPoints} * kRigChannels);
    outputs = arena.alloc<int16_t>(size_t{kSetPoints} * kSlotRow);
    pairs = arena.alloc<int16_t>(size_t{kSlotPairs} * kPairChannels);
    attention = arena.alloc<int64_t>(kSetPoints);
    joints = arena.alloc<SlotJoints>(1);
    pair_joints = arena.alloc<uint16_t>(kSlotPairs);
    pair_part = arena.alloc<uint32_t>(kSlotPairs);
    pair_vertices = arena.alloc<uint32_t>(kSlotPairs);
    pair_offsets = arena.alloc<uint32_t>(kSlotPairs + 1);
    if (!arena.ok() || arena.measuring()) return arena.ok();
    points.fill(kNeighbors);
    for (uint32_t i = 0; i < kSetPoints; ++i) points.joints[i] = 0;  // one slot a point, which is present
    *joints = SlotJoints();
    for (uint32_t i = 0; i < kSlotPairs; ++i) {
      pair_joints[i] = 0;
      pair_part[i] = 0;
      pair_vertices[i] = i;
    }
    for (uint32_t i = 0; i <= kSlotPairs; ++i) pair_offsets[i] = 0;
    return true;
  }
  NetworkInput point_input() const {
    NetworkInput input = points.input(set.features, set.near_neighbors, set.far_neighbors);
    input.inputs[0] = features;
    return input;
  }
  NetworkInput pair_input() const {
    NetworkInput input;
    input.vertex_count = kSlotPairs;
    input.candidate_count = 1;
    input.inputs[0] = pairs;
    input.joints = pair_joints;
    input.row_offsets = input.far_offsets = pair_offsets;
    input.col_indices = input.far_indices = pair_offsets;
    input.part = pair_part;
    input.part_offsets = points.part_offsets;
    input.part_vertices = pair_vertices;
    input.part_count = 1;
    input.joint_count = 1;
    return input;
  }
};

struct SlotTree {
  uint8_t slots[kSlots];  // joints, then bone ends
  uint32_t joints = 0, count = 0;
  int8_t parents[kSlots];  // of `slots`
};

int16_t connection_of(const SlotJoints& joints, const SlotTree& tree, uint32_t a, uint32_t b) {
  const uint32_t i = tree.slots[a], j = tree.slots[b];
  return joints.connection[i < j ? slot_pair(i, j) : slot_pair(j, i)];
}

void choose_slots(const SlotJoints& joints, BodyKind category, const RigOptions& options, SlotTree* tree) {
  uint32_t likeliest = 0;
  for (uint32_t pass = 0; pass < 2; ++pass) {
    for (uint32_t i = 0; i < kSlots; ++i) {
      const JointSlot& slot = joint_slots()[i];
      if (slot.tip != (pass == 1) || !in_category(slot, category)) continue;
      if ((slot.tip && !options.ends) || (slot.joint_class == kClassToe && !slot.tip && !options.toes)) continue;
      if (!slot.tip && joints.presence[i] > joints.presence[likeliest]) likeliest = i;
      if (joints.presence[i] > 0) tree->slots[tree->count++] = static_cast<uint8_t>(i);
    }
    if (pass == 1) break;
    if (tree->count == 0) tree->slots[tree->count++] = static_cast<uint8_t>(likeliest);
    tree->joints = tree->count;
  }
}

// Grown from the root by the likeliest connection that reaches something new: the tree that is left when edges of the
// published weight, -ln(p + 0.01), go from the heaviest on, if their ends are connected without them.
void span_tree(const SlotJoints& joints, SlotTree* tree) {
  bool met[kSlots] = {};
  for (uint32_t i = 0; i < tree->count; ++i) tree->parents[i] = -1;
  met[0] = true;
  for (uint32_t step = 1; step < tree->joints; ++step) {
    int32_t best = INT32_MIN;
    uint32_t from = 0, to = 0;
    for (uint32_t a = 0; a < tree->joints; ++a) {
      for (uint32_t b = 0; b < tree->joints; ++b) {
        if (!met[a] || met[b] || connection_of(joints, *tree, a, b) <= best) continue;
        best = connection_of(joints, *tree, a, b);
        from = a;
        to = b;
      }
    }
    met[to] = true;
    tree->parents[to] = static_cast<int8_t>(from);
  }
  for (uint32_t end = tree->joints; end < tree->count; ++end) {
    uint32_t best = 0;
    for (uint32_t a = 1; a < tree->joints; ++a)
      if (connection_of(joints, *tree, a, end) > connection_of(joints, *tree, best, end)) best = a;
    tree->parents[end] = static_cast<int8_t>(best);
  }
}

RigJoint make_joint(const SlotJoints& joints, const SlotTree& tree, uint32_t i, int16_t parent) {
  const uint32_t slot = tree.slots[i];
  const JointSlot& what = joint_slots()[slot];
  RigJoint joint = {};
  joint.position = joints.positions[slot];
  joint.parent = parent;
  joint.partner = -1;
  joint.joint_class =
      what.tip ? joint_slots()[tree.slots[static_cast<uint32_t>(tree.parents[i])]].joint_class : what.joint_class;
  joint.tip = what.tip ? 1 : 0;
  joint.confidence = probability(joints.presence[slot]);
  joint.parent_confidence = parent < 0
                                ? uint16_t{1 << 15}
                                : probability(connection_of(joints, tree, i, static_cast<uint32_t>(tree.parents[i])));
  joint.side = what.side == SlotSide::kLeft ? int8_t{1} : what.side == SlotSide::kRight ? int8_t{-1} : int8_t{0};
  return joint;
}

// Position of a slot's joint as predicted by a point. Below 2^22.
Vec3i pointed(const SurfacePoint& point, const int16_t* slot_row) {
  constexpr int kToGrid = kGridBits - kLogitBits - 4;
  static_assert(kRigOffsetScale == 16, "an offset's scale in bits");
  const Vec3i p = point.position;
  return {p.x + slot_row[kSlotPointOffset] * (1 << kToGrid), p.y + slot_row[kSlotPointOffset + 1] * (1 << kToGrid),
          p.z + slot_row[kSlotPointOffset + 2] * (1 << kToGrid)};
}

}  // namespace

void add_slot_joints(const SurfacePoint* points, const int16_t* rows, int64_t* attention, SlotJoints* sum) {
  for (uint32_t slot = 0; slot < kSlots; ++slot) {
    const int16_t* const own = rows + slot * kSlotChannels;
    int32_t most = INT16_MIN;
    for (uint32_t i = 0; i < kSetPoints; ++i) {
      const int32_t logit = own[size_t{i} * kSlotRow + kSlotAttention];
      if (logit > most) most = logit;
    }
    // Attention is below 2^20 and positions below 2^22: sums stay below 2^52.
    int64_t whole = 0, presence = 0;
    Vec3l at = {0, 0, 0};
    for (uint32_t i = 0; i < kSetPoints; ++i) {
      const int16_t* const row = own + size_t{i} * kSlotRow;
      const int64_t a = exp2_negative(int64_t{most - row[kSlotAttention]} << (16 - kLogitBits)) >> 10;
      const Vec3i p = pointed(points[i], row);
      at = {at.x + a * p.x, at.y + a * p.y, at.z + a * p.z};
      presence += a * row[kSlotLogit];
      whole += a;
      attention[i] = a;
    }
    const Vec3i mean = {static_cast<int32_t>(round_div(at.x, whole)), static_cast<int32_t>(round_div(at.y, whole)),
                        static_cast<int32_t>(round_div(at.z, whole))};
    sum->positions[slot] = {sum->positions[slot].x + mean.x, sum->positions[slot].y + mean.y,
                            sum->positions[slot].z + mean.z};
    // Below 2^20 times 2^23 for each point.
    int64_t apart = 0;
    for (uint32_t i = 0; i < kSetPoints; ++i) {
      const Vec3i d = pointed(points[i], own + size_t{i} * kSlotRow) - mean;
      apart += attention[i] * static_cast<int64_t>(isqrt64(static_cast<uint64_t>(dot(d, d))));
    }
    sum->scatter[slot] += static_cast<int32_t>(apart / whole);
    sum->presence[slot] += static_cast<int32_t>(round_div(presence, whole));
  }
  for (uint32_t c = 0; c < kMeshChannels; ++c) sum->mesh[c] += rows[kMeshRow + c];
}

void pair_rows(const SlotJoints& joints, int16_t* rows) {
  constexpr int16_t kOne = 1 << 13, kMost = 16383;
  const auto length = [](int64_t v) { return clamp16(round_shift(v, kToQ13), -kMost - 1, kMost); };
  for (uint32_t i = 0; i < kSlots; ++i) {
    for (uint32_t j = i + 1; j < kSlots; ++j) {
      int16_t* const row = rows + size_t{slot_pair(i, j)} * kPairChannels;
      for (uint32_t c = 0; c < kPairMesh; ++c) row[c] = 0;
      const Vec3i d = joints.positions[j] - joints.positions[i];
      row[kPairOffset] = length(d.x);
      row[kPairOffset + 1] = length(d.y);
      row[kPairOffset + 2] = length(d.z);
      row[kPairOffset + 3] = length(isqrt64(static_cast<uint64_t>(dot(d, d))));
      row[kPairFirst + i] = row[kPairSecond + j] = kOne;
      static_assert(kMeshRowDivisor == 8, "Q10 divided by it is Q13 of the same number");
      for (uint32_t c = 0; c < kMeshChannels; ++c) row[kPairMesh + c] = clamp16(joints.mesh[c], -kMost - 1, kMost);
    }
  }
}

void join_slots(const SlotJoints& joints, BodyKind category, const RigOptions& options, Rig* rig) {
  SlotTree tree;
  choose_slots(joints, category, options, &tree);
  span_tree(joints, &tree);
  int16_t number[kSlots];
  for (uint32_t i = 0; i < tree.count; ++i) number[i] = -1;
  uint32_t order[kSlots] = {};
  rig->count = 1;
  rig->joints[0] = make_joint(joints, tree, 0, -1);
  number[0] = 0;
  for (uint32_t next = 0; next < rig->count; ++next) {
    for (uint32_t i = 0; i < tree.count; ++i) {
      if (number[i] >= 0 || tree.parents[i] != static_cast<int8_t>(order[next])) continue;
      number[i] = static_cast<int16_t>(rig->count);
      order[rig->count] = i;
      rig->joints[rig->count++] = make_joint(joints, tree, i, static_cast<int16_t>(next));
    }
  }
  int64_t scatter = 0;
  for (uint32_t i = 0; i < tree.count; ++i) scatter += joints.scatter[tree.slots[i]];
  constexpr int kToSpread = kGridBits - 16 + 2;  // to Q16, and a quarter
  const int64_t spread = (scatter / tree.count) >> kToSpread;
  rig->spread = static_cast<uint16_t>(spread < UINT16_MAX ? spread : UINT16_MAX);
}

sinew_status find_slots(const SlotsPlan& plan, const RigOptions& options, const Mesh& mesh, const Kernels& kernels,
                        const Progress& progress, Arena& arena, Rig* rig) {
  const ArenaScope scope(arena);
  SlotScratch s;
  if (!s.allocate(arena) || !build_interior(mesh, arena, &s.interior)) return SINEW_ERROR_WORKSPACE;
  constexpr uint64_t kFirstSeed = 7;
  bool sheet = false;
  for (uint32_t i = 0; i < kSlotSets; ++i) {
    if (!make_point_set(mesh, s.interior, kFirstSeed + i, arena, &s.set)) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring()) {
      unfold_features(s.set, s.features);
      sheet = sheet || is_sheet(s.set.points, kSetPoints);
    }
    const Progress part = progress.part(800 * i / kSlotSets, 800 * (i + 1) / kSlotSets);
    const sinew_status status =
        run_network(plan.joints, s.point_input(), kernels, part, arena, s.outputs, plan.network);
    if (status != SINEW_OK) return status;
    if (arena.measuring()) break;
    add_slot_joints(s.set.points, s.outputs, s.attention, s.joints);
  }
  if (!arena.measuring()) {
    for (uint32_t i = 0; i < kSlots; ++i) {
      const Vec3i sum = s.joints->positions[i];
      s.joints->positions[i] = round_div(Vec3l{sum.x, sum.y, sum.z}, kSlotSets);
      s.joints->presence[i] = static_cast<int32_t>(round_div(int64_t{s.joints->presence[i]}, kSlotSets));
      s.joints->scatter[i] /= int32_t{kSlotSets};
    }
    for (int32_t& value : s.joints->mesh) value = static_cast<int32_t>(round_div(int64_t{value}, kSlotSets));
    pair_rows(*s.joints, s.pairs);
  }
  int16_t* const logits = arena.measuring() ? nullptr : s.joints->connection;
  const sinew_status status =
      run_network(plan.connections, s.pair_input(), kernels, progress.part(800, 1000), arena, logits, plan.network);
  if (status != SINEW_OK || arena.measuring()) return status;
  join_slots(*s.joints, plan.category, options, rig);
  if (sheet && rig->spread < kSheetSpread) rig->spread = kSheetSpread;
  return SINEW_OK;
}

}  // namespace sinew::rigging
