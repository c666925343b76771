// SPDX-License-Identifier: MIT
// A transfer between two Characters: options in, one workspace, rows out.
#include "sinew_character/bind/transfer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "sinew/published.h"
#include "sinew/sinew.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/bind/seams.hpp"
#include "sinew_formats/error.hpp"
#include "text/joint_names.hpp"

namespace sinew {

// Maps of joints by equal names.
JointMapping map_joints_by_name(const std::vector<Joint>& source, const std::vector<Joint>& target) {
  const std::map<std::string, uint32_t> numbers = joints_by_name(target);
  const std::vector<std::string> written = names_without_blanks(source);
  JointMapping mapping(source.size(), -1);
  for (size_t j = 0; j < source.size(); ++j) {
    auto found = numbers.find(source[j].name);
    if (found == numbers.end()) found = numbers.find(written[j]);
    if (found != numbers.end()) mapping[j] = static_cast<int32_t>(found->second);
  }
  return mapping;
}

size_t mapped_count(const JointMapping& mapping) {
  return static_cast<size_t>(std::count_if(mapping.begin(), mapping.end(), [](int32_t to) { return to >= 0; }));
}

namespace {

constexpr double kQ16 = 1.0 / 65536;

// Rows of a character as the engine takes them.
struct EngineRows {
  std::vector<uint16_t> joints, weights;  // [V x count], unorm16
  uint32_t count = 1;

