// SPDX-License-Identifier: MIT
// Polygonises the smooth union of a blueprint's primitives into one closed manifold mesh with exact skin weights.
#ifndef SINEW_DATA_SETS_SYNTH_SURFACE_HPP
#define SINEW_DATA_SETS_SYNTH_SURFACE_HPP

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
// to two steps away; at most four, multiples of 1/1000 that sum to 1, sorted by falling weight.
std::vector<Influence> body_weights(const Blueprint& plan, Point p);
// The same rounding for any blend: keeps the four largest, drops what is under 1 %, normalises.
std::vector<Influence> tidy_weights(std::vector<Influence> row);

// Dual contouring on a grid of plan.cell (one vertex per surface cell, mostly quads, moved onto the surface): closed,
// every edge has two faces, one part, outward orientation. Grid signs are first made well-composed, so that no
// cell is ambiguous (Latecki, Eckhardt, Rosenfeld: Well-Composed Sets, 1995).
Surface polygonise(const Blueprint& plan);

}  // namespace sinew::synth
#endif
