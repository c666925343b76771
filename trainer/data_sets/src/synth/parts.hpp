// SPDX-License-Identifier: MIT
// Separate parts of generated characters: rigid lumps, shells of revolution, and clothes cut from the body.
#ifndef SINEW_DATA_SETS_SYNTH_PARTS_HPP
#define SINEW_DATA_SETS_SYNTH_PARTS_HPP

#include <array>
#include <vector>

#include "synth/surface.hpp"

namespace sinew::synth {

// Three half axes of a lump; they need not be orthogonal or unit.
struct Frame {
  Point x, y, z;
};
// Half axes hx, hy, hz along the world axes.
Frame box_frame(double hx, double hy, double hz);
// z runs along a bone from a to b (half its length), x and y across it with the given half sizes.
Frame bone_frame(Point a, Point b, double hx, double hy);

// A closed lump bound to one joint: a subdivided cube (n cells per edge) whose corners are rounded by `round` (0 = box,
// 1 = ellipsoid); its cross section at +z is `taper` times the one at -z.
Surface lump(uint32_t joint, Point centre, const Frame& frame, int n, double round, double taper = 1);
// Rings of `sides` vertices around the vertical axis through `centre`, one per profile point (radius x, radius z,
// height), joined by quads; a profile point with radius 0 is a pole. Listed from the top down it faces outwards.
// `closed` joins the last ring to the first (a torus).
Surface revolve(uint32_t joint, Point centre, const std::vector<std::array<double, 3>>& profile, int sides,
                bool closed = false);

// Clothes and parts that fit the plan's roles, chosen by the seed. `body` is the polygonised body.
Surface dress(const Blueprint& plan, const Surface& body, BodyPlan kind, Random* random);
// Eyes: part of nearly every character.
Surface eyes(const Blueprint& plan, Random* random);
// A closed capsule for every bone, bound to its joint: rings of `sides` vertices with a pole at both ends.
Surface capsule_body(const Blueprint& plan, int sides);
// The whole character as rigid closed parts, one or two per bone, as robots and toys are built.
Surface rigid_body(const Blueprint& plan, Random* random);

}  // namespace sinew::synth
#endif
