// SPDX-License-Identifier: MIT
// One call of sinew_bind() with everything around it watched: a workspace of exactly the promised size between guards
// (and sanitizers behind them), outputs that must stay as they are on failure, and the rules that rows obey.
#ifndef SINEW_TESTS_FUZZ_BIND_CHECKS_HPP
#define SINEW_TESTS_FUZZ_BIND_CHECKS_HPP

#include <string>

#include "fuzz.hpp"
#include "sinew/sinew.h"
#include "with_asan.hpp"

#ifdef SINEW_WITH_ASAN
#include <sanitizer/asan_interface.h>
#define SINEW_FORBID(first, size) __asan_poison_memory_region(first, static_cast<size_t>(size))
#define SINEW_ALLOW(first, size) __asan_unpoison_memory_region(first, static_cast<size_t>(size))
#else
#define SINEW_FORBID(first, size) static_cast<void>(first)
#define SINEW_ALLOW(first, size) static_cast<void>(first)
#endif

namespace sinew::test {

// A block of exactly `size` bytes at a multiple of 64 (plus `offset`) between guards: AddressSanitizer stops at the
// first access to them, other builds see afterwards whether they were written.
class Workspace {
 public:
  Workspace(size_t size, size_t offset, uint8_t fill) : size_(size), fill_(fill) {
    bytes_.assign(size + offset + 2 * kGuard + 64, fill);
    const uintptr_t first = reinterpret_cast<uintptr_t>(bytes_.data()) + kGuard;
    begin_ = bytes_.data() + kGuard + (64 - first % 64) % 64 + offset;
    SINEW_FORBID(bytes_.data(), begin_ - bytes_.data());
    SINEW_FORBID(begin_ + size, bytes_.data() + bytes_.size() - (begin_ + size));
  }
  ~Workspace() { SINEW_ALLOW(bytes_.data(), bytes_.size()); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  void* data() { return begin_; }
  // Nothing in front of or behind the block was written.
  bool guards_hold() const {
    SINEW_ALLOW(bytes_.data(), bytes_.size());
    for (const uint8_t* p = bytes_.data(); p < begin_; ++p)
      if (*p != fill_) return false;
    for (const uint8_t* p = begin_ + size_; p < bytes_.data() + bytes_.size(); ++p)
      if (*p != fill_) return false;
    return true;
  }

 private:
  static constexpr size_t kGuard = 256;
  size_t size_;
  uint8_t fill_;
  std::vector<uint8_t> bytes_;
  uint8_t* begin_ = nullptr;
};

struct Binding {
  std::vector<uint16_t> joints;
  std::vector<uint8_t> weights;  // bytes of the format's elements
  sinew_status status = SINEW_OK;
  size_t used = 0;
  uint32_t symmetric_vertices = 0;
  uint8_t fill = 0xA5;  // what the workspace holds before
  size_t misaligned = 0;

  // Outputs not filled before are filled here. `confidence` may be null, `influences` is N with its default.
  void run(const sinew_model* model, const sinew_mesh& mesh, const sinew_skeleton& skeleton,
           const sinew_bind_options& options, uint8_t* confidence, size_t workspace_bytes, uint32_t influences,
           size_t weight_size) {
    const size_t slots = size_t{mesh.vertex_count} * influences;
    joints.resize(slots, 0xBEEF);
    weights.resize(slots * weight_size, 0xDB);
    const std::vector<uint16_t> joints_before = joints;
    const std::vector<uint8_t> weights_before = weights;
    Workspace workspace(workspace_bytes, misaligned, fill);
    // Floats are wanted aligned; the vector's memory is.
    sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
    outputs.joint_indices = joints.data();
    outputs.weights = weights.data();
    outputs.confidence = confidence;
    status = sinew_bind(model, &mesh, &skeleton, &options, workspace.data(), workspace_bytes, &outputs);
    used = outputs.used_bytes;
    symmetric_vertices = outputs.symmetric_vertices;
    demand(workspace.guards_hold(), "the workspace is not written beyond its size");
    demand(status <= SINEW_OK && status >= SINEW_ERROR_VERSION, "a status that is documented");
    demand(std::strchr(sinew_status_text(status), '\n') == nullptr, "a status is one line");
    if (status == SINEW_OK) {
      demand(used <= workspace_bytes, "not more of the workspace is used than there is");
    } else {
      demand(joints == joints_before && weights == weights_before && used == 0 && symmetric_vertices == 0,
             "outputs are untouched on failure");
    }
  }
};

// Weight of one slot, 0..65535 (unorm8: 0..255).
inline uint32_t weight_at(const Binding& b, uint32_t format, size_t slot) {
  if (format == SINEW_WEIGHT_UNORM8) return b.weights[slot];
  if (format == SINEW_WEIGHT_UNORM16) {
    uint16_t value;
    std::memcpy(&value, &b.weights[slot * 2], 2);
    return value;
  }
  float value;
  std::memcpy(&value, &b.weights[slot * 4], 4);
  demand(value >= 0 && value <= 1, "float weights are 0..1");
  const uint32_t whole = static_cast<uint32_t>(value * 65535.0f + 0.5f);
  demand(static_cast<float>(whole) / 65535.0f == value, "float weights are whole 65535ths");
  return whole;
}

// Exact sums, falling weights, joints that exist and may be used; given rows are the caller's own business.
inline void check_rows(const Binding& b, const sinew_mesh& mesh, const sinew_skeleton& skeleton,
                       const sinew_bind_options& options) {
  const uint32_t n = options.influence_count == 0 ? 4 : options.influence_count;
  const uint32_t total = options.weight_format == SINEW_WEIGHT_UNORM8 ? 255 : 65535;
  bool some_deform = false;
  for (uint32_t j = 0; skeleton.flags != nullptr && j < skeleton.joint_count; ++j)
    some_deform = some_deform || (skeleton.flags[j] & SINEW_JOINT_DEFORMS) != 0;
  // A painted row may use any joint and lend it to its surroundings.
  const bool painted = options.hints != nullptr || (options.symmetric != 0 && options.locked != nullptr);
  const auto usable = [&](uint32_t joint) {
    if (skeleton.flags == nullptr || painted) return true;
    const uint8_t flags = skeleton.flags[joint];
    return (flags & SINEW_JOINT_NEVER) == 0 && (!some_deform || (flags & SINEW_JOINT_DEFORMS) != 0);
  };
  for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
    if ((options.locked != nullptr && options.locked[v] != 0) || (options.hints != nullptr && options.hints[v] != 0))
      continue;
    uint32_t sum = 0, last = total + 1, last_joint = 0;
    for (uint32_t i = 0; i < n; ++i) {
      const size_t slot = size_t{v} * n + i;
      const uint32_t joint = b.joints[slot], weight = weight_at(b, options.weight_format, slot);
      sum += weight;
      demand(joint < skeleton.joint_count, "joint indices are in range");
      if (weight == 0) {
        demand(joint == 0, "unused slots are joint 0");
      } else {
        demand(usable(joint), "no weight for a joint that must get none");
        demand(weight < last || (weight == last && joint > last_joint), "falling weights, ties by lower joint");
        for (uint32_t k = 0; k < i; ++k) demand(b.joints[slot - i + k] != joint, "no joint twice in a row");
      }
      demand(weight <= last, "used slots come first");
      last = weight;
      last_joint = joint;
    }
    demand(sum == total, "weights sum exactly, not to " + std::to_string(sum));
  }
}

}  // namespace sinew::test
#endif
