// SPDX-License-Identifier: MIT
// Fuzz target: the size query and sinew_bind() on arbitrary meshes, skeletons and options, with the bundled model and
// without one. Refusals are those that the header documents; rows obey its rules; a second run with another kernel and
// another content of the workspace gives the same bytes.
#include "bind_checks.hpp"
#include "fuzz.hpp"
#include "mesh_input.hpp"

namespace {

using namespace sinew::test;

// An input as a call. Every enumeration reaches one beyond its last legal value.
struct Call : MeshInput, SkeletonInput, Hindrance {
  std::vector<uint8_t> locked, hints, confidence, given_weights;
  std::vector<uint16_t> given_joints;
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  uint32_t influences = 4;
  bool wants_confidence = false;
  size_t weight_size = 2;
  uint32_t up = SINEW_UP_AUTO;

  explicit Call(Bytes in) {
    const uint8_t shape = in.u8(), extras = in.u8();
    const uint32_t vertices = in.below(41), joints = in.below(11), faces = in.below(49);
    read_options(in, extras, vertices);
    read_joints(in, shape, joints);
    read(in, shape, vertices, faces);
    skeleton.up = up;
    skeleton.flags = (shape & 64) != 0 ? flags.data() : nullptr;
    for (size_t i = 0; i < size_t{vertices} * influences; ++i) {
      given_joints.push_back(static_cast<uint16_t>(in.below(joints + ((shape & 128) != 0 ? 1 : 0) + (joints == 0))));
      for (size_t b = 0; b < weight_size; ++b) given_weights.push_back(in.u8());
    }
  }

  void read_options(Bytes& in, uint8_t extras, uint32_t vertices) {
    sinew_bind_options& o = options;
    if ((extras & 1) != 0) {
      o.struct_size -= in.below(16) == 15 ? 4 : 0;
      o.influence_count = in.below(14);
      o.candidate_count = in.below(18);
      constexpr uint32_t kGrids[] = {16, 17, 20, 24, 15, 129, 16, 0};  // finer ones cost time and show nothing new
      o.grid_size = kGrids[in.below(7)];
      up = in.below(8) == 7 ? in.below(6) : 2 + in.below(2);
      o.weight_format = in.below(4);
      o.symmetric = in.below(8) == 7 ? 2 : in.below(2);
      o.rigid_parts = in.below(4);
      constexpr uint32_t kSoftness[] = {0, 25, 100, 250, 400, 24, 401};
      o.softness_percent = kSoftness[in.below(7)];
      o.weights_in_place = in.below(2);
      o.surface_vertices = in.below(2) == 0 ? 0 : 15 + in.below(12);
    } else {
      o.grid_size = 16;
    }
    o.method = (extras & 2) != 0 ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
    influences = o.influence_count == 0 ? 4 : o.influence_count;
    weight_size = o.weight_format == SINEW_WEIGHT_UNORM8 ? 1 : o.weight_format == SINEW_WEIGHT_FLOAT ? 4 : 2;
    confidence.assign(vertices, 77);
    for (uint32_t v = 0; v < vertices; ++v) {
      locked.push_back((extras & 4) != 0 ? in.u8() & 1 : 0);
      hints.push_back((extras & 8) != 0 ? in.u8() & 1 : 0);
    }
    if ((extras & 4) != 0) o.locked = locked.data();
    if ((extras & 8) != 0) o.hints = hints.data();
    wants_confidence = (extras & 16) != 0;
    read_hindrance(in, extras);
    o.progress = report;
  }

  // `need` is that of the thread count.
  Binding run(size_t need, uint32_t kernel, uint8_t fill, uint32_t threads) {
    Binding binding;
    binding.joints = given_joints;
    binding.weights = given_weights;
    binding.fill = fill;
    binding.misaligned = misaligned;
    options.kernel = kernel;
    options.thread_count = threads;
    // The order that is least like one thread's.
    options.parallel_for = [](void*, uint32_t count, void (*body)(void*, uint32_t), void* data) {
      while (count > 0) body(data, --count);
    };
    options.progress_user = static_cast<Hindrance*>(this);
    reports = 0;
    binding.run(fuzzed_model(), mesh, skeleton, options, wants_confidence ? confidence.data() : nullptr, given(need),
                influences, weight_size);
    return binding;
  }
};

void check_status(const Call& call, const Binding& binding) {
  if (call.explains(binding.status)) return;
  switch (binding.status) {
    case SINEW_ERROR_RANGE:
      demand(call.options.locked != nullptr || call.options.hints != nullptr, "RANGE is about given rows");
      break;
    case SINEW_ERROR_NO_JOINT:
      demand(call.skeleton.flags != nullptr, "without flags every joint is usable");
      break;
    default:
      demand(binding.status >= SINEW_ERROR_NO_JOINT && binding.status != SINEW_ERROR_ARGUMENT,
             std::string("a documented status: ") + sinew_status_text(binding.status));
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Call call{Bytes(data, size)};
  const auto measure = [&](uint32_t threads, size_t* bytes) {
    *bytes = 1;
    call.options.thread_count = threads;
    return sinew_bind_workspace_size(fuzzed_model(), call.mesh.vertex_count, call.mesh.face_count,
                                     call.mesh.corner_count, call.skeleton.joint_count, &call.options, bytes);
  };
  size_t need = 0, second_need = 0;
  const sinew_status sized = measure(0, &need);
  if (sized != SINEW_OK) {
    demand(need == 0, "the size is 0 on failure");
    demand(sized == SINEW_ERROR_ARGUMENT || sized == SINEW_ERROR_COUNT, "a documented status of the size query");
    const Binding binding = call.run(size_t{1} << 16, SINEW_KERNEL_AUTO, 0xA5, 0);
    demand(binding.status != SINEW_OK, "what has no size cannot be bound");
    return 0;
  }
  // Where progress stops and what a missing byte hits depend on the number of pieces.
  const uint32_t threads = call.cancel_at != 0 || call.short_by != 0 ? 1 : 1 + static_cast<uint32_t>(size % 5);
  demand(measure(threads, &second_need) == SINEW_OK && second_need >= need,
         "more threads have a size, and no smaller one");
  const Binding first = call.run(need, SINEW_KERNEL_REF, 0xA5, 0);
  const std::vector<uint8_t> confidence = call.confidence;
  const Binding second = call.run(second_need, SINEW_KERNEL_AUTO, 0x3C, threads);
  if (call.short_by == 0) demand(first.status == second.status, "a second run says the same");
  if (first.status != SINEW_OK) {
    check_status(call, first);
    return 0;
  }
  check_rows(first, call.mesh, call.skeleton, call.options);
  if (second.status != SINEW_OK) return check_status(call, second), 0;  // kernels differ in what is short for them
  demand(first.joints == second.joints && first.weights == second.weights, "a second run gives the same bytes");
  demand(first.symmetric_vertices == second.symmetric_vertices && confidence == call.confidence,
         "a second run says the same besides");
  return 0;
}
