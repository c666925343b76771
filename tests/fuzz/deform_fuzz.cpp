// SPDX-License-Identifier: MIT
// Fuzz target: sinew_deform_create_workspace_size(), _create() and _pose() on arbitrary bound meshes and matrices. Refusals are those that
// the header documents; the rest pose comes back exactly; a second deformer and another content of the memory give the same bytes.
#include <algorithm>

#include "bind_checks.hpp"
#include "fuzz.hpp"
#include "mesh_input.hpp"
#include "sinew/published.h"

namespace {

using namespace sinew::test;

constexpr float kOne[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

struct Call : MeshInput, SkeletonInput, Hindrance {
  std::vector<uint16_t> joints, weights;
  std::vector<float> palette, rest_palette;
  sinew_skin skin = {};
  sinew_deform_options options = SINEW_INIT(sinew_deform_options);
  bool raw = false;  // positions of sixty decades, which no sum of doubles keeps

  explicit Call(Bytes in) {
    const uint8_t shape = in.u8(), extras = in.u8();
    const uint32_t vertices = in.below(41), count = in.below(7), faces = in.below(49);
    options.cell_count = 8;
    raw = (shape & (kRawJoints | kRawFloats)) != 0;
    if ((extras & 1) != 0) {
      options.struct_size -= in.below(32) == 31 ? 4 : 0;
      options.method = in.below(4);
      constexpr uint32_t kCells[] = {8, 9, 12, 16, 7, 65};
      options.cell_count = kCells[in.below(6)];
      options.round_count = in.below(6);
      options.softness = in.u16();
      options.without = in.below(8) == 7 ? uint32_t{SINEW_WITHOUT_TOES} : in.below(2) * SINEW_WITHOUT_TWIST_SPREAD;
      options.without |= in.below(2) * SINEW_WITHOUT_CONTACTS;
      options.without |= in.below(2) * SINEW_WITHOUT_SMOOTHING;
      options.body_contact = in.below(2);
      if (options.method == SINEW_DEFORM_XPBD) options.as_drawn = in.below(2);
    }
    read_hindrance(in, extras & 0x7F);  // nothing to cancel
    read_joints(in, shape, count);
    read(in, shape, vertices, faces);
    read_rows(in, vertices, count);
    for (uint32_t j = 0; j < count; ++j) {
      rest_palette.insert(rest_palette.end(), kOne, kOne + 12);
      read_matrix(in, extras);
    }
  }

  // Rows as the header wants them: falling weights that sum to 65535, or none at all.
  void read_rows(Bytes& in, uint32_t vertices, uint32_t count) {
    skin.influence_count = 1 + in.below(3);
    const uint32_t beyond = in.below(32) == 31 ? 1 : 0;
    for (uint32_t v = 0; v < vertices; ++v) {
      uint32_t left = in.below(16) == 15 ? 0 : 65535;
      for (uint32_t i = skin.influence_count; i > 0; --i) {
        joints.push_back(static_cast<uint16_t>(count + beyond == 0 ? 0 : in.below(count + beyond)));
        const uint32_t share = i == 1 ? left : std::min(left, left / 2 + in.u16() / 2);
        weights.push_back(static_cast<uint16_t>(share));
        left -= share;
      }
      const auto first = weights.end() - static_cast<std::ptrdiff_t>(skin.influence_count);
      std::sort(first, weights.end(), std::greater<>());
    }
    skin.joint_indices = joints.data();
    skin.weights = weights.data();
  }

  // Quarter and other turns with a shift, or any twelve numbers.
  void read_matrix(Bytes& in, uint8_t extras) {
    float m[12];
    std::copy_n(kOne, 12, m);
    const uint32_t axis = in.below(3), b = (axis + 1) % 3, c = (axis + 2) % 3;
    constexpr float kTurns[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0.6f, 0.8f}, {-0.8f, 0.6f}, {0.96f, -0.28f}};
    const float* const turn = kTurns[in.below(6)];
    m[4 * b + b] = m[4 * c + c] = turn[0];
    m[4 * c + b] = turn[1];
    m[4 * b + c] = -turn[1];
    m[3] = any_float(in, (extras & 8) != 0);
    if ((extras & 4) != 0)
      for (float& x : m) x = any_float(in, (extras & 8) != 0);
    palette.insert(palette.end(), m, m + 12);
  }
};

// A deformer in memory between guards.
struct Made {
  Workspace memory;
  sinew_status status;
  sinew_deformer deformer = {};

