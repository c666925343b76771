// SPDX-License-Identifier: MIT
// A bind of a Character through sinew.h alone: options in, one workspace, rows out.
#include "sinew_character/bind/bind.hpp"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>

#include "sinew/sinew.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/print.hpp"
#include "weights/influences.hpp"

namespace sinew {

namespace {

// The caller's rows for locked vertices and hints, rounded as the engine rounds.
//   joints, weights  out [V x N], rows that are not given stay as they are
void fill_given(const Character& character, const BindOptions& options, uint16_t* joints, uint16_t* weights) {
  if (character.influences.size() != character.vertices.size()) {
    throw Error(character.name + ": cannot lock vertices or take hints, the mesh has no weights");
  }
  const size_t n = options.influence_count;
  for (size_t v = 0; v < character.vertices.size(); ++v) {
    const bool locked = !options.locked.empty() && options.locked[v] != 0;
    const bool hint = !options.hints.empty() && options.hints[v] != 0;
    if (!locked && !hint) continue;
    const std::vector<Influence> row = round_influences(character.influences[v], options.influence_count);
    for (size_t i = 0; i < row.size(); ++i) {
      joints[v * n + i] = static_cast<uint16_t>(row[i].joint);
      weights[v * n + i] = static_cast<uint16_t>(std::lround(row[i].weight * 65535.0f));
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
              ": this build or processor lacks these kernels; expected one of " + runnable);
}

BindResult bind(const Character& character, const BindOptions& options) {
  check_bindable(character);
  const EngineViews views(character, options.joint_flags, options.up_axis);
  sinew_bind_options engine_options = SINEW_INIT(sinew_bind_options);
  engine_options.method = options.method;
  engine_options.influence_count = options.influence_count;
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
  engine_options.answers = options.answers.empty() ? nullptr : options.answers.data();
  engine_options.answer_count = static_cast<uint32_t>(options.answers.size());
  engine_options.question_count = options.question_count;

  BindResult result;
  result.confidence.resize(character.vertices.size());
  throw_status(character, sinew_bind_workspace_size(options.model, views.mesh.vertex_count, views.mesh.face_count,
                                                    views.mesh.corner_count, views.skeleton.joint_count,
                                                    &engine_options, &result.workspace_bytes));
  const Workspace workspace(result.workspace_bytes);
  if (workspace.size() < result.workspace_bytes) {
    throw OutOfMemory(character.name + ": no memory for a workspace of " +
                      std::to_string(result.workspace_bytes / 1000000) + " MB in one block");
  }
  const size_t n = options.influence_count;
  result.joints.resize(character.vertices.size() * n);
  result.weights.resize(result.joints.size());
  if (!options.locked.empty() || !options.hints.empty()) {
    fill_given(character, options, result.joints.data(), result.weights.data());
  }
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = result.joints.data();
  outputs.weights = result.weights.data();
  outputs.confidence = result.confidence.data();
  if (options.question_count > 0) {
    result.questions.resize(options.question_count);
    result.vertex_questions.resize(character.vertices.size());
    result.vertex_parts.resize(character.vertices.size());
    outputs.questions = result.questions.data();
    outputs.vertex_questions = result.vertex_questions.data();
    outputs.vertex_parts = result.vertex_parts.data();
  }
  const auto start = std::chrono::steady_clock::now();
  throw_status(character, sinew_bind(options.model, &views.mesh, &views.skeleton, &engine_options, workspace.data(),
                                     workspace.size(), &outputs));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.symmetric_vertices = outputs.symmetric_vertices;
  result.used_bytes = outputs.used_bytes;
  result.questions.resize(outputs.questions_written);

  result.influences.resize(character.vertices.size());
  for (size_t v = 0; v < character.vertices.size(); ++v) {
    for (size_t i = v * n; i < (v + 1) * n; ++i) {
      if (result.weights[i] == 0) continue;
      result.influences[v].push_back({result.joints[i], static_cast<float>(result.weights[i]) / 65535.0f});
    }
  }
  return result;
}

std::string bind_hash(const std::vector<std::vector<Influence>>& rows, uint32_t influence_count) {
  uint64_t hash = 1469598103934665603ull;
  const auto add = [&hash](uint32_t value) {
    for (const uint32_t byte : {value & 0xFFu, value >> 8}) hash = (hash ^ byte) * 1099511628211ull;
  };
  for (const bool weights : {false, true})
    for (const std::vector<Influence>& row : rows)
      for (uint32_t i = 0; i < influence_count; ++i) {
        if (i >= row.size())
          add(0);
        else
          add(weights ? static_cast<uint32_t>(std::lround(row[i].weight * 65535.0f)) : row[i].joint);
      }
  return print("%016llx", static_cast<unsigned long long>(hash));
}

// A row of any length as the engine would have written it.
std::vector<Influence> round_influences(const std::vector<Influence>& row, uint32_t keep) {
  double sum = 0;
  for (const Influence& i : row) sum += i.weight;
  std::vector<uint16_t> joints;
  std::vector<uint32_t> weights;
  for (const Influence& i : row) {
    joints.push_back(static_cast<uint16_t>(i.joint));
    // In steps of the result: a row that has only such steps already comes out as it is.
    weights.push_back(sum > 0 ? static_cast<uint32_t>(std::lround(i.weight / sum * 65535.0)) : 0);
  }
  std::vector<Influence> out;
  if (sum <= 0) return out;
  uint16_t kept_joints[SINEW_MAX_INFLUENCES], kept[SINEW_MAX_INFLUENCES];
  keep_largest(joints.data(), weights.data(), static_cast<uint32_t>(joints.size()), keep, 65535, kept_joints, kept);
  for (uint32_t i = 0; i < keep; ++i) {
    if (kept[i] > 0) out.push_back({kept_joints[i], static_cast<float>(kept[i]) / 65535.0f});
  }
  return out;
}

}  // namespace sinew
