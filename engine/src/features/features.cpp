// SPDX-License-Identifier: MIT
// Stages 5 to 7 of a bind: final candidates and the feature rows of vertices and (vertex, candidate) pairs. Works part
// by part, because what a part as a whole leans on (its own heat, its host's heat, subtrees) decides for all its
// vertices.
#include "features/features.hpp"

#include <string.h>

#include "features/attributes.hpp"
#include "features/part_tables.hpp"
#include "skeleton/bones.hpp"

namespace sinew {
namespace features {
namespace {

constexpr uint32_t kListedHeat = 1638;  // Q15, 5 %: a heat joint above it is always a candidate

// Data of a joint for the current vertex.
struct JointEntry {
  uint32_t vertex;                       // 1 + the vertex that it is of; the rest is 0 for any other
  uint32_t distance;                     // 1 + the voxel candidate's, 0 where it is none
  uint32_t children_rule;                // weights of the joint's children in the rule field, Q15
  uint16_t rule, parts, soft, rule_raw;  // Q15
  uint16_t chosen;
};

// A segment from a joint. The same size on every host.
struct alignas(8) Bone {
  int64_t length2;
  Vec3i direction;  // from the joint to the end
  uint32_t length;
  int16_t up, length_share;  // Q13: the direction's, and of a quarter of the mesh's longest side
  int32_t unused;
};

struct Scratch {
  Parts parts;
  PartTables* tables = nullptr;      // [lanes]
  uint64_t* keys = nullptr;          // [V] (host distance, vertex) of one part, lane 0
  uint64_t* small_keys = nullptr;    // [lanes - 1 x kSmallPart] of the other lanes, which never take a large part alone
  JointEntry* entries = nullptr;     // [lanes x J]
  uint32_t* bone_offsets = nullptr;  // [J + 1]
  Bone* bones = nullptr;             // [2 J] of each joint: one to every child, a leaf's to its tip

  bool allocate(Arena& arena, const Counts& counts) {
    const uint32_t lanes = counts.threads.lane_count();
    parts.allocate(arena, counts);
    tables = arena.alloc<PartTables>(lanes);
    for (uint32_t lane = 0; lane < lanes; ++lane) {
      PartTables table;
      table.allocate(arena, counts.joints);
      if (!arena.measuring() && arena.ok()) tables[lane] = table;
    }
    keys = arena.alloc<uint64_t>(counts.vertices);
    small_keys = arena.alloc<uint64_t>(static_cast<size_t>(lanes - 1) * kSmallPart);
    entries = arena.alloc<JointEntry>(static_cast<size_t>(lanes) * counts.joints);
    bone_offsets = arena.alloc<uint32_t>(static_cast<size_t>(counts.joints) + 1);
    bones = arena.alloc<Bone>(static_cast<size_t>(2) * counts.joints);
    return arena.ok();
  }
};

Bone make_bone(Vec3i head, Vec3i tail) {
  Bone bone;
  bone.direction = tail - head;
  bone.length2 = dot(bone.direction, bone.direction);
  bone.length = isqrt64(static_cast<uint64_t>(bone.length2));
  bone.up = bone.length == 0 ? int16_t{0} : ratio_q13(bone.direction.y, bone.length);
  bone.length_share = side_ratio_q13(4 * static_cast<int64_t>(bone.length));
  return bone;
}

void list_bones(const Skeleton& skeleton, const Vec3i* tips, uint32_t* offsets, Bone* bones) {
  const uint32_t joints = skeleton.joint_count;
  // offsets[j + 1] starts at the begin of row j and moves to its end while the row is filled.
  uint32_t begin = 0;
  offsets[0] = 0;
  for (uint32_t j = 0; j < joints; ++j) {
    offsets[j + 1] = begin;
    begin += bone_count(skeleton, j);
  }
  each_bone(skeleton, tips,
            [&](uint32_t joint, Vec3i head, Vec3i tail) { bones[offsets[joint + 1]++] = make_bone(head, tail); });
}

// Inputs of all lanes, and the rows that they write.
struct Inputs {
  const Mesh& mesh;
  const Skeleton& skeleton;
  const Candidates& candidates;
  const HeatFields& heat;
  const Scratch& scratch;
  Features* out;
};

// One lane's work.
class RowBuilder {
 public:
  // `tables` are filled by fill() or were, by another lane's.
  RowBuilder(const Inputs& inputs, PartTables& tables, uint64_t* keys, JointEntry* entries)
      : mesh_(inputs.mesh),
        skeleton_(inputs.skeleton),
        candidates_(inputs.candidates),
        heat_(inputs.heat),
        s_(inputs.scratch),
        out_(inputs.out),
        k_(inputs.candidates.k),
        tables_(tables),
        part_(mesh_, skeleton_, candidates_, heat_, s_.parts, tables, keys),
        entries_(entries) {}

