// SPDX-License-Identifier: MIT
// Sections sampled by direction and level; lines and coordinates from these samples.
#include "springs/garment_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace sinew {
namespace {

constexpr size_t kRows = 3;             // joints of a line
constexpr double kRing = 0.95;          // of a turn: a garment that covers so much is closed
constexpr double kSampleStep = 0.005;   // of the height between two samples of a curve
constexpr double kLineDistance = 0.12;  // of the height from line to line
constexpr size_t kFewestRing = 6, kMostRing = 12, kFewestSheet = 3, kMostSheet = 7;

}  // namespace

GarmentLattice::GarmentLattice(const SectionedMesh& mesh, double height, bool skirt, const GarmentLevels& levels,
                               const Coordinate& coordinate, const Middle& middle)
    : mesh_(mesh), height_(height), skirt_(skirt), levels_(levels), coordinate_(coordinate), middle_(middle) {
  sample();
  find_extent();
  count_ = line_count();
  for (size_t line = 0; line < count_; ++line) line_hems_.push_back(hem_near(part_at(share_of(line))));
}

void GarmentLattice::sample() {
  surface_.assign(kParts, std::vector<std::optional<Point2>>(levels_.last + 1));
  double longest = 0, span = 0;
  size_t spans = 0;
  for (size_t k = 0; k <= levels_.last; ++k) {
    const double height = levels_.height(k);
    const Point2 middle = middle_(height);
    double left = -1e30, right = 1e30;
    for (const size_t i : levels_.curves[k]) {
      const SectionCurve& curve = levels_.sections[k][i];
      longest = std::max(longest, curve.total_length());
      for (const auto& segment : curve.segments) {
        const auto steps = static_cast<size_t>(length(segment[1] - segment[0]) / (kSampleStep * height_)) + 1;
        for (size_t n = 0; n <= steps; ++n) {
          const double share = static_cast<double>(n) / static_cast<double>(steps);
          const Point2 p = {segment[0][0] + share * (segment[1][0] - segment[0][0]),
                            segment[0][1] + share * (segment[1][1] - segment[0][1])};
          left = std::max(left, p[0]);
          right = std::min(right, p[0]);
          std::optional<Point2>& outermost = surface_[part_at(coordinate_(p, height))][k];
          if (!outermost || length(p - middle) > length(*outermost - middle)) outermost = p;
        }
      }
    }
    if (left <= right) continue;
    span += left - right;
    ++spans;
  }
  around_ = skirt_ ? longest : span / static_cast<double>(std::max<size_t>(spans, 1));
}

// How far down each part hangs, and which parts there are.
void GarmentLattice::find_extent() {
  hems_.assign(kParts, -1);
  for (size_t part = 0; part < kParts; ++part)
    for (size_t k = 0; k <= levels_.last; ++k)
      if (surface_[part][k]) hems_[part] = static_cast<double>(k);
  if (!skirt_) return;
  const auto covered = static_cast<size_t>(std::count_if(
      hems_.begin(), hems_.end(), [&](double hem) { return hem >= 0.5 * static_cast<double>(levels_.last); }));
  ring_ = static_cast<double>(covered) >= kRing * kParts;
  if (!ring_) std::tie(from_, to_) = widest_arc();
}

// The longest run of parts that hang at least half as far down as the hem, around the front; as shares of a turn, the end above 1 where it
// passes the front.
std::pair<double, double> GarmentLattice::widest_arc() const {
  const double least = 0.5 * static_cast<double>(levels_.last);
  size_t best = 0, best_begin = 0;
  for (size_t begin = 0; begin < kParts; ++begin) {
    size_t run = 0;
    while (run < kParts && hems_[(begin + run) % kParts] >= least) ++run;
    if (run > best) {
      best = run;
      best_begin = begin;
    }
  }
  const double from = (static_cast<double>(best_begin) + 0.5) / kParts;
  return {from, from + (static_cast<double>(best) - 1) / kParts};
}

