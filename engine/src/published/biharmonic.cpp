// SPDX-License-Identifier: MIT
// The vertices of the source whose distances to the reference points are most like a target vertex's.
#include "published/references.hpp"
#include "published/surface_distances.hpp"
#include "transfer/published.hpp"

namespace sinew::transferring {
namespace {

constexpr uint32_t kNearest = DistanceMatch::kNearest;
constexpr uint32_t kFewest = 4;         // references
constexpr uint32_t kCompared = 8;       // references of a vertex, those that are nearest to it: of a caller's few pairs
constexpr uint32_t kComparedFound = 5;  // and of those that were found; as drawn all
constexpr uint32_t kNeighbors = 6;      // references around one, for its scale
constexpr double kMostDistanceScale = 2;  // of one reference's distances
constexpr double kNearDistance = 0.02;    // added to distances before they are inverted
constexpr double kLeastShare = 1e-6;      // of the farthest's squared difference: what is the same takes all

// Numbers with the smallest keys, ascending; of equal keys the first ones.
template <uint32_t kMost>
struct Least {
  double keys[kMost] = {};
  uint32_t numbers[kMost] = {};
  uint32_t count = 0;

  double limit() const { return count < kMost ? 1e300 : keys[kMost - 1]; }
  void add(double key, uint32_t number) {
    if (key >= limit()) return;
    uint32_t at = count < kMost ? count++ : kMost - 1;
    for (; at > 0 && keys[at - 1] > key; --at) {
      keys[at] = keys[at - 1];
      numbers[at] = numbers[at - 1];
    }
    keys[at] = key;
    numbers[at] = number;
  }
};

// References that a vertex is compared at, and its distances to them.
struct Compared {
  double keys[SINEW_MAX_TRANSFER_PAIRS];
  uint32_t numbers[SINEW_MAX_TRANSFER_PAIRS];
  uint32_t count = 0;

  void append(double key, uint32_t number) {
    keys[count] = key;
    numbers[count++] = number;
  }
};

// Both meshes' distances, a column a reference point.
struct Columns {
  const References& references;
  double *source, *target;  // [references x U]
  uint32_t source_count, target_count;
  const uint32_t *source_part, *target_part;  // [U]
  const uint8_t* of_use;                      // [source U]
  bool as_drawn;
  uint32_t most_compared;

  // One mesh may be thicker here and thinner there: the distances of each reference on the source are scaled so that those to
  // the references around it are the target's.
  void scale() const {
    for (uint32_t i = 0; i < references.count; ++i) {
      const double* const column = target + size_t{i} * target_count;
      Least<kNeighbors> around;
      for (uint32_t j = 0; j < references.count; ++j) {
        if (j != i) around.add(mean_at(references.points[j].target, column), j);
      }
      double* const other = source + size_t{i} * source_count;
      double own = 0, sum = 0;
      for (uint32_t k = 0; k < around.count; ++k) {
        own += around.keys[k];
        sum += mean_at(references.points[around.numbers[k]].source, other);
      }
      const double factor = sum > 0 ? clamped(own / sum, 1 / kMostDistanceScale, kMostDistanceScale) : 1;
      for (uint32_t v = 0; v < source_count; ++v) other[v] *= factor;
    }
  }

  bool lies_beside(const Compared& compared, uint32_t source_vertex) const {
    for (uint32_t k = 0; k < compared.count; ++k) {
      const uint32_t corner = references.points[compared.numbers[k]].source.corners[0];
      if (source_part[corner] == source_part[source_vertex]) return true;
    }
    return false;
  }

  // The source's vertices with the least squared difference of distances; of the compared references' parts alone, if asked.
  Least<kNearest> most_alike(const Compared& compared, bool of_their_parts) const {
    double weights[SINEW_MAX_TRANSFER_PAIRS];
    for (uint32_t k = 0; k < compared.count; ++k) {
      const double d = compared.keys[k] + kNearDistance;
      weights[k] = as_drawn ? 1 : 1 / (d * d);
    }
    Least<kNearest> best;
    constexpr uint32_t kRun = 64;
    for (uint32_t first = 0; first < source_count; first += kRun) {
      const uint32_t size = source_count - first < kRun ? source_count - first : kRun;
      double sums[kRun] = {};
      for (uint32_t k = 0; k < compared.count; ++k) {
        const double* const column = source + size_t{compared.numbers[k]} * source_count + first;
        const double own = compared.keys[k], weight = weights[k];
        for (uint32_t s = 0; s < size; ++s) sums[s] += weight * ((column[s] - own) * (column[s] - own));
      }
      for (uint32_t s = 0; s < size; ++s) {
        if (of_use[first + s] == 0 || sums[s] >= best.limit()) continue;
        if (!of_their_parts || lies_beside(compared, first + s)) best.add(sums[s], first + s);
      }
    }
    return best;
  }

  double distance(uint32_t vertex, uint32_t reference) const {
    return target[size_t{reference} * target_count + vertex];
  }
  bool is_own(uint32_t vertex, uint32_t reference) const {
    return target_part[references.points[reference].target.corners[0]] == target_part[vertex];
  }

