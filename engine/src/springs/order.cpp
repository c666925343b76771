// SPDX-License-Identifier: MIT
// Which joints a step has to move, and in which order.
#include "springs/springs.hpp"

namespace sinew::springs {
namespace {

constexpr uint32_t kMostRounds = 64;  // of waiting for colliders; what waits for one another then goes on without

void need(const SpringState& s, int32_t joint, uint8_t* needed) {
  for (int32_t at = joint; at >= 0 && needed[at] == 0; at = s.parents[at]) needed[at] = 1;
}

// Whether all that a chain is pushed by has been moved.
bool is_free(const SpringState& s, const SpringHead& head, const uint8_t* done) {
  const SpringChain& chain = s.chains[head.chain];
  if (chain.center >= 0 && done[chain.center] == 0 && chain.center != static_cast<int32_t>(head.joint)) return false;
  for (uint32_t i = 0; i < chain.collider_count; ++i)
    if (done[s.colliders[s.chain_colliders[chain.first_collider + i]].joint] == 0) return false;
  return true;
}

}  // namespace

void sort_joints(SpringState* s, uint8_t* needed, uint8_t* done) {
  const uint32_t joints = s->counts.skeleton_joints;
  for (uint32_t j = 0; j < joints; ++j) needed[j] = done[j] = 0;
  for (uint32_t h = 0; h < s->head_count; ++h) {
    need(*s, static_cast<int32_t>(s->heads[h].tail), needed);  // with all joints up to its head: their pose is read
    const SpringChain& chain = s->chains[s->heads[h].chain];
    need(*s, chain.center, needed);
    for (uint32_t i = 0; i < chain.collider_count; ++i)
      need(*s, static_cast<int32_t>(s->colliders[s->chain_colliders[chain.first_collider + i]].joint), needed);
  }
  s->order_count = 0;
  for (uint32_t round = 0;; ++round) {
    bool waiting = false, moved = false;
    for (uint32_t j = 0; j < joints; ++j) {
      if (needed[j] == 0 || done[j] != 0) continue;
      const int32_t parent = s->parents[j], head = s->heads_of[j];
      if ((parent >= 0 && done[parent] == 0) ||
          (round < kMostRounds && head >= 0 && !is_free(*s, s->heads[head], done))) {
        waiting = true;
        continue;
      }
      done[j] = 1;
      moved = true;
      s->order[s->order_count++] = j;
    }
    if (!waiting) return;
    if (!moved && round < kMostRounds) round = kMostRounds;  // colliders in a circle
  }
}

}  // namespace sinew::springs
