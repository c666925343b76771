// SPDX-License-Identifier: MIT
// Binds a Character through the C API alone.
#include "sinew_trainer/binder.hpp"

#include <chrono>
#include <cmath>
#include <cstdlib>

#include "engine_views.hpp"
#include "sinew/sinew.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

EngineViews::EngineViews(const Character& character, const std::vector<uint8_t>& joint_flags) : flags(joint_flags) {
  positions.reserve(character.vertices.size() * 3);
  for (const Vec3& p : character.vertices) positions.insert(positions.end(), {p.x, p.y, p.z});
  for (const Joint& joint : character.joints) {
    joint_positions.insert(joint_positions.end(), {joint.position.x, joint.position.y, joint.position.z});
    parents.push_back(joint.parent);
  }
  mesh.positions = positions.data();
  mesh.vertex_count = static_cast<uint32_t>(character.vertices.size());
  mesh.face_offsets = character.face_offsets.data();
  mesh.face_vertices = character.face_vertices.data();
  mesh.face_count = static_cast<uint32_t>(character.face_count());
  mesh.corner_count = static_cast<uint32_t>(character.face_vertices.size());
  skeleton.positions = joint_positions.data();
  skeleton.parents = parents.data();
  skeleton.flags = flags.empty() ? nullptr : flags.data();
  skeleton.joint_count = static_cast<uint32_t>(character.joints.size());
}

void check_bindable(const Character& character) {
  if (character.vertices.empty()) throw Error(character.name + ": the mesh has no vertices");
  if (character.joints.empty()) {
    throw Error(character.name + ": there is no skeleton; give one with --skeleton or use a file that has a skin");
  }
  if (character.joints.size() > SINEW_MAX_JOINTS) {
    throw Error(character.name + ": " + std::to_string(character.joints.size()) + " joints, at most " +
                std::to_string(SINEW_MAX_JOINTS) + " are supported");
  }
  if (character.vertices.size() > SINEW_MAX_VERTICES) {
    throw Error(character.name + ": " + std::to_string(character.vertices.size()) + " vertices, at most " +
                std::to_string(SINEW_MAX_VERTICES) + " are supported");
  }
}

void throw_status(const Character& character, sinew_status status) {
  if (status != SINEW_OK) throw Error(character.name + ": " + sinew_status_text(status));
}

namespace {

// The caller's rows for locked vertices and hints, rounded as the engine rounds.
void fill_given(const Character& character, const BindOptions& options, std::vector<uint16_t>* joints,
                std::vector<uint16_t>* weights) {
  if (character.influences.size() != character.vertices.size()) {
    throw Error(character.name + ": vertices are locked or hints, but the mesh has no weights of its own to keep");
  }
  const size_t n = options.influence_count;
  for (size_t v = 0; v < character.vertices.size(); ++v) {
    const bool locked = !options.locked.empty() && options.locked[v] != 0;
    const bool hint = !options.hints.empty() && options.hints[v] != 0;
    if (!locked && !hint) continue;
    const std::vector<Influence> row = round_influences(character.influences[v], options.influence_count);
    for (size_t i = 0; i < row.size(); ++i) {
      (*joints)[v * n + i] = static_cast<uint16_t>(row[i].joint);
      (*weights)[v * n + i] = static_cast<uint16_t>(std::lround(row[i].weight * 65535.0f));
    }
  }
}

}  // namespace

uint32_t kernel_from_environment() {
  const char* const wanted = std::getenv("SINEW_KERNEL");
  if (wanted == nullptr || *wanted == 0) return SINEW_KERNEL_AUTO;
  std::string runnable;
  for (uint32_t kernel = 0; sinew_kernel_name(kernel) != nullptr; ++kernel) {
    const bool runs = sinew_kernel_select(kernel) != 0;
    if (runs && std::string(wanted) == sinew_kernel_name(kernel)) return kernel;
    if (runs) runnable += (runnable.empty() ? "" : ", ") + std::string(sinew_kernel_name(kernel));
  }
  throw Error(std::string("SINEW_KERNEL=") + wanted +
              ": this build or this processor has no such kernels; expected one of " + runnable);
}

BindResult bind(const Character& character, const BindOptions& options) {
  check_bindable(character);
  const EngineViews views(character, options.joint_flags);
  sinew_options engine_options = {};
  engine_options.method = options.method;
  engine_options.influence_count = options.influence_count;
  engine_options.up_axis = options.up_axis;
  engine_options.weight_format = SINEW_WEIGHT_UNORM16;
  engine_options.locked = options.locked.empty() ? nullptr : options.locked.data();
  engine_options.hints = options.hints.empty() ? nullptr : options.hints.data();
  engine_options.symmetric = options.symmetric ? 1 : 0;
  engine_options.rigid_parts = options.rigid_parts;
  engine_options.softness_percent = options.softness_percent;
  engine_options.surface_vertices = options.surface_vertices;
  engine_options.kernel = options.kernel != SINEW_KERNEL_AUTO ? options.kernel : kernel_from_environment();
  engine_options.progress = options.progress;
  engine_options.progress_user = options.progress_user;
  engine_options.thread_count = options.thread_count;
  engine_options.parallel_for = options.parallel_for;
  engine_options.parallel_user = options.parallel_user;

  BindResult result;
  result.confidence.resize(character.vertices.size());
  engine_options.confidence = result.confidence.data();
  engine_options.symmetric_vertices = &result.symmetric_vertices;
  throw_status(character, sinew_bind_workspace_size(options.model, views.mesh.vertex_count, views.mesh.face_count,
                                                    views.mesh.corner_count, views.skeleton.joint_count,
                                                    &engine_options, &result.workspace_bytes));
  const Workspace workspace(result.workspace_bytes);
  if (workspace.size() < result.workspace_bytes) {
    throw Error(character.name + ": no memory for a workspace of " + std::to_string(result.workspace_bytes) + " bytes");
  }
  const size_t n = options.influence_count;
  std::vector<uint16_t> joints(character.vertices.size() * n), weights(character.vertices.size() * n);
  if (!options.locked.empty() || !options.hints.empty()) fill_given(character, options, &joints, &weights);
  const auto start = std::chrono::steady_clock::now();
  throw_status(character, sinew_bind(options.model, &views.mesh, &views.skeleton, &engine_options, workspace.data(),
                                     workspace.size(), joints.data(), weights.data(), &result.used_bytes));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  result.influences.resize(character.vertices.size());
  for (size_t v = 0; v < character.vertices.size(); ++v) {
    for (size_t i = v * n; i < (v + 1) * n; ++i) {
      if (weights[i] > 0) result.influences[v].push_back({joints[i], static_cast<float>(weights[i]) / 65535.0f});
    }
  }
  return result;
}

}  // namespace sinew
