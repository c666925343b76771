// SPDX-License-Identifier: MIT
// Fuzz target: the size query and sinew_transfer() between arbitrary bound meshes, mostly by heat, now and then with the bundled
// model. Refusals are those that the header documents; rows obey its rules; other threads and another content of the workspace
// give the same bytes.
#include "bind_checks.hpp"
#include "fuzz.hpp"
#include "mesh_input.hpp"

namespace {

using namespace sinew::test;

struct Body : MeshInput, SkeletonInput {
  void read_body(Bytes& in, uint8_t shape) {
    const uint32_t vertices = in.below(33), joints = in.below(9), faces = in.below(41);
    read_joints(in, shape, joints);
    read(in, shape, vertices, faces);
  }
};

struct Call : Hindrance {
  Body source, target;
  sinew_bound_character bound = {};
  std::vector<uint16_t> source_joints;
  std::vector<uint8_t> source_weights, given_weights, locked;
  std::vector<uint16_t> given_joints;
  std::vector<int32_t> joint_map;
  std::vector<sinew_vertex_pair> pairs;
  sinew_transfer_options options = SINEW_INIT(sinew_transfer_options);
  const sinew_model* model = nullptr;
  uint32_t target_up = 0, source_up = 0;
  uint32_t influences = 4, weight_size = 2, part_capacity = 0;

  explicit Call(Bytes in) {
    const uint8_t shape = in.u8(), extras = in.u8();
    if ((extras & 1) != 0) read_options(in);
    read_hindrance(in, extras);
    options.progress = report;
    source.read_body(in, shape);
    if ((extras & 2) != 0) {  // the same character, as garments and repairs have it
      static_cast<SkeletonInput&>(target) = source;
      static_cast<MeshInput&>(target) = source;
      target.skeleton.positions = target.joint_positions.data();
      target.skeleton.parents = target.parents.data();
      target.mesh.positions = target.positions.data();
      target.mesh.face_vertices = target.corners.data();
      if (target.mesh.face_offsets != nullptr) target.mesh.face_offsets = target.offsets.data();
    } else {
      target.read_body(in, shape);
    }
    target.skeleton.flags = (shape & 64) != 0 ? target.flags.data() : nullptr;
    read_rows(in, extras);
    if ((extras & 16) != 0) model = fuzzed_model();
  }

  void read_options(Bytes& in) {
    options.struct_size -= in.below(32) == 31 ? 4 : 0;
    options.method = in.below(5);
    options.influence_count = in.below(14);
    options.weight_format = in.below(4);
    target_up = 2 + in.below(2);
    source_up = in.below(8) == 7 ? in.below(6) : 2 + in.below(2);
    options.garment = in.below(2);
    options.as_drawn = in.below(2);
    options.weights_in_place = in.below(2);
    influences = options.influence_count == 0 ? 4 : options.influence_count;
    weight_size = options.weight_format == SINEW_WEIGHT_UNORM8  ? 1
                  : options.weight_format == SINEW_WEIGHT_FLOAT ? 4
                                                                : 2;
    part_capacity = in.below(4);
  }

  void read_rows(Bytes& in, uint8_t extras) {
    const uint32_t from = source.mesh.vertex_count, to = target.mesh.vertex_count;
    const uint32_t from_joints = source.skeleton.joint_count, to_joints = target.skeleton.joint_count;
    bound.skin.influence_count = 1 + in.below(4);
    bound.skin.weight_format = in.below(4);
    const uint32_t size = bound.skin.weight_format == SINEW_WEIGHT_UNORM8  ? 1
                          : bound.skin.weight_format == SINEW_WEIGHT_FLOAT ? 4
                                                                           : 2;
    const uint32_t beyond = in.below(16) == 15 ? 1 : 0;
    for (uint32_t i = 0; i < from * bound.skin.influence_count; ++i) {
      source_joints.push_back(static_cast<uint16_t>(from_joints + beyond == 0 ? 0 : in.below(from_joints + beyond)));
      for (uint32_t b = 0; b < size; ++b) source_weights.push_back(in.u8());
    }
    for (uint32_t j = 0; j < from_joints; ++j) {
      const uint8_t to_joint = in.u8();
      joint_map.push_back(to_joint < 32 || to_joints == 0 ? -1 : static_cast<int32_t>(to_joint % (to_joints + beyond)));
    }
    for (uint32_t n = (extras & 4) != 0 ? in.below(9) : 0; n > 0; --n)
      pairs.push_back({from + beyond == 0 ? 0 : in.below(from + beyond), to + beyond == 0 ? 0 : in.below(to + beyond)});
    options.pairs = pairs.data();
    options.pair_count = static_cast<uint32_t>(pairs.size());
    for (uint32_t v = 0; v < to; ++v) locked.push_back(in.u8() & 1);
    if ((extras & 8) != 0) options.locked = locked.data();
    for (uint32_t i = 0; i < to * influences; ++i) {
      given_joints.push_back(static_cast<uint16_t>(in.below(to_joints + beyond + (to_joints == 0 ? 1 : 0))));
      for (uint32_t b = 0; b < weight_size; ++b) given_weights.push_back(in.u8());
    }
    bound.mesh = &source.mesh;
    source.skeleton.up = source_up;
    target.skeleton.up = target_up;
    bound.skeleton = &source.skeleton;
    bound.skin.joint_indices = source_joints.data();
    bound.skin.weights = source_weights.data();
    bound.joint_map = joint_map.data();
  }

