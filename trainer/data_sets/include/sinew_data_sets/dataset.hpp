// SPDX-License-Identifier: MIT
// Data set tooling on half-edge meshes (OpenMesh): checks and decimated variants.
#ifndef SINEW_DATA_SETS_DATASET_HPP
#define SINEW_DATA_SETS_DATASET_HPP

#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

struct CheckFinding {
  enum class Level { kNote, kWarning, kError } level;
  std::string code;                     // "non-manifold-edges", "weight-sum", ...
  size_t count = 0;                     // how many elements
  std::string text;                     // one line, names the first few elements
  std::vector<uint32_t> vertices = {};  // of findings about weights: all of them, ascending
};

struct CheckReport {
  size_t vertices = 0, faces = 0, joints = 0, parts = 0, boundary_edges = 0, non_manifold_edges = 0;
  size_t degenerate_faces = 0, duplicate_faces = 0, isolated_vertices = 0, unbound_vertices = 0, bad_weight_sums = 0;
  size_t joints_outside = 0, roots = 0, hierarchy_cycles = 0, max_influences = 0;
  std::vector<CheckFinding> findings;
};

// Findings with the codes of check_labels() (label_check.hpp) are warnings, one each.
CheckReport check_character(const Character& character);

// Quadric decimation to about `ratio` (0..1] of the vertices; seams and boundaries kept, weights carried along (a
// surviving vertex keeps its own row). Vertices that end in no face are dropped. Throws Error when there are no faces.
Character decimate(const Character& character, double ratio);

// Every triangle, and every one of a polygon's fan, into four. Vertices stay, new ones follow them in the middle of the
// edges, with the mean of both ends' weights. Mesh, joints and weights alone; a mesh without faces stays as it is.
Character subdivide(const Character& character);

}  // namespace sinew
#endif