  void fill_tables(uint32_t c) { part_.fill(c); }

  // Vertices [first, end) of the list of parts, all of part c.
  void write(uint32_t c, uint32_t first, uint32_t end) {
    for (uint32_t i = first; i < end; ++i) {
      const uint32_t v = mesh_.part_vertices[i];
      load_rows(v);
      choose_candidates(v);
      write_vertex(v, c);
      write_pairs(v, c);
    }
  }

 private:
  JointEntry& entry(uint32_t joint) {
    JointEntry& e = entries_[joint];
    if (e.vertex != stamp_) {
      e = JointEntry();
      e.vertex = stamp_;
    }
    return e;
  }

  void load_rows(uint32_t v) {
    stamp_ = v + 1;
    const HeatField &rule = heat_.field[kFieldRule], &parts = heat_.field[kFieldParts];
    const size_t first = static_cast<size_t>(v) * kHeatSlots;
    rule_.load(rule, v);
    uint32_t other = 0;
    for (size_t i = first; i < first + kHeatSlots; ++i) {
      other |= static_cast<uint32_t>(rule.joints[i] ^ parts.joints[i]) |
               static_cast<uint32_t>(rule.weights[i] ^ parts.weights[i]);
    }
    if (other == 0) {
      parts_ = rule_;  // as a rule
    } else {
      parts_.load(parts, v);
    }
    soft_.load(heat_.field[kFieldSoft], v);
    for (uint32_t i = 0; i < kHeatSlots && rule.joints[first + i] != kNoJoint; ++i) {
      entry(rule.joints[first + i]).rule_raw = rule.weights[first + i];
    }
    for (uint32_t i = 0; i < rule_.count; ++i) {
      const uint32_t joint = rule_.joints[i];
      entry(joint).rule = rule_.weights[i];
      if (skeleton_.parents[joint] >= 0) {
        entry(static_cast<uint32_t>(skeleton_.parents[joint])).children_rule += rule_.weights[i];
      }
    }
    for (uint32_t i = 0; i < parts_.count; ++i) entry(parts_.joints[i]).parts = parts_.weights[i];
    for (uint32_t i = 0; i < soft_.count; ++i) entry(soft_.joints[i]).soft = soft_.weights[i];
  }

  // Heat's joints and the part's favorites first, then the voxel candidates by distance until K are there. What the
  // rigid answer for a whole part could be must be open to each of its vertices.
  void choose_candidates(uint32_t v) {
    const PartTables& t = tables_;
    const uint16_t* voxel = candidates_.joints + static_cast<size_t>(v) * k_;
    const uint32_t* voxel_distance = candidates_.distances + static_cast<size_t>(v) * k_;
    count_ = 0;
    const uint32_t top = rule_.top();
    add(rule_.joints[top]);
    add(heat_.field[kFieldRule].nearest[v]);
    for (uint32_t i = 0; i < rule_.count && count_ + 3 < k_; ++i) {
      if (rule_.weights[i] >= kListedHeat) add(rule_.joints[i]);
    }
    add(t.host_top);
    add(t.own_top);
    if (mesh_.part[v] != 0) add(t.box_top);
    for (uint32_t i = 0; i < k_; ++i) add(voxel[i]);
    for (uint32_t i = 0; i < parts_.count; ++i) add(parts_.joints[i]);

    uint32_t farthest = 0;
    for (uint32_t i = 0; i < k_ && voxel[i] != kNoJoint; ++i) {
      farthest = voxel_distance[i];
      entry(voxel[i]).distance = farthest + 1;
    }
    for (uint32_t i = 0; i < count_; ++i) {
      const uint32_t distance = entries_[joints_[i]].distance;
      distances_[i] = distance != 0 ? distance - 1 : farthest + 1;  // those the search did not bring come last
    }
    for (uint32_t i = 1; i < count_; ++i) {  // insertion sort by (distance, joint)
      const uint32_t d = distances_[i];
      const uint16_t j = joints_[i];
      uint32_t at = i;
      for (; at > 0 && (distances_[at - 1] > d || (distances_[at - 1] == d && joints_[at - 1] > j)); --at) {
        distances_[at] = distances_[at - 1];
        joints_[at] = joints_[at - 1];
      }
      distances_[at] = d;
      joints_[at] = j;
    }
    uint16_t* out = out_->joints + static_cast<size_t>(v) * k_;
    for (uint32_t i = 0; i < k_; ++i) out[i] = i < count_ ? joints_[i] : kNoJoint;
  }