  sinew_status measure(uint32_t threads, size_t* bytes) {
    options.thread_count = threads;
    *bytes = 1;
    return sinew_transfer_workspace_size(model, &bound, &target.mesh, &target.skeleton, &options, bytes);
  }

  struct Run {
    Binding rows;
    std::vector<uint8_t> confidence;
    std::vector<uint32_t> vertex_parts;
    sinew_transfer_outputs outputs = {};
  };
  Run run(size_t need, uint8_t fill, uint32_t threads) {
    Run r;
    r.rows.joints = given_joints;
    r.rows.weights = given_weights;
    r.confidence.assign(target.mesh.vertex_count, 77);
    r.vertex_parts.assign(target.mesh.vertex_count, 77);
    std::vector<sinew_transfer_part> parts(part_capacity + 1);
    parts[part_capacity].reserved = 77;
    r.outputs = SINEW_INIT(sinew_transfer_outputs);
    r.outputs.joint_indices = r.rows.joints.data();
    r.outputs.weights = r.rows.weights.data();
    r.outputs.confidence = r.confidence.data();
    r.outputs.vertex_parts = r.vertex_parts.data();
    r.outputs.parts = parts.data();
    r.outputs.part_capacity = part_capacity;
    options.thread_count = threads;
    // The order that is least like one thread's.
    options.parallel_for = [](void*, uint32_t count, void (*body)(void*, uint32_t), void* data) {
      while (count > 0) body(data, --count);
    };
    options.progress_user = static_cast<Hindrance*>(this);
    reports = 0;
    const size_t bytes = given(need);
    Workspace workspace(bytes, misaligned, fill);
    r.rows.status =
        sinew_transfer(model, &bound, &target.mesh, &target.skeleton, &options, workspace.data(), bytes, &r.outputs);
    demand(workspace.guards_hold(), "the workspace is not written beyond its size");
    demand(parts[part_capacity].reserved == 77, "no more parts are written than there is room for");
    if (r.rows.status == SINEW_OK) {
      demand(r.outputs.used_bytes <= bytes, "not more of the workspace is used than there is");
    } else {
      demand(r.rows.joints == given_joints && r.rows.weights == given_weights && r.outputs.used_bytes == 0 &&
                 r.outputs.part_count == 0,
             "outputs are untouched on failure");
    }
    return r;
  }
};

void check_status(const Call& call, sinew_status status) {
  if (call.explains(status)) return;
  if (status == SINEW_ERROR_NOT_FINITE) {
    demand(any_not_finite(call.source.positions) || any_not_finite(call.source.joint_positions) ||
               any_not_finite(call.target.positions) || any_not_finite(call.target.joint_positions),
           "NOT_FINITE is about a position");
    return;
  }
  demand(status == SINEW_ERROR_COUNT || status == SINEW_ERROR_INDEX || status == SINEW_ERROR_HIERARCHY ||
             status == SINEW_ERROR_NO_JOINT || status == SINEW_ERROR_RANGE,
         std::string("a documented status: ") + sinew_status_text(status));
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Call call{Bytes(data, size)};
  size_t need = 0, second_need = 0;
  const sinew_status sized = call.measure(0, &need);
  if (sized != SINEW_OK) {
    demand(need == 0, "the size is 0 on failure");
    demand(sized == SINEW_ERROR_ARGUMENT || sized == SINEW_ERROR_COUNT, "a documented status of the size query");
    demand(call.run(size_t{1} << 16, 0xA5, 0).rows.status != SINEW_OK, "what has no size cannot be transferred");
    return 0;
  }
  const Call::Run first = call.run(need, 0xA5, 0);
  if (first.rows.status != SINEW_OK) return check_status(call, first.rows.status), 0;
  demand(first.outputs.part_count >= 1, "a mesh with vertices has a part");
  for (const uint32_t part : first.vertex_parts) demand(part < first.outputs.part_count, "a part that is counted");
  sinew_bind_options rules = SINEW_INIT(sinew_bind_options);
  rules.influence_count = call.influences;
  rules.weight_format = call.options.weight_format;
  rules.locked = call.options.locked;
  sinew_skeleton skeleton = call.target.skeleton;
  skeleton.flags = nullptr;  // a joint that has a counterpart gets its weight, whatever its flags
  check_rows(first.rows, call.target.mesh, skeleton, rules);
  if (call.cancel_at != 0 || call.short_by != 0) return 0;  // where those hit depends on the number of pieces
  const uint32_t threads = 1 + static_cast<uint32_t>(size % 3);
  demand(call.measure(threads, &second_need) == SINEW_OK && second_need >= need,
         "more threads have a size, and no smaller one");
  const Call::Run second = call.run(second_need, 0x3C, threads);
  demand(first.rows.status == second.rows.status && first.rows.joints == second.rows.joints &&
             first.rows.weights == second.rows.weights && first.confidence == second.confidence &&
             first.vertex_parts == second.vertex_parts,
         "a second run gives the same bytes");
  return 0;
}
