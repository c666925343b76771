// SPDX-License-Identifier: MIT
// Skeletons by published methods, for comparison with votes and the middle line (curve.hpp). The room `published` defines the
// functions.
#ifndef SINEW_RIG_PUBLISHED_HPP
#define SINEW_RIG_PUBLISHED_HPP

#include "kernels/table.hpp"
#include "mesh/mesh.hpp"
#include "network/network.hpp"
#include "rig/folded_tree.hpp"
#include "rig/tree.hpp"

namespace sinew::rigging {

// SINEW_RIG_REGIONS: seeds as far from each other as can be; regions that grow from them over edges; an oriented box around each. Regions whose
// boxes overlap and whose points come near each other are joined in a graph of the boxes' middles. Its edges collapse, the
// cheapest first (simplify/collapse_cost.hpp): those of triangles, whose ends share a neighbor, those of regions without much surface, short ones,
// leaves of a crowd. What is left is joined by its shortest tree from the node nearest to the middle of the surface.
// All joints are of class other, their confidence is 0, and nothing is mirrored.
//   tree  out  at least one node, the root
// Scratch is taken from the arena and released. Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status grow_regions(const Mesh& mesh, const Counts& counts, Arena& arena, FoldedTree* tree);

// SINEW_RIG_SLOTS: joints in fixed slots, connections, their spanning tree.
struct SlotsPlan {
  sinew_model joints, connections;  // the file's two networks
  NetworkOptions network;
  BodyKind category = BodyKind::kAny;
};

// Opens a file whose first network has kSlotsFeatureSet, and proves both networks. Returns what read_header() and open_model() do;
// SINEW_ERROR_MODEL_LAYOUT where there is no second one, SINEW_ERROR_MODEL_VERSION without published methods.
sinew_status open_slots_model(const void* bytes, size_t size_bytes, sinew_model* model);

// Both networks of a model that open_slots_model() gave. Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_MODEL_TASK.
sinew_status plan_slots(const sinew_model* model, SlotsPlan* plan);

// All of it for a mesh in its mirror frame. Scratch is taken from the arena and released. Returns SINEW_OK,
// SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status find_slots(const SlotsPlan& plan, const RigOptions& options, const Mesh& mesh, const Kernels& kernels,
                        const Progress& progress, Arena& arena, Rig* rig);

}  // namespace sinew::rigging
#endif
