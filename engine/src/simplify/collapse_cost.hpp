// SPDX-License-Identifier: MIT
// Cost of an edge collapse in a graph in space: how far its middle is from the lines of the edges at both ends.
#ifndef SINEW_SIMPLIFY_COLLAPSE_COST_HPP
#define SINEW_SIMPLIFY_COLLAPSE_COST_HPP

#include "core/vec3d.hpp"

namespace sinew::simplifying {

constexpr double kSamplingWeight = 0.1;  // beside the shape's 1

// The edges at a node. The squared distance of p from the line through n along the unit vector a is |a x (p - n)|^2; their
// sum over the edges is (p - n)^T A (p - n) with A = sum of (1 - a a^T), because every line goes through the node.
struct EdgesAtNode {
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;  // A

  void add(const Vec3d& along) {
    const double squared = dot(along, along);
    if (!(squared > 1e-24)) return;
    const double s = 1 / squared;
    xx += 1 - s * along.x * along.x;
    yy += 1 - s * along.y * along.y;
    zz += 1 - s * along.z * along.z;
    xy -= s * along.x * along.y;
    yz -= s * along.y * along.z;
    zx -= s * along.z * along.x;
  }
  double error(const Vec3d& d) const {
    return xx * d.x * d.x + yy * d.y * d.y + zz * d.z * d.z + 2 * (xy * d.x * d.y + yz * d.y * d.z + zx * d.z * d.x);
  }
};

// Cost of the edge from node a, which is removed, to node b; `along` is b - a. The samples' part is the distance of
// both nodes' samples, times the sum of those to all that node a has an edge to.
inline double collapse_cost(const EdgesAtNode& a, const EdgesAtNode& b, const Vec3d& along, double apart, double sum) {
  const Vec3d half = 0.5 * along;
  return a.error(half) + b.error(half) + kSamplingWeight * apart * sum;
}

}  // namespace sinew::simplifying
#endif