  Made(const Call& call, size_t need, uint8_t fill) : memory(call.given(need), call.misaligned, fill) {
    status = sinew_deform_create(&call.mesh, &call.skeleton, &call.skin, &call.options, memory.data(), call.given(need),
                                 &deformer);
    demand(memory.guards_hold(), "the memory is not written beyond its size");
    demand(status == SINEW_OK || deformer.memory == nullptr, "the deformer is untouched on failure");
  }
  // Positions, empty on failure.
  std::vector<float> pose(const std::vector<float>& palette, uint8_t fill, sinew_deform_outputs* outputs,
                          sinew_status* posed) {
    std::vector<float> positions(size_t{3} * deformer.vertex_count + 1, 77);
    const std::vector<float> before = positions;
    Workspace workspace(deformer.pose_bytes, 0, fill);
    *outputs = SINEW_INIT(sinew_deform_outputs);
    outputs->positions = positions.data();
    *posed = sinew_deform_pose(&deformer, palette.data(), workspace.data(), deformer.pose_bytes, outputs);
    demand(workspace.guards_hold(), "the workspace is not written beyond its size");
    demand(memory.guards_hold(), "a pose does not touch what is around the memory");
    if (*posed != SINEW_OK) {
      demand(positions == before, "outputs are untouched on failure");
      return {};
    }
    demand(positions.back() == 77, "nothing behind the last vertex is written");
    demand(outputs->corrected <= 1 && outputs->inverted_tetrahedra <= outputs->active_tetrahedra &&
               outputs->active_tetrahedra <= deformer.tetrahedron_count,
           "counts in their ranges");
    return positions;
  }
};

bool same(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

void check_status(const Call& call, sinew_status status) {
  if (call.explains(status)) return;
  if (status == SINEW_ERROR_NOT_FINITE)
    return demand(any_not_finite(call.positions) || any_not_finite(call.joint_positions),
                  "NOT_FINITE is about a position");
  demand(status == SINEW_ERROR_ARGUMENT || status == SINEW_ERROR_COUNT || status == SINEW_ERROR_INDEX ||
             status == SINEW_ERROR_HIERARCHY || status == SINEW_ERROR_RANGE,
         std::string("a documented status: ") + sinew_status_text(status));
}

void check_poses(const Call& call, Made* first, Made* second) {
  sinew_deform_outputs outputs, again;
  sinew_status posed, posed_again;
  const std::vector<float> rest = first->pose(call.rest_palette, 0x11, &outputs, &posed);
  demand(posed == SINEW_OK, "the rest pose is no failure");
  for (uint32_t i = 0; i < 3 * call.mesh.vertex_count && !call.raw; ++i)
    demand(rest[i] == call.positions[i], "the rest pose is exact");
  const std::vector<float> bent = first->pose(call.palette, 0x22, &outputs, &posed);
  const std::vector<float> same_bent = second->pose(call.palette, 0x33, &again, &posed_again);
  demand(posed == posed_again && same(bent, same_bent) && outputs.active_tetrahedra == again.active_tetrahedra,
         "a second deformer gives the same pose");
  if (posed == SINEW_ERROR_NOT_FINITE) {
    demand(std::any_of(call.palette.begin(), call.palette.end(),
                       [](float x) { return !std::isfinite(x) || std::fabs(x) > 1e15f; }),
           "NOT_FINITE is about a matrix");
    return;
  }
  demand(posed == SINEW_OK, std::string("a documented status: ") + sinew_status_text(posed));
  if (std::all_of(call.palette.begin(), call.palette.end(), [](float x) { return std::fabs(x) < 1e6f; }) &&
      std::all_of(call.positions.begin(), call.positions.end(), [](float x) { return std::fabs(x) < 1e6f; }))
    demand(!any_not_finite(bent), "poses of finite things are finite");
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const Call call{Bytes(data, size)};
  size_t need = 1;
  const sinew_status sized = sinew_deform_create_workspace_size(&call.mesh, call.skeleton.joint_count,
                                                                call.skin.influence_count, &call.options, &need);
  if (sized != SINEW_OK) {
    demand(need == 0, "the size is 0 on failure");
    const Made made(call, size_t{1} << 16, 0xA5);
    demand(made.status != SINEW_OK, "what has no size gets no deformer");
    check_status(call, sized);
    return 0;
  }
  Made first(call, need, 0xA5), second(call, need, 0x3C);
  demand(first.status == second.status, "a second deformer says the same");
  if (first.status != SINEW_OK) return check_status(call, first.status), 0;
  check_poses(call, &first, &second);
  return 0;
}