  EngineRows(const std::vector<std::vector<Influence>>& rows, size_t vertices, uint32_t slots) : count(slots) {
    joints.resize(vertices * count);
    weights.resize(vertices * count);
    for (size_t v = 0; v < rows.size(); ++v) {
      const std::vector<Influence> row = round_influences(rows[v], count);
      for (size_t i = 0; i < row.size(); ++i) {
        joints[v * count + i] = static_cast<uint16_t>(row[i].joint);
        weights[v * count + i] = static_cast<uint16_t>(std::lround(row[i].weight * 65535.0f));
      }
    }
  }
};

uint32_t longest_row(const std::vector<std::vector<Influence>>& rows) {
  size_t longest = 1;
  for (const auto& row : rows) longest = std::max(longest, row.size());
  return static_cast<uint32_t>(std::min<size_t>(longest, SINEW_MAX_INFLUENCES));
}

// Gives the weight of ends of chains to the joints that take it; sorted as the engine sorts.
void fold_row(const std::vector<uint32_t>& takes, std::vector<Influence>* row) {
  const auto folds = [&](const Influence& influence) { return takes[influence.joint] != influence.joint; };
  if (std::none_of(row->begin(), row->end(), folds)) return;
  std::vector<Influence> folded;
  for (const Influence& influence : *row) {
    const uint32_t joint = takes[influence.joint];
    const auto at =
        std::find_if(folded.begin(), folded.end(), [joint](const Influence& one) { return one.joint == joint; });
    if (at == folded.end())
      folded.push_back({joint, influence.weight});
    else
      at->weight += influence.weight;
  }
  std::sort(folded.begin(), folded.end(), [](const Influence& a, const Influence& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
  *row = std::move(folded);
}

// A status that only a transfer has a reason for.
[[noreturn]] void throw_transfer(const Character& source, const Character& target, const TransferOptions& options,
                                 sinew_status status) {
  if (status == SINEW_ERROR_RANGE && options.method == SINEW_TRANSFER_BIHARMONIC)
    throw Error(target.name +
                ": found fewer than four positions that match on both meshes; give at least four pairs of vertices");
  if (status == SINEW_ERROR_RANGE)
    throw Error(source.name + ": no joint with weights maps to a joint of " + target.name);
  if (status == SINEW_ERROR_COUNT && options.method == SINEW_TRANSFER_BIHARMONIC)
    throw Error(target.name + " or " + source.name +
                ": too large or too tangled for biharmonic distances; expected at most " +
                std::to_string(SINEW_MAX_BIHARMONIC_VERTICES) + " vertices");
  throw Error(source.name + " to " + target.name + ": " + sinew_status_text(status));
}

}  // namespace

TransferJoints choose_transfer_joints(const Character& source, const Character& target, const JointMapping& mapping) {
  const JointChoice choice = choose_joints(target, JointsFrom::kNames);
  TransferJoints joints;
  joints.flags = choice.flags;
  std::vector<uint8_t> moves(source.joints.size(), 0), deforms(target.joints.size(), 0);
  for (const auto& row : source.influences)
    for (const Influence& influence : row)
      if (influence.weight > 0) moves[influence.joint] = 1;
  for (size_t j = 0; j < mapping.size(); ++j)
    if (mapping[j] >= 0) deforms[static_cast<size_t>(mapping[j])] |= moves[j];
  for (size_t j = 0; j < deforms.size(); ++j) {
    joints.target_of.push_back(static_cast<uint32_t>(j));
    if (deforms[j] != 0) joints.flags[j] = 0;
  }
  for (const size_t tip : choice.tips) {
    const int parent = target.joints[tip].parent;
    if (deforms[tip] == 0 && parent >= 0 && (joints.flags[static_cast<size_t>(parent)] & SINEW_JOINT_NEVER) == 0)
      joints.target_of[tip] = static_cast<uint32_t>(parent);
  }
  return joints;
}

TransferResult transfer(const Character& source, const Character& target, const JointMapping& mapping,
                        const TransferOptions& options) {
  check_bindable(source);
  check_bindable(target);
  const EngineViews from(source, {}, options.source_up_axis);
  const TransferJoints joints = choose_transfer_joints(source, target, mapping);
  const EngineViews to(target, joints.flags, options.up_axis);
  const EngineRows rows(source.influences, source.vertices.size(), longest_row(source.influences));
  const sinew_bound_character bound = {&from.mesh,
                                       &from.skeleton,
                                       {rows.joints.data(), rows.weights.data(), rows.count, SINEW_WEIGHT_UNORM16},
                                       mapping.data()};
  TransferSettings engine_options;
  engine_options.method = options.method;
  engine_options.influence_count = options.influence_count;
  engine_options.garment = options.garment ? 1 : 0;
  engine_options.as_drawn = options.as_drawn ? 1 : 0;
  engine_options.locked = options.locked.empty() ? nullptr : options.locked.data();
  engine_options.pairs = options.pairs.empty() ? nullptr : options.pairs.data();
  engine_options.pair_count = static_cast<uint32_t>(options.pairs.size());
  engine_options.kernel = options.kernel != SINEW_KERNEL_AUTO ? options.kernel : kernel_from_environment();
  engine_options.progress = options.progress;
  engine_options.progress_user = options.progress_user;
  engine_options.thread_count = options.thread_count;
  engine_options.parallel_for = options.parallel_for;
  engine_options.parallel_user = options.parallel_user;

  TransferResult result;
  sinew_status status = sinew_transfer_workspace_size(options.model, &bound, &to.mesh, &to.skeleton, &engine_options,
                                                      &result.workspace_bytes);
  if (status != SINEW_OK) throw_transfer(source, target, options, status);
  Workspace workspace(result.workspace_bytes);
  if (workspace.size() < result.workspace_bytes)
    throw OutOfMemory(target.name + ": no memory for a workspace of " +
                      std::to_string(result.workspace_bytes / 1000000) + " MB in one block");
  const size_t n = options.influence_count, vertices = target.vertices.size();
  Skin<uint16_t> out;
  if (!options.locked.empty()) {
    const EngineRows own(target.influences, vertices, options.influence_count);
    out = {own.count, own.joints, own.weights, 0};
  }
  TransferReport report;
  const auto start = std::chrono::steady_clock::now();
  status = sinew::transfer(options.model, bound, to.mesh, to.skeleton, engine_options, &workspace, &out, &report);
  if (status != SINEW_OK) throw_transfer(source, target, options, status);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.confidence = std::move(report.confidence);
  result.vertex_parts = std::move(report.vertex_parts);
  result.parts = std::move(report.parts);
  result.bound = report.bound_by <= SINEW_METHOD_HEAT;
  result.bound_by = result.bound ? static_cast<sinew_method>(report.bound_by) : SINEW_METHOD_MODEL;
  result.carried = kQ16 * report.carried_q16;
  result.style = kQ16 * report.style_q16;
  result.mismatch = kQ16 * report.mismatch_q16;
  result.reference_count = report.reference_count;
  result.used_bytes = report.used_bytes;
  result.influences.resize(vertices);
  for (size_t v = 0; v < vertices; ++v) {
    for (size_t i = v * n; i < (v + 1) * n; ++i)
      if (out.weights[i] != 0)
        result.influences[v].push_back({out.joint_indices[i], static_cast<float>(out.weights[i]) / 65535.0f});
    if (options.locked.empty() || options.locked[v] == 0) fold_row(joints.target_of, &result.influences[v]);
  }
  (void)keep_apart(target, find_seams(target, result.influences), options.locked, &result.influences);
  return result;
}

}  // namespace sinew
