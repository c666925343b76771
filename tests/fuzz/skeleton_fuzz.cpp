// SPDX-License-Identifier: MIT
// Fuzz target: the size query and sinew_rig() on arbitrary meshes and options with the bundled model, and
// sinew_rig_details() and sinew_bind() on what comes out. Refusals are those that the header documents; a skeleton obeys its rules, whatever the mesh.
#include <algorithm>
#include <cmath>
#include <set>

#include "bind_checks.hpp"
#include "fuzz.hpp"
#include "mesh_input.hpp"
#include "skeleton_of.hpp"

namespace {

using namespace sinew::test;

const sinew_model* rig_model() {
  static const sinew_test::BundledModel opened(SINEW_SOURCE_DIR "/samples/data/sinew_rig.sinew", sinew_rig_model_open);
  demand(opened.ok, "samples/data/sinew_rig.sinew is there and opens");
  return &opened.model;
}
const sinew_model* hands_model() {
  static const sinew_test::BundledModel opened(SINEW_SOURCE_DIR "/samples/data/sinew_hands.sinew",
                                               sinew_rig_model_open);
  demand(opened.ok, "samples/data/sinew_hands.sinew is there and opens");
  return &opened.model;
}

struct Skeleton {
  sinew_status status = SINEW_OK;
  std::vector<float> positions = std::vector<float>(3 * SINEW_MAX_RIG_JOINTS, 77);
  std::vector<int32_t> parents = std::vector<int32_t>(SINEW_MAX_RIG_JOINTS, 77), partners = parents;
  std::vector<uint8_t> flags = std::vector<uint8_t>(SINEW_MAX_RIG_JOINTS, 77), classes = flags;
  std::vector<uint16_t> confidence = std::vector<uint16_t>(SINEW_MAX_RIG_JOINTS, 77), parent_confidence = confidence;
  std::vector<char> names = std::vector<char>(size_t{SINEW_MAX_RIG_JOINTS} * SINEW_JOINT_NAME_BYTES, 'x');
  sinew_rig_outputs outputs = {};

  bool operator==(const Skeleton& o) const {
    return status == o.status && positions == o.positions && parents == o.parents && partners == o.partners &&
           flags == o.flags && classes == o.classes && confidence == o.confidence &&
           parent_confidence == o.parent_confidence && names == o.names;
  }
};

// An input as a call. Every enumeration reaches one beyond its last legal value.
struct Call : MeshInput, Hindrance {
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  bool all_outputs = true;

  explicit Call(Bytes in) {
    const uint8_t shape = in.u8(), extras = in.u8();
    const uint32_t vertices = in.below(61), faces = in.below(81);
    if ((extras & 1) != 0) {
      options.struct_size -= in.below(16) == 15 ? 4 : 0;
      options.up = in.below(5);
      options.mirror = in.below(4);
      options.spine_count = in.below(18);
      options.without = in.below(8) == 7 ? uint32_t{SINEW_WITHOUT_BIND} : in.below(2) * SINEW_WITHOUT_TOES;
      options.without |= in.below(8) == 7 ? uint32_t{SINEW_WITHOUT_NAMES} : in.below(2) * SINEW_WITHOUT_ENDS;
      options.weights_in_place = in.below(8) == 7 ? 2 : in.below(2);
      options.method = in.below(2) * in.below(4);
    }
    all_outputs = (extras & 16) == 0;
    read_hindrance(in, extras);
    options.progress = report;
    read(in, shape, vertices, faces);
    if ((shape & 64) != 0)  // flat
      for (uint32_t v = 0; v < vertices; ++v) positions[3 * v + shape % 3] = 0;
    if ((shape & 128) != 0)  // a twin on the other side of x = 0 for every other vertex
      for (uint32_t v = 0; v + 1 < vertices; v += 2) {
        std::copy_n(&positions[3 * v], 3, &positions[3 * (v + 1)]);
        positions[3 * (v + 1)] = -positions[3 * v];
      }
  }