  void add(uint16_t joint) {
    if (joint == kNoJoint || count_ >= k_ || skeleton_.usable[joint] == 0) return;
    JointEntry& e = entry(joint);
    if (e.chosen != 0) return;
    e.chosen = 1;
    joints_[count_++] = joint;
  }

  void write_vertex(uint32_t v, uint32_t c) {
    int16_t* f = out_->vertex + static_cast<size_t>(v) * out_->vertex_channels;
    memcpy(f, tables_.vertex, kVertexFeatureCount * sizeof(int16_t));
    f[kV_mean_curvature] = q13(mesh_.mean_curvature[v]);
    f[kV_gauss_curvature] = q13(mesh_.gauss_curvature[v]);
    f[kV_edge_length_log] = log_q13(static_cast<uint64_t>(mesh_.edge_length[v]) + 64, 14 << 16, 2);
    if (c != 0) f[kV_host_gap] = log_q13(s_.parts.host_distance[v] + uint64_t{kSoftLength}, 12 << 16, 2);
    f[kV_has_source] = heat_.field[kFieldRule].has_source[v] != 0 ? kOne : 0;
    f[kV_has_source_parts] = heat_.field[kFieldParts].has_source[v] != 0 ? kOne : 0;
    f[kV_normal_up] = q13(mesh_.normals[v].y >> (kNormalBits - kFeatureBits));
  }

  struct BoneFit {
    uint32_t distance;
    int32_t along_q13;  // 0 at the head, 8192 at the tail
    Vec3i away;         // from the nearest point to the vertex
    const Bone* bone;
  };

  // The nearest of a joint's bones.
  BoneFit fit_bone(Vec3i p, uint32_t joint) const {
    const Vec3i to = p - skeleton_.positions[joint];
    BoneFit best{0xFFFFFFFFu, 0, {0, 0, 0}, nullptr};
    for (uint32_t i = s_.bone_offsets[joint]; i < s_.bone_offsets[joint + 1]; ++i) {
      const Bone& bone = s_.bones[i];
      int64_t t = 0;  // Q20
      if (bone.length2 > 0) {
        const int shift = bone.length2 >> 42 != 0 ? 10 : 0;  // coordinates are below 2^23, so length2 < 2^50
        int64_t along = dot(to, bone.direction);
        along = along < 0 ? 0 : along > bone.length2 ? bone.length2 : along;
        t = ((along >> shift) << 20) / (bone.length2 >> shift);
      }
      const Vec3i away = {to.x - static_cast<int32_t>(round_shift(bone.direction.x * t, 20)),
                          to.y - static_cast<int32_t>(round_shift(bone.direction.y * t, 20)),
                          to.z - static_cast<int32_t>(round_shift(bone.direction.z * t, 20))};
      const uint32_t distance = isqrt64(static_cast<uint64_t>(dot(away, away)));
      if (distance < best.distance) best = {distance, static_cast<int32_t>(t >> 7), away, &bone};
    }
    return best;
  }

  // Edges between two joints in the tree, at most 15.
  uint32_t tree_distance(uint32_t a, uint32_t b) const {
    uint32_t steps = 0;
    while (a != b && steps < 15) {
      if (skeleton_.depth[a] >= skeleton_.depth[b]) {
        if (skeleton_.parents[a] < 0) return 15;  // two roots: different trees
        a = static_cast<uint32_t>(skeleton_.parents[a]);
      } else {
        b = static_cast<uint32_t>(skeleton_.parents[b]);
      }
      ++steps;
    }
    return steps;
  }