size_t GarmentLattice::line_count() const {
  const double around = skirt_ ? around_ * (to_ - from_) : around_;
  const double wanted = std::round(around / (kLineDistance * height_));
  if (!skirt_) return static_cast<size_t>(std::clamp(wanted + 1, double{kFewestSheet}, double{kMostSheet}));
  const auto count = static_cast<size_t>(std::clamp(wanted, double{kFewestRing}, double{kMostRing}));
  return ring_ ? count + count % 2 : count;
}

double GarmentLattice::share_of(size_t line) const {
  const double share =
      from_ + (to_ - from_) * static_cast<double>(line) / static_cast<double>(ring_ ? count_ : count_ - 1);
  return skirt_ && share >= 1 ? share - std::floor(share) : share;
}

size_t GarmentLattice::part_at(double share) const {
  return static_cast<size_t>(std::clamp(share * kParts, 0.0, kParts - 1.0));
}

// Around a skirt parts go on behind the last one; a sheet ends.
std::optional<size_t> GarmentLattice::part_beside(size_t part, std::ptrdiff_t offset) const {
  constexpr auto kCount = static_cast<std::ptrdiff_t>(kParts);
  std::ptrdiff_t beside = static_cast<std::ptrdiff_t>(part) + offset;
  if (skirt_) beside = (beside + kCount) % kCount;
  if (beside < 0 || beside >= kCount) return std::nullopt;
  return static_cast<size_t>(beside);
}

double GarmentLattice::hem_near(size_t part) const {
  double lowest = 0;
  for (const std::ptrdiff_t offset : {-1, 0, 1})
    if (const std::optional<size_t> beside = part_beside(part, offset)) lowest = std::max(lowest, hems_[*beside]);
  return lowest;
}

// The sample that is nearest to a part and a level, for the surface may have small holes.
std::optional<Point3> GarmentLattice::surface_near(size_t part, double level) const {
  const auto wanted = static_cast<std::ptrdiff_t>(std::round(level));
  for (std::ptrdiff_t offset = 0; offset <= static_cast<std::ptrdiff_t>(kParts / 8); ++offset)
    for (const std::ptrdiff_t side : {offset, -offset}) {
      const std::optional<size_t> beside = part_beside(part, side);
      if (!beside) continue;
      const auto& column = surface_[*beside];
      for (const std::ptrdiff_t difference : {0, -1, 1, -2, 2}) {
        const std::ptrdiff_t row = wanted + difference;
        if (row < 0 || row >= static_cast<std::ptrdiff_t>(column.size()) || !column[static_cast<size_t>(row)]) continue;
        return mesh_.point_at(*column[static_cast<size_t>(row)], levels_.height(static_cast<size_t>(wanted)));
      }
    }
  return std::nullopt;
}

std::vector<std::vector<Point3>> GarmentLattice::lines() const {
  std::vector<std::vector<Point3>> out(count_);
  for (size_t line = 0; line < count_; ++line)
    for (size_t row = 0; row <= kRows; ++row) {
      const std::optional<Point3> p =
          surface_near(part_at(share_of(line)), line_hems_[line] * static_cast<double>(row) / kRows);
      if (!p) return {};
      out[line].push_back(*p);
    }
  return out;
}

std::array<double, 2> GarmentLattice::position_of(size_t vertex) const {
  const double height = mesh_.height(vertex), intervals = static_cast<double>(ring_ ? count_ : count_ - 1);
  double share = coordinate_(mesh_.across(vertex), height);
  if (skirt_ && share < from_) share += 1;  // an arc may pass the front
  double along = (share - from_) / (to_ - from_) * intervals;
  if (!ring_) {
    const bool nearer_to_first = skirt_ && share - to_ > 0.5 * (1 - (to_ - from_));  // beyond the middle of the opening
    along = nearer_to_first ? 0 : std::clamp(along, 0.0, intervals);
  }
  const auto low = static_cast<size_t>(std::floor(along)) % count_;
  const size_t high = ring_ ? (low + 1) % count_ : std::min(low + 1, count_ - 1);
  const double between = along - std::floor(along);
  const double depth = ((1 - between) * line_hems_[low] + between * line_hems_[high]) * levels_.step();
  return {along, depth > 0 ? std::clamp((levels_.top - height) / depth, 0.0, 1.0) : 0};
}

}  // namespace sinew
