// SPDX-License-Identifier: MIT
// Counts and findings of one character: its faces, edges, joints and weights.
#ifndef SINEW_CHARACTER_CHECK_MESH_CHECK_HPP
#define SINEW_CHARACTER_CHECK_MESH_CHECK_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

struct CheckFinding {
  enum class Level { kNote, kWarning, kError } level;
  std::string code;                     // "non-manifold-edges", "weight-sum", ...
  size_t count = 0;                     // number of elements
  std::string text;                     // one line, names the first few elements
  std::vector<uint32_t> vertices = {};  // of findings about weights: all of them, ascending
};

struct CheckReport {
  size_t vertices = 0, faces = 0, joints = 0, parts = 0, boundary_edges = 0, non_manifold_edges = 0;
  size_t degenerate_faces = 0, duplicate_faces = 0, isolated_vertices = 0, unbound_vertices = 0, bad_weight_sums = 0;
  size_t joints_outside = 0, roots = 0, hierarchy_cycles = 0, max_influences = 0;
  std::vector<CheckFinding> findings;
};

// Returns the number of loops of boundary edges.
//   faces     corners of each face, all distinct
//   faces_at  number of faces at each edge, by its lower and higher vertex
using BoundaryLoops = std::function<size_t(const std::vector<std::vector<uint32_t>>& faces,
                                           const std::map<std::pair<uint32_t, uint32_t>, size_t>& faces_at)>;

// Findings with the codes of check_labels() (label_check.hpp) are warnings, one each.
//   loops  counts the loops of boundary edges for the note about them; null: the note has no count
CheckReport check_character(const Character& character, const BoundaryLoops& loops = {});

}  // namespace sinew
#endif