  void write_pairs(uint32_t v, uint32_t c) {
    const HeatField& raw = heat_.field[kFieldRule];
    int16_t* rows = out_->pair + static_cast<size_t>(v) * k_ * kPairFeatureCount;
    memset(rows, 0, static_cast<size_t>(k_) * kPairFeatureCount * sizeof(int16_t));
    BoneFit fits[SINEW_MAX_CANDIDATES];
    uint32_t nearest_bone = 0xFFFFFFFFu;
    for (uint32_t i = 0; i < count_; ++i) {
      fits[i] = fit_bone(mesh_.positions[v], joints_[i]);
      if (fits[i].distance < nearest_bone) nearest_bone = fits[i].distance;
    }
    const uint32_t rule_top = rule_.top(), parts_top = parts_.top();
    const uint32_t top_joint = rule_.joints[rule_top];
    const int32_t nearest_voxel_log = log2_q16(distances_[0] + uint64_t{kSoftLength});
    const int32_t nearest_bone_log = log2_q16(nearest_bone + uint64_t{kSoftLength});
    for (uint32_t i = 0; i < count_; ++i) {
      const uint32_t j = joints_[i];
      const int32_t parent = skeleton_.parents[j];
      int16_t* f = rows + static_cast<size_t>(i) * kPairFeatureCount;
      const JointEntry& e = entries_[j];
      const WeightChannels of_rule = weight_channels(e.rule, rule_.weights[rule_top]);
      const bool alike = e.parts == e.rule && parts_.weights[parts_top] == rule_.weights[rule_top];  // as a rule
      const WeightChannels of_parts = alike ? of_rule : weight_channels(e.parts, parts_.weights[parts_top]);
      const WeightChannels of_soft = weight_channels(e.soft, 0);
      f[kP_rule] = of_rule.weight;
      f[kP_rule_root] = of_rule.root;
      f[kP_rule_log] = of_rule.log;
      f[kP_rule_relative] = of_rule.relative;
      f[kP_parts] = of_parts.weight;
      f[kP_parts_root] = of_parts.root;
      f[kP_parts_log] = of_parts.log;
      f[kP_parts_relative] = of_parts.relative;
      f[kP_soft] = of_soft.weight;
      f[kP_soft_root] = of_soft.root;
      f[kP_soft_log] = of_soft.log;
      f[kP_rule_raw_root] = weight_root_q13(e.rule_raw);
      f[kP_voxel_distance] = side_ratio_q13(2 * static_cast<int64_t>(distances_[i]));
      f[kP_voxel_ratio] = log_q13(distances_[i] + uint64_t{kSoftLength}, nearest_voxel_log, 2);
      const BoneFit& fit = fits[i];
      f[kP_bone_distance] = side_ratio_q13(2 * static_cast<int64_t>(fit.distance));
      f[kP_bone_ratio] = log_q13(fit.distance + uint64_t{kSoftLength}, nearest_bone_log, 2);
      f[kP_bone_position] = q13(fit.along_q13);
      f[kP_bone_cosine] = cosine_q13(fit.away, fit.distance, mesh_.normals[v]);
      f[kP_bone_normal] = cosine_q13(fit.bone->direction, fit.bone->length, mesh_.normals[v]);
      f[kP_bone_up] = fit.bone->up;
      f[kP_bone_length] = fit.bone->length_share;
      f[kP_is_leaf] = skeleton_.child_count[j] == 0 ? kOne : 0;
      f[kP_children] = q13(skeleton_.child_count[j] * (kOne / 4));
      f[kP_tree_distance] = q13(tree_distance(j, top_joint) * (kOne / 8));
      f[kP_is_parent_of_top] = skeleton_.parents[top_joint] == static_cast<int32_t>(j) ? kOne : 0;
      f[kP_is_child_of_top] = parent == static_cast<int32_t>(top_joint) ? kOne : 0;
      f[kP_is_top] = j == top_joint ? kOne : 0;
      f[kP_rule_nearest] = raw.nearest[v] == j ? kOne : 0;
      f[kP_soft_nearest] = heat_.field[kFieldSoft].nearest[v] == j ? kOne : 0;
      f[kP_parent_rule] = parent < 0 ? int16_t{0} : weight_q13(entry(static_cast<uint32_t>(parent)).rule);
      f[kP_children_rule] = weight_q13(e.children_rule);
      memcpy(f + kFirstPartChannel, part_.channels(j, c), kPartChannels * sizeof(int16_t));
    }
  }

  // Cosine of a vector of known length with a Q14 unit vector, Q13; 0 for no length.
  static int16_t cosine_q13(Vec3i vector, uint32_t length, Vec3i unit) {
    return length == 0 ? int16_t{0} : q13(round_shift(dot(vector, unit) / length, kNormalBits - kFeatureBits));
  }

