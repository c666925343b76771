// SPDX-License-Identifier: MIT
// Offsets, spreads and class probabilities from a network's rows.
#include "votes/read_votes.hpp"

#include "core/vector_math.hpp"
#include "votes/rig_task.hpp"

namespace sinew::rigging {
namespace {

constexpr int32_t kOffsetUnit = kSide / (1024 * kRigOffsetScale);  // grid units of a Q10 step

// 2^x of a Q10 logarithm in [kRigLeastSpread, 0], Q16.
uint16_t spread_of(int16_t log2_q10) {
  const int32_t x = clamp32(log2_q10, kRigLeastSpread * 1024, 0);
  const int64_t value = exp2_negative(-int64_t{x} * 64) >> 14;
  return static_cast<uint16_t>(value > 0xFFFF ? 0xFFFF : value);
}

// Probabilities in Q15, which sum to 2^15 but for what is rounded down.
void probabilities(const int16_t* logits, uint32_t count, uint16_t* out) {
  int16_t most = logits[0];
  for (uint32_t c = 1; c < count; ++c) most = logits[c] > most ? logits[c] : most;
  int64_t powers[kEndClasses], sum = 0;
  for (uint32_t c = 0; c < count; ++c) {
    powers[c] = exp2_negative((int64_t{most} - logits[c]) * 64);
    sum += powers[c];
  }
  for (uint32_t c = 0; c < count; ++c) out[c] = static_cast<uint16_t>((powers[c] << 15) / sum);
}

}  // namespace

bool VoteStore::allocate(Arena& arena, uint32_t sets) {
  const size_t points = size_t{sets} * kSetPoints;
  start_ = arena.alloc<Vec3i>(points);
  end_ = arena.alloc<Vec3i>(points);
  inside_ = arena.alloc<Vec3i>(points);
  start_spread_ = arena.alloc<uint16_t>(points);
  end_spread_ = arena.alloc<uint16_t>(points);
  start_class_ = arena.alloc<uint16_t>(points * kJointClasses);
  end_class_ = arena.alloc<uint16_t>(points * kEndClasses);
  return arena.ok();
}

void VoteStore::add(const PointSet& set, const int16_t* rows, bool folded, BodyKind kind) {
  for (uint32_t i = 0; i < kSetPoints; ++i, ++points_) {
    const int16_t* const row = rows + size_t{i} * kRigOutputs;
    const int32_t sign = PointSet::on_left(set.points[i]) ? 1 : -1;
    // Rows are folded; so is what is voted for where both sides are one.
    const auto voted = [&](uint32_t channel) {
      const Vec3i m = set.medial[i];
      const Vec3i at = {sign * m.x + row[channel] * kOffsetUnit, m.y + row[channel + 1] * kOffsetUnit,
                        m.z + row[channel + 2] * kOffsetUnit};
      return folded ? at : Vec3i{sign * at.x, at.y, at.z};
    };
    start_[points_] = voted(kRigStart);
    end_[points_] = voted(kRigEnd);
    start_spread_[points_] = spread_of(row[kRigStartSpread]);
    end_spread_[points_] = spread_of(row[kRigEndSpread]);
    probabilities(row + kRigStartClass, kJointClasses, start_class_ + size_t{points_} * kJointClasses);
    probabilities(row + kRigEndClass, kEndClasses, end_class_ + size_t{points_} * kEndClasses);
    steer_classes(kind, start_class_ + size_t{points_} * kJointClasses);
    steer_classes(kind, end_class_ + size_t{points_} * kEndClasses);
    const Vec3i p = set.points[i].position;
    inside_[points_] = set.medial[i];
    sum_ = {sum_.x + (folded ? 0 : p.x), sum_.y + p.y, sum_.z + p.z};
  }
}

Votes VoteStore::votes(bool folded) const {
  Votes votes;
  votes.points = points_;
  votes.folded = folded;
  votes.start = start_;
  votes.end = end_;
  votes.start_spread = start_spread_;
  votes.end_spread = end_spread_;
  votes.start_class = start_class_;
  votes.end_class = end_class_;
  votes.inside = inside_;
  votes.mean = round_div(sum_, points_);
  return votes;
}

}  // namespace sinew::rigging
