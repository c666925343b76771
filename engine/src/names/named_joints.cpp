// SPDX-License-Identifier: MIT
// The caller's arrays, checked: children in rows, parents first, and the names without what most of them begin with.
#include "names/named_joints.hpp"

namespace sinew::names {
namespace {

constexpr int kMostShared = 4;  // words

// Bip01_, J_Bip_, DEF-: words that at least four of five names begin with, of five or more.
int shared_words(const sinew_skeleton& joints, uint32_t* shared) {
  if (joints.joint_count < 5 || joints.names == nullptr) return 0;
  int count = 0;
  const auto begins_so = [&](const Tokens& tokens, int words) {
    if (tokens.count <= words) return false;
    for (int k = 0; k < words; ++k) {
      if (hash_of(tokens.token[k]) != shared[k]) return false;
    }
    return true;
  };
  for (; count < kMostShared; ++count) {
    bool found = false;
    for (uint32_t first = 0; first < joints.joint_count && first < 8 && !found; ++first) {
      const Tokens tokens(joints.names[first]);
      if (tokens.count <= count + 1 || !begins_so(tokens, count)) continue;
      const Word* const word = find_word(tokens.token[count]);
      if (word != nullptr && word->part != Part::kNone) continue;  // joints of one tail
      shared[count] = hash_of(tokens.token[count]);
      uint32_t sharing = 0;
      for (uint32_t j = 0; j < joints.joint_count; ++j)
        sharing += begins_so(Tokens(joints.names[j]), count + 1) ? 1u : 0u;
      found = uint64_t{5} * sharing >= uint64_t{4} * joints.joint_count;
    }
    if (!found) break;
  }
  return count;
}

}  // namespace

bool NamedJoints::allocate(Arena& arena, uint32_t joints) {
  n = static_cast<int32_t>(joints);
  names = arena.alloc<JointName>(joints);
  kid_offsets = arena.alloc<int32_t>(size_t{joints} + 2);
  kids = arena.alloc<int32_t>(joints);
  order = arena.alloc<int32_t>(joints);
  roles = arena.alloc<uint8_t>(joints);
  classes = arena.alloc<uint8_t>(joints);
  marks = arena.alloc<uint8_t>(joints);
  return arena.ok();
}

sinew_status NamedJoints::build(const sinew_skeleton& joints, const uint8_t* followed) {
  n = static_cast<int32_t>(joints.joint_count);
  parents = joints.parents;
  positions = joints.positions;
  follows = followed;
  ends = joints.ends;
  if (positions != nullptr) {
    for (size_t i = 0; i < size_t{3} * joints.joint_count; ++i) {
      if (!(positions[i] - positions[i] == 0)) return SINEW_ERROR_NOT_FINITE;
    }
  }
  for (int32_t j = 0; j < n; ++j) {
    if (parents[j] < -1 || parents[j] >= n) return SINEW_ERROR_INDEX;
  }
  for (int32_t j = 0; j <= n + 1; ++j) kid_offsets[j] = 0;
  for (int32_t j = 0; j < n; ++j) ++kid_offsets[(parents[j] >= 0 ? parents[j] : n) + 1];
  for (int32_t j = 0; j <= n; ++j) kid_offsets[j + 1] += kid_offsets[j];
  for (int32_t j = n - 1; j >= 0; --j) kids[--kid_offsets[(parents[j] >= 0 ? parents[j] : n) + 1]] = j;
  for (int32_t j = 0; j <= n; ++j) kid_offsets[j] = kid_offsets[j + 1];
  kid_offsets[n + 1] = n;
  int32_t placed = 0;
  for (int32_t k = kid_offsets[n]; k < n; ++k) order[placed++] = kids[k];
  for (int32_t i = 0; i < placed; ++i) each_kid(*this, order[i], [&](int32_t kid) { order[placed++] = kid; });
  if (placed != n) return SINEW_ERROR_HIERARCHY;  // what no root reaches goes round in a circle
  uint32_t shared[kMostShared];
  const int shared_count = shared_words(joints, shared);
  for (int32_t j = 0; j < n; ++j) {
    int skipped = 0;
    if (shared_count > 0) {
      const Tokens tokens(joints.names[j]);
      for (int k = 0; k < shared_count && k + 1 < tokens.count && hash_of(tokens.token[k]) == shared[k]; ++k) ++skipped;
      if (skipped < shared_count) skipped = 0;
    }
    names[j] = read_joint_name(joints.names != nullptr ? joints.names[j] : nullptr, skipped);
    roles[j] = SINEW_ROLE_DEFORMS;
    classes[j] = SINEW_CLASS_OTHER;
  }
  return SINEW_OK;
}

}  // namespace sinew::names
