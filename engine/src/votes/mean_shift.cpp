// SPDX-License-Identifier: MIT
// Seeds, steps and modes of a cloud.
#include "votes/mean_shift.hpp"

#include "core/sort.hpp"
#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kSeedPoints = 1500;
constexpr uint32_t kSteps = 200;
constexpr int32_t kStill = side_share(1) / 10;  // where a climb ends must not depend on where it began

// exp(-d^2 / (2 h^2)) in Q15 at the middle of each of 256 pieces of d^2 / (9 h^2).
struct KernelTable {
  uint16_t q15[256];
  constexpr KernelTable() : q15() {
    uint64_t value = 4257383963u;             // round(exp(-4.5 / 512) * 2^32): the first piece
    constexpr uint64_t kFalls = 4220129505u;  // round(exp(-4.5 / 256) * 2^32): from one to the next
    for (uint32_t i = 0; i < 256; ++i) {
      q15[i] = static_cast<uint16_t>((value + (1u << 16)) >> 17);
      value = (value * kFalls) >> 32;
    }
  }
};
constexpr KernelTable kKernel;

// Sums over the points around a position. Of a point: weight and kernel at most 2^15, offset below 2^17 (three
// bandwidths). With mirror images there are 2^14 of them, so a sum stays below 2^61.
struct Pull {
  int64_t mass = 0;
  Vec3l offset = {0, 0, 0};
};

class Climb {
 public:
  Climb(const Cloud& cloud, int32_t bandwidth, bool mirrored)
      : cloud_(cloud),
        mirrored_(mirrored),
        reach_(3 * bandwidth),
        reach_2_(static_cast<uint64_t>(square(reach_))),
        pieces_((uint64_t{1} << 48) / reach_2_) {}

  // From a position to its mode.
  void run(Mode* mode) const {
    for (uint32_t step = 0; step < kSteps; ++step) {
      const Pull pull = pull_at(mode->at);
      mode->density = pull.mass;
      if (pull.mass == 0) return;
      const Vec3i shift = round_div(pull.offset, pull.mass);
      mode->at = mode->at + shift;
      if (mirrored_ && mode->at.x < 0) mode->at.x = -mode->at.x;
      if (extent({shift.x, 0, 0}) + extent({0, shift.y, 0}) + extent({0, 0, shift.z}) < kStill) return;
    }
  }

 private:
  // The first point whose y is at least `y`.
  uint32_t first_at(int32_t y) const {
    uint32_t low = 0, high = cloud_.count;
    while (low < high) {
      const uint32_t middle = (low + high) / 2;
      if (cloud_.at[middle].y < y) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  // No image is nearer than the plane.
  Pull pull_at(Vec3i position) const {
    return mirrored_ && position.x < reach_ ? pull_of<true>(position) : pull_of<false>(position);
  }

  template <bool kMirrored>
  Pull pull_of(Vec3i position) const {
    const uint64_t reach_2 = reach_2_, pieces = pieces_;  // in registers
    Pull pull;
    const auto add = [&](int64_t x, int64_t y, int64_t z, uint64_t distance_2, uint32_t weight) {
      // (d^2 / 2^8) * (2^48 / reach^2) / 2^32 = 256 d^2 / reach^2, rounded down twice: at most 255. The product is
      // below 2^40.
      const int64_t share = static_cast<int64_t>(weight * uint32_t{kKernel.q15[((distance_2 >> 8) * pieces) >> 32]});
      pull.mass += share;
      pull.offset.x += share * x;
      pull.offset.y += share * y;
      pull.offset.z += share * z;
    };
    const int32_t top = position.y + reach_;
    const Vec3i* const end = cloud_.at + cloud_.count;
    const uint32_t first = first_at(position.y - reach_ + 1);
    const uint16_t* weight = cloud_.weight + first;
    for (const Vec3i* at = cloud_.at + first; at != end && at->y < top; ++at, ++weight) {
      const int64_t x = at->x - position.x, y = at->y - position.y, z = at->z - position.z;
      const uint64_t beside = static_cast<uint64_t>(y * y + z * z), near = beside + static_cast<uint64_t>(x * x);
      if (near < reach_2) add(x, y, z, near, *weight);
      if (!kMirrored) continue;
      const int64_t image_x = -at->x - position.x;
      const uint64_t image = beside + static_cast<uint64_t>(image_x * image_x);
      if (image < reach_2) add(image_x, y, z, image, *weight);
    }
    return pull;
  }

  const Cloud& cloud_;
  const bool mirrored_;
  const int32_t reach_;
  const uint64_t reach_2_;
  const uint64_t pieces_;
};

// Moves a mode to its index among those before it.
void sort_in(Mode* modes, uint32_t at) {
  const Mode mode = modes[at];
  for (; at > 0; --at) {
    const Mode& other = modes[at - 1];
    if (other.density > mode.density || (other.density == mode.density && !comes_before(mode.at, other.at))) break;
    modes[at] = other;
  }
  modes[at] = mode;
}

}  // namespace

bool Cloud::allocate(Arena& arena, uint32_t most) {
  at = arena.alloc<Vec3i>(most);
  weight = arena.alloc<uint16_t>(most);
  order = arena.alloc<uint32_t>(most);
  return arena.ok();
}

uint32_t find_modes(const Cloud& cloud, int32_t bandwidth, bool mirrored, uint32_t most, Mode* modes) {
  // By descending weight, then as in the cloud; a taken or covered point is crossed out.
  constexpr uint32_t kIndexBits = 13;
  static_assert(kMaxVotes == 1u << kIndexBits, "an index has other bits");
  uint32_t* const order = cloud.order;
  for (uint32_t i = 0; i < cloud.count; ++i) order[i] = ((32768u - cloud.weight[i]) << kIndexBits) | i;
  sort_ascending(order, cloud.count);
  uint32_t left = cloud.count < kSeedPoints ? cloud.count : kSeedPoints;
  for (uint32_t i = 0; i < left; ++i) order[i] &= kMaxVotes - 1;

  const Climb climb(cloud, bandwidth, mirrored);
  const int64_t covered = square(bandwidth * 4 / 5), same = square(bandwidth * 3 / 5);
  uint32_t count = 0;
  for (uint32_t seed = 0; seed < most && left > 0; ++seed) {
    const Vec3i start = cloud.at[order[0]];
    uint32_t kept = 0;
    for (uint32_t i = 0; i < left; ++i) {
      if (square_distance(cloud.at[order[i]], start) > covered) order[kept++] = order[i];
    }
    left = kept;
    modes[count] = {start, 0};
    climb.run(modes + count++);
  }
  for (uint32_t m = 1; m < count; ++m) sort_in(modes, m);
  uint32_t kept = 0;
  for (uint32_t m = 0; m < count; ++m) {
    bool is_new = true;
    for (uint32_t other = 0; other < kept && is_new; ++other) {
      is_new = square_distance(modes[m].at, modes[other].at) > same;
    }
    if (is_new) modes[kept++] = modes[m];
  }
  return kept;
}

}  // namespace sinew::rigging