  const Mesh& mesh_;
  const Skeleton& skeleton_;
  const Candidates& candidates_;
  const HeatFields& heat_;
  const Scratch& s_;
  Features* out_;
  const uint32_t k_;
  PartTables& tables_;
  PartTableBuilder part_;
  JointEntry* entries_;
  // Of the current vertex:
  HeatRow rule_, parts_, soft_;
  uint32_t stamp_ = 0;
  uint16_t joints_[SINEW_MAX_CANDIDATES] = {};
  uint32_t distances_[SINEW_MAX_CANDIDATES] = {};
  uint32_t count_ = 0;
};

// Large parts are spread over the lanes; of small ones, every lane takes some whole.
void build(const Inputs& inputs, const Threads& threads) {
  const Mesh& mesh = inputs.mesh;
  const Scratch& scratch = inputs.scratch;
  const auto keys_of = [&](uint32_t lane) {
    return lane == 0 ? scratch.keys : scratch.small_keys + static_cast<size_t>(lane - 1) * kSmallPart;
  };
  const size_t joints = inputs.skeleton.joint_count;
  memset(scratch.entries, 0, threads.lane_count() * joints * sizeof(JointEntry));
  const auto entries_of = [&](uint32_t lane) { return scratch.entries + lane * joints; };
  for (uint32_t c = 0; c < mesh.part_count;) {
    uint32_t end = c;
    while (end < mesh.part_count && mesh.part_sizes[end] < kSmallPart) ++end;
    if (end == c) {
      PartTables& tables = scratch.tables[0];
      RowBuilder(inputs, tables, keys_of(0), entries_of(0)).fill_tables(c);
      const uint32_t first = mesh.part_offsets[c];
      threads.ranges(mesh.part_sizes[c], kSmallPart / 4, [&](uint32_t from, uint32_t to, uint32_t lane) {
        RowBuilder(inputs, tables, keys_of(lane), entries_of(lane)).write(c, first + from, first + to);
      });
      ++c;
      continue;
    }
    threads.each(end - c, [&](uint32_t index, uint32_t lane) {
      RowBuilder builder(inputs, scratch.tables[lane], keys_of(lane), entries_of(lane));
      builder.fill_tables(c + index);
      builder.write(c + index, mesh.part_offsets[c + index], mesh.part_offsets[c + index + 1]);
    });
    c = end;
  }
}

}  // namespace
}  // namespace features

const uint32_t kVertexFeatures = features::kVertexFeatureCount;
const uint32_t kPairFeatures = features::kPairFeatureCount;
const uint32_t kPairLogRule = features::kP_rule_log;
const uint32_t kPairLogParts = features::kP_parts_log;

uint32_t plain_vertex_channels(uint32_t feature_flags) {
  return kHasExtras && (feature_flags & kAttributesFlag) != 0 ? uint32_t{kVertexAttributes}
                                                              : uint32_t{features::kVertexFeatureCount};
}
uint32_t pair_channels(uint32_t feature_flags) {
  return kHasExtras && (feature_flags & kAttributesFlag) != 0 ? uint32_t{kPairAttributes}
                                                              : uint32_t{features::kPairFeatureCount};
}
uint32_t vertex_channels(uint32_t feature_flags) {
  return plain_vertex_channels(feature_flags) + ((feature_flags & kSpectralFlag) != 0 ? kSpectralChannels : 0);
}

bool Features::allocate(Arena& arena, const Counts& counts) {
  const size_t pairs = static_cast<size_t>(counts.vertices) * counts.candidates;
  vertex_channels = sinew::vertex_channels(counts.feature_flags);
  vertex = arena.alloc<int16_t>(static_cast<size_t>(counts.vertices) * vertex_channels);
  pair = arena.alloc<int16_t>(pairs * pair_channels(counts.feature_flags));
  joints = arena.alloc<uint16_t>(pairs);
  return arena.ok();
}

sinew_status build_features(const Mesh& mesh, const Skeleton& skeleton, const Candidates& candidates,
                            const HeatFields& heat, const Counts& counts, Arena& arena, Features* out) {
  const ArenaScope scope(arena);
  features::Scratch scratch;
  if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  const sinew_status status = find_parts(mesh, heat, counts, arena, &scratch.parts);
  if (status != SINEW_OK || arena.measuring()) return status;
  features::list_bones(skeleton, candidates.tips, scratch.bone_offsets, scratch.bones);
  features::build({mesh, skeleton, candidates, heat, scratch, out}, counts.threads);
  return SINEW_OK;
}

}  // namespace sinew
