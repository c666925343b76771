// SPDX-License-Identifier: MIT
// Where weighted points gather: the modes of a density, by mean shift (Comaniciu and Meer 2002) in integers.
#ifndef SINEW_VOTES_MEAN_SHIFT_HPP
#define SINEW_VOTES_MEAN_SHIFT_HPP

#include "core/arena.hpp"
#include "grid/grid_quantizer.hpp"
#include "votes/votes.hpp"

namespace sinew::rigging {

// Share n / 10,000 of the mesh's longest side, grid units.
constexpr int32_t side_share(int64_t n) { return static_cast<int32_t>((n * kSide + 5000) / 10000); }
constexpr int64_t square(int64_t v) { return v * v; }
// At most 3 * 2^50 for coordinates below 2^24 in size.
inline int64_t square_distance(Vec3i a, Vec3i b) { return dot(a - b, a - b); }

constexpr uint32_t kMaxVotes = 2 * kMaxRigPoints;  // both ends of every point's bone
constexpr uint32_t kMaxModes = 48;

// Points by rising y, then x, then z, so that what depends on their order does not depend on the caller's.
struct Cloud {
  uint32_t count = 0;
  Vec3i* at = nullptr;         // [most] grid units, below 2^24 in size
  uint16_t* weight = nullptr;  // [most] Q15, at most 2^15
  uint32_t* order = nullptr;   // [most] scratch

  bool allocate(Arena& arena, uint32_t most);  // most <= kMaxVotes
  void clear() { count = 0; }
  void add(Vec3i p, uint32_t weight_q15) {
    at[count] = p;
    weight[count++] = static_cast<uint16_t>(weight_q15);
  }
};

struct Mode {
  Vec3i at;
  int64_t density;  // kernel times weight, summed: Q30
};

// Climbs the density of a cloud from at most `most` <= kMaxModes seeds: the heaviest point, then the heaviest further
// than 0.8 bandwidths from all seeds, among the 1,500 heaviest. The kernel is a Gaussian that ends at three bandwidths;
// 200 steps, or until one is below 1e-5 of the side.
//   cloud      in   order is overwritten
//   bandwidth  in   up to 31,457 grid units (0.03 of the side)
//   mirrored   in   the mirror images at -x count as well; no x of the cloud is negative, nor of the modes
//   modes      out  [kMaxModes] by falling density, then rising y, x, z; none closer than 0.6 bandwidths to a denser
// Returns how many there are, 0 of an empty cloud.
uint32_t find_modes(const Cloud& cloud, int32_t bandwidth, bool mirrored, uint32_t most, Mode* modes);

// The order of points in a cloud.
inline bool comes_before(Vec3i a, Vec3i b) { return a.y != b.y ? a.y < b.y : a.x != b.x ? a.x < b.x : a.z < b.z; }

}  // namespace sinew::rigging
#endif