  // How far parts are from each other is what ties make of it: a vertex is compared at references of its own part, with vertices
  // of the parts where those lie on the source. A part without such references is compared at all.
  Least<kNearest> most_alike(uint32_t vertex) const {
    uint32_t own_count = 0;
    for (uint32_t i = 0; i < references.count; ++i) own_count += is_own(vertex, i) ? 1 : 0;
    const bool has_own = own_count >= kFewest;
    Compared compared;
    if (as_drawn) {
      for (uint32_t i = 0; i < references.count; ++i)
        if (!has_own || is_own(vertex, i)) compared.append(distance(vertex, i), i);
    } else {
      Least<kCompared> nearest;
      for (uint32_t i = 0; i < references.count; ++i)
        if (!has_own || is_own(vertex, i)) nearest.add(distance(vertex, i), i);
      for (uint32_t k = 0; k < nearest.count && k < most_compared; ++k)
        compared.append(nearest.keys[k], nearest.numbers[k]);
    }
    const Least<kNearest> best = most_alike(compared, has_own);
    return best.count > 0 ? best : most_alike(compared, false);
  }

  void find(uint32_t vertex, uint32_t* vertices, double* shares) const {
    const Least<kNearest> best = most_alike(vertex);
    double sum = 0;
    const double farthest = best.keys[best.count - 1];
    for (uint32_t i = 0; i < best.count; ++i) {
      shares[i] = 1 / (best.keys[i] + kLeastShare * farthest + 1e-30);
      sum += shares[i];
    }
    for (uint32_t i = 0; i < kNearest; ++i) {
      vertices[i] = best.numbers[i < best.count ? i : 0];
      shares[i] = i < best.count ? shares[i] / sum : 0;
    }
  }
};

}  // namespace

void DistanceMatch::carry(const Rows& source_rows, uint32_t vertex, const Rows& out) const {
  out.clear(vertex);
  for (uint32_t k = 0; k < kNearest; ++k) {
    const uint32_t from = vertices[size_t{kNearest} * vertex + k];
    const double share = shares[size_t{kNearest} * vertex + k];
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      const uint16_t joint = source_rows.joints_of(from)[i];
      const uint32_t weight = static_cast<uint32_t>(share * source_rows.weights_of(from)[i] + 0.5);
      if (joint != kNoJoint && weight > 0) out.add(vertex, joint, weight);
    }
  }
  make_whole(out, vertex);
}

sinew_status match_by_distances(const TransferPlan& plan, const Pair& pair, const Rows& source_rows, Arena& arena,
                                DistanceMatch* match) {
  const ArenaScope scope(arena);
  References references;
  const uint32_t most = References::most(plan);
  (void)references.allocate(arena, plan);
  uint8_t* const of_use = arena.alloc<uint8_t>(plan.source.vertices);
  double* const source = arena.alloc<double>(size_t{most} * plan.source.vertices);
  double* const target = arena.alloc<double>(size_t{most} * plan.target.vertices);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  uint32_t useful = 0;
  for (uint32_t s = 0; !arena.measuring() && s < pair.source.welded_count; ++s) {
    of_use[s] = 0;
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      const uint16_t joint = source_rows.joints_of(s)[i];
      if (joint != kNoJoint && source_rows.weights_of(s)[i] > 0 && pair.map.target_of[joint] >= 0) of_use[s] = 1;
    }
    useful += of_use[s];
  }
  if (!arena.measuring() && useful == 0) return SINEW_ERROR_RANGE;
  sinew_status status = references.find(plan, pair, source_rows, of_use, arena);
  if (status != SINEW_OK) return status;
  if (!arena.measuring() && references.count < kFewest) return SINEW_ERROR_RANGE;
  for (uint32_t side = 0; side < 2; ++side) {
    const ArenaScope one(arena);
    SurfaceDistances distances;
    const Counts& counts = side == 0 ? plan.source : plan.target;
    if (!distances.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
    status = distances.find(side == 0 ? pair.source : pair.target, references, side == 0, counts, arena,
                            side == 0 ? source : target);
    if (status != SINEW_OK) return status;
  }
  if (arena.measuring()) return SINEW_OK;
  match->reference_count = references.count;
  const Columns columns = {references,
                           source,
                           target,
                           pair.source.welded_count,
                           pair.target.welded_count,
                           pair.source.part,
                           pair.target.part,
                           of_use,
                           plan.as_drawn,
                           plan.pair_count > 0 ? kCompared : kComparedFound};
  if (!plan.as_drawn) columns.scale();
  constexpr uint32_t kVertexPiece = 64;
  plan.target.threads.ranges(pair.target.welded_count, kVertexPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    for (uint32_t v = begin; v < end; ++v)
      columns.find(v, match->vertices + size_t{kNearest} * v, match->shares + size_t{kNearest} * v);
  });
  return SINEW_OK;
}

}  // namespace sinew::transferring
