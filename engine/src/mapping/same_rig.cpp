// SPDX-License-Identifier: MIT
// Joint by joint, by its whole name.
#include "mapping/same_rig.hpp"

#include "core/same_text.hpp"

namespace sinew::mapping {
namespace {

// The source's joint of that name, looked for from `first` on: rigs often have one order.
int32_t find_name(const sinew_skeleton& rig, const char* name, uint32_t first) {
  for (uint32_t k = 0; k < rig.joint_count; ++k) {
    const uint32_t j = (first + k) % rig.joint_count;
    if (rig.names[j] != nullptr && same_text(rig.names[j], name)) return static_cast<int32_t>(j);
  }
  return -1;
}

}  // namespace

bool is_same_rig(const sinew_skeleton& target, const sinew_skeleton& source, const Hierarchy& own,
                 const Hierarchy& other, int32_t* sources, int32_t* targets) {
  if (target.names == nullptr || source.names == nullptr) return false;
  for (int32_t j = 0; j < other.n; ++j) targets[j] = -1;
  int32_t same = 0, alone = 0, next = 0;
  for (int32_t k = 0; k < own.n; ++k) {  // parents first
    const int32_t i = own.order[k];
    int32_t above = own.parent[i];
    while (above >= 0 && sources[above] < 0) above = own.parent[above];
    const char* const name = target.names[i];
    sources[i] = name == nullptr || name[0] == 0 ? -1 : find_name(source, name, static_cast<uint32_t>(next));
    if (sources[i] < 0) {
      const bool may_lack = own.kid_count(i) == 0 || above < 0;
      if (!may_lack || 2 * ++alone > own.n) return false;
      continue;
    }
    const int32_t j = sources[i];
    int32_t other_above = other.parent[j];
    while (other_above >= 0 && targets[other_above] < 0) other_above = other.parent[other_above];
    if (targets[j] >= 0 || other_above != (above < 0 ? -1 : sources[above])) return false;
    targets[j] = i;
    next = j + 1 < other.n ? j + 1 : 0;
    ++same;
  }
  for (int32_t j = 0; j < other.n; ++j) {
    int32_t above = targets[j] < 0 ? other.parent[j] : -1;
    while (above >= 0 && targets[above] < 0) above = other.parent[above];
    if (above >= 0 && other.kid_count(j) > 0) return false;
  }
  return 2 * same >= own.n && 2 * same >= other.n;
}

}  // namespace sinew::mapping
