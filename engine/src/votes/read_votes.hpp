// SPDX-License-Identifier: MIT
// A network's rows become votes.
#ifndef SINEW_VOTES_READ_VOTES_HPP
#define SINEW_VOTES_READ_VOTES_HPP

#include "core/arena.hpp"
#include "front/mirror_frame.hpp"
#include "votes/body_kind.hpp"
#include "votes/rig_points.hpp"
#include "votes/votes.hpp"

namespace sinew::rigging {

// Votes with room for `sets` sets, set by set.
class VoteStore {
 public:
  bool allocate(Arena& arena, uint32_t sets);
  // Adds the votes of a set, with the classes of that kind of body. rows: [kSetPoints x kRigOutputs], as rig_task.hpp says.
  void add(const PointSet& set, const int16_t* rows, bool folded, BodyKind kind = BodyKind::kAny);
  // All that was added.
  Votes votes(bool folded) const;

 private:
  uint32_t points_ = 0;
  Vec3l sum_ = {0, 0, 0};
  Vec3i *start_ = nullptr, *end_ = nullptr;
  Vec3i* inside_ = nullptr;
  uint16_t *start_spread_ = nullptr, *end_spread_ = nullptr, *start_class_ = nullptr, *end_class_ = nullptr;
};

}  // namespace sinew::rigging
#endif