  Skeleton run(size_t need, uint32_t kernel, uint8_t fill) {
    Skeleton s;
    options.kernel = kernel;
    options.progress_user = static_cast<Hindrance*>(this);
    reports = 0;
    const size_t bytes = given(need);
    Workspace workspace(bytes, misaligned, fill);
    s.outputs = SINEW_INIT(sinew_rig_outputs);
    s.outputs.positions = s.positions.data();
    s.outputs.parents = s.parents.data();
    s.outputs.flags = s.flags.data();
    if (all_outputs) {
      s.outputs.joint_classes = s.classes.data();
      s.outputs.partners = s.partners.data();
      s.outputs.confidence = s.confidence.data();
      s.outputs.parent_confidence = s.parent_confidence.data();
      s.outputs.names = reinterpret_cast<char(*)[SINEW_JOINT_NAME_BYTES]>(s.names.data());
    }
    const Skeleton before = s;
    s.status = sinew_rig(rig_model(), &mesh, &options, workspace.data(), bytes, &s.outputs);
    demand(workspace.guards_hold(), "the workspace is not written beyond its size");
    if (s.status == SINEW_OK) {
      demand(s.outputs.used_bytes <= bytes, "not more of the workspace is used than there is");
    } else {
      demand(s.outputs.joint_count == 0 && s.outputs.used_bytes == 0, "counts are untouched on failure");
      Skeleton after = s;
      after.status = SINEW_OK;
      demand(after == before, "outputs are untouched on failure");
    }
    return s;
  }
};

void check_status(const Call& call, sinew_status status) {
  if (call.explains(status)) return;
  if (status == SINEW_ERROR_NOT_FINITE) return demand(any_not_finite(call.positions), "NOT_FINITE is about a position");
  demand(status == SINEW_ERROR_INDEX || status == SINEW_ERROR_COUNT,
         std::string("a documented status: ") + sinew_status_text(status));
}

void check_skeleton(const Call& call, const Skeleton& s) {
  const uint32_t count = s.outputs.joint_count;
  demand(count >= 1 && count <= SINEW_MAX_RIG_JOINTS, "at least one joint, and no more than there is room for");
  demand(s.parents[0] == -1 && s.flags[0] == 0, "the root comes first and may get weight");
  demand(std::isfinite(s.outputs.plane) && std::isfinite(s.outputs.spread) && s.outputs.facing <= 3 &&
             s.outputs.mirrored <= 1,
         "what is said of the whole is in its range");
  if (call.options.mirror == SINEW_MIRROR_NEVER) demand(s.outputs.mirrored == 0, "not mirrored where that is unwanted");
  std::set<std::string> names;
  for (uint32_t j = 0; j < count; ++j) {
    const int32_t parent = s.parents[j];
    demand(j == 0 || (parent >= 0 && parent < static_cast<int32_t>(j)), "parents come before their children");
    for (uint32_t axis = 0; axis < 3; ++axis) demand(std::isfinite(s.positions[3 * j + axis]), "places are finite");
    demand(s.flags[j] == 0 || (s.flags[j] == SINEW_JOINT_NEVER && (call.options.without & SINEW_WITHOUT_ENDS) == 0),
           "a joint, or a bone end where those are wanted");
    if (!call.all_outputs) continue;
    demand(s.classes[j] <= SINEW_CLASS_OTHER, "a class that is known");
    demand(s.classes[j] != SINEW_CLASS_TOE || (call.options.without & SINEW_WITHOUT_TOES) == 0,
           "no toes where those are unwanted");
    demand(s.confidence[j] <= 32768 && s.parent_confidence[j] <= 32768, "confidences are shares");
    const char* const name = &s.names[size_t{j} * SINEW_JOINT_NAME_BYTES];
    demand(std::memchr(name, 0, SINEW_JOINT_NAME_BYTES) != nullptr && name[0] != 0, "a name that ends");
    demand(names.insert(name).second, std::string("a name once: ") + name);
    const int32_t partner = s.partners[j];
    demand(partner < 0 || s.outputs.mirrored != 0, "partners where there is a mirror");
    if (partner < 0) continue;
    demand(partner < static_cast<int32_t>(count), "a partner that exists");
    const size_t p = static_cast<size_t>(partner);
    demand(s.partners[p] == static_cast<int32_t>(j), "a partner's partner is oneself");
    demand(s.classes[p] == s.classes[j] && s.flags[p] == s.flags[j], "partners are alike");
  }
}

// The skeleton grows by fingers, faces and props, whatever its joints are said to be, and keeps the joints that it has but for
// the bone ends of hands.
void check_details(const Call& call, const Skeleton& given, size_t seed) {
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.up = call.options.up;
  const sinew_mesh& mesh = call.mesh;
  Skeleton s = given;
  s.outputs.positions = s.positions.data();
  s.outputs.parents = s.parents.data();
  s.outputs.flags = s.flags.data();
  s.outputs.joint_classes = s.classes.data();
  s.outputs.partners = s.partners.data();
  s.outputs.confidence = s.confidence.data();
  s.outputs.parent_confidence = s.parent_confidence.data();
  s.outputs.names = reinterpret_cast<char(*)[SINEW_JOINT_NAME_BYTES]>(s.names.data());
  s.classes[seed % s.outputs.joint_count] = SINEW_CLASS_HEAD;
  s.classes[seed / 3 % s.outputs.joint_count] = SINEW_CLASS_HAND;
  size_t need = 0, hands = 0;
  constexpr uint32_t kShape = SINEW_DETAIL_FACE | SINEW_DETAIL_PROPS;
  demand(sinew_rig_details_workspace_size(nullptr, mesh.vertex_count, mesh.face_count, mesh.corner_count, kShape,
                                          &options, &need) == SINEW_OK &&
             sinew_rig_details_workspace_size(hands_model(), mesh.vertex_count, mesh.face_count, mesh.corner_count,
                                              SINEW_DETAIL_HANDS, &options, &hands) == SINEW_OK,
         "details have a size where a skeleton has one");
  Workspace workspace(need, 0, 0xA5), more(hands, 0, 0xA5);
  const uint32_t before = s.outputs.joint_count;
  demand(sinew_rig_details(nullptr, &mesh, kShape, &options, workspace.data(), need, &s.outputs) == SINEW_OK,
         "faces and props are found or not");
  demand(std::equal(given.parents.begin(), given.parents.begin() + before, s.parents.begin()), "joints stay");
  if (seed % 4 == 1)  // a network for every hand
    demand(sinew_rig_details(hands_model(), &mesh, SINEW_DETAIL_HANDS, &options, more.data(), hands, &s.outputs) ==
               SINEW_OK,
           "fingers are found or not");
  demand(workspace.guards_hold() && more.guards_hold(), "no workspace is written beyond its size");
  const uint32_t count = s.outputs.joint_count;
  demand(count >= before && count <= SINEW_MAX_RIG_JOINTS, "joints come, as many as there is room for");
  std::set<std::string> names;
  for (uint32_t j = 0; j < count; ++j) {
    for (uint32_t axis = 0; axis < 3; ++axis) demand(std::isfinite(s.positions[3 * j + axis]), "places are finite");
    demand(j == 0 || (s.parents[j] >= 0 && s.parents[j] < static_cast<int32_t>(j)), "parents come first");
    demand(s.partners[j] >= -1 && s.partners[j] < static_cast<int32_t>(count), "a partner that exists");
    demand(s.classes[j] <= SINEW_CLASS_PROP, "a class that is known");
    demand(names.insert(&s.names[size_t{j} * SINEW_JOINT_NAME_BYTES]).second, "a name once");
  }
}

// What comes out is a skeleton for sinew_bind().
void check_bind(const Call& call, const Skeleton& s) {
  sinew_skeleton skeleton = sinew_test::skeleton_of(s.positions.data(), s.parents.data(), s.outputs.joint_count);
  skeleton.flags = s.flags.data();
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.grid_size = 16;
  skeleton.up = call.options.up;
  size_t need = 0;
  demand(sinew_bind_workspace_size(fuzzed_model(), call.mesh.vertex_count, call.mesh.face_count, call.mesh.corner_count,
                                   skeleton.joint_count, &options, &need) == SINEW_OK,
         "the skeleton has a size for a bind");
  Binding binding;
  binding.run(fuzzed_model(), call.mesh, skeleton, options, nullptr, need, 4, 2);
  demand(binding.status == SINEW_OK, std::string("the skeleton binds: ") + sinew_status_text(binding.status));
  check_rows(binding, call.mesh, skeleton, options);
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Call call{Bytes(data, size)};
  size_t need = 1;
  const sinew_status sized = sinew_rig_workspace_size(rig_model(), call.mesh.vertex_count, call.mesh.face_count,
                                                      call.mesh.corner_count, &call.options, &need);
  if (sized != SINEW_OK) {
    demand(need == 0, "the size is 0 on failure");
    demand(sized == SINEW_ERROR_ARGUMENT || sized == SINEW_ERROR_COUNT, "a documented status of the size query");
    demand(call.run(size_t{1} << 16, SINEW_KERNEL_AUTO, 0xA5).status != SINEW_OK, "what has no size gets no skeleton");
    return 0;
  }
  const Skeleton first = call.run(need, SINEW_KERNEL_AUTO, 0xA5);
  if (first.status != SINEW_OK) {
    check_status(call, first.status);
    return 0;
  }
  check_skeleton(call, first);
  // The reference kernels take many times as long: one input of sixteen is run again with them.
  if (size % 16 == 7) demand(call.run(need, SINEW_KERNEL_REF, 0x3C) == first, "a second run gives the same");
  if (call.all_outputs) check_details(call, first, size);
  check_bind(call, first);
  return 0;
}
