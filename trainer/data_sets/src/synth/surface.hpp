// SPDX-License-Identifier: MIT
// Meshes of generated characters: the smooth union of a blueprint's primitives as one closed manifold mesh with exact skin weights,
// and separate parts: rigid lumps, shells of revolution, clothes cut from the body.
#ifndef SINEW_DATA_SETS_SYNTH_SURFACE_HPP
#define SINEW_DATA_SETS_SYNTH_SURFACE_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "sinew_formats/character.hpp"
#include "synth/blueprint.hpp"

namespace sinew::synth {

// A piece of mesh in double precision. Faces are triangles or quads, counter-clockwise seen from outside.
struct Surface {
  std::vector<Point> positions;
  std::vector<std::vector<uint32_t>> faces;
  std::vector<std::vector<Influence>> influences;  // [V]

  // Appends another piece as separate part(s).
  void append(const Surface& piece);
};

// Area-weighted unit normals [V].
std::vector<Point> vertex_normals(const Surface& surface);

// Signed distance of one primitive (exact for scale 1, a lower bound otherwise), and of the smooth union of all of
// them.
double primitive_distance(const Primitive& primitive, Point p);
double body_distance(const Blueprint& plan, Point p);

// Weights at a point: joints whose primitives are about as near as the nearest one, among its relatives in the tree up
// to two steps away; at most four, multiples of 1/1000 that sum to 1, sorted by descending weight.
std::vector<Influence> body_weights(const Blueprint& plan, Point p);
// The same rounding for any blend: keeps the four largest, drops what is under 1 %, normalizes.
std::vector<Influence> tidy_weights(std::vector<Influence> row);

// Dual contouring on a grid of plan.cell (one vertex per surface cell, mostly quads, moved onto the surface): closed,
// every edge has two faces, one part, outward orientation. Grid signs are first made well-composed, so that no
// cell is ambiguous (Latecki, Eckhardt, Rosenfeld: Well-Composed Sets, 1995).
Surface polygonise(const Blueprint& plan);

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
Surface lump(uint32_t joint, Point center, const Frame& frame, int n, double round, double taper = 1);
// Rings of `sides` vertices around the vertical axis through `center`, one per profile point (radius x, radius z,
// height), joined by quads; a profile point with radius 0 is a pole. Listed from the top down it faces outwards.
// `closed` joins the last ring to the first (a torus).
Surface revolve(uint32_t joint, Point center, const std::vector<std::array<double, 3>>& profile, int sides,
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
