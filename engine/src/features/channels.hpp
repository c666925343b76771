// SPDX-License-Identifier: MIT
// Names of the feature channels in the order that models of kFeatureSet know: X(name) for each. The engine makes its
// indices of them, the trainer the texts; what a channel holds is written where features.cpp fills it.
#ifndef SINEW_FEATURES_CHANNELS_HPP
#define SINEW_FEATURES_CHANNELS_HPP

#include <stdint.h>

#define SINEW_VERTEX_CHANNELS(X) \
  X(mean_curvature)              \
  X(gauss_curvature)             \
  X(edge_length_log)             \
  X(part_share_log)              \
  X(part_source_share)           \
  X(part_count_log)              \
  X(joint_count_log)             \
  X(vertex_count_log)            \
  X(part_boundary_share)         \
  X(host_gap)                    \
  X(is_largest_part)             \
  X(part_extent)                 \
  X(part_flatness)               \
  X(part_purity)                 \
  X(rule_is_parts)               \
  X(rule_is_open)                \
  X(has_source)                  \
  X(has_source_parts)            \
  X(host_purity)                 \
  X(loose_share)                 \
  X(normal_up)                   \
  X(part_contact)

#define SINEW_PAIR_CHANNELS(X) \
  X(rule)                      \
  X(rule_root)                 \
  X(rule_log)                  \
  X(rule_relative)             \
  X(parts)                     \
  X(parts_root)                \
  X(parts_log)                 \
  X(parts_relative)            \
  X(soft)                      \
  X(soft_root)                 \
  X(soft_log)                  \
  X(rule_raw_root)             \
  X(voxel_distance)            \
  X(voxel_ratio)               \
  X(bone_distance)             \
  X(bone_ratio)                \
  X(bone_position)             \
  X(bone_cosine)               \
  X(bone_normal)               \
  X(bone_up)                   \
  X(bone_length)               \
  X(is_leaf)                   \
  X(children)                  \
  X(tree_distance)             \
  X(is_parent_of_top)          \
  X(is_child_of_top)           \
  X(is_top)                    \
  X(rule_nearest)              \
  X(soft_nearest)              \
  X(parent_rule)               \
  X(children_rule)             \
  X(host_share)                \
  X(host_subtree)              \
  X(is_host_top)               \
  X(part_share)                \
  X(part_subtree)              \
  X(part_parent_subtree)       \
  X(is_part_top)               \
  X(joint_in_box)              \
  X(topmost_in_box)            \
  X(deepest_of_part)           \
  X(centre_distance)           \
  X(centre_ratio)              \
  X(territory)                 \
  X(is_source)                 \
  X(is_root)

namespace sinew {

// Channels that the spectral stage (spectral/spectral.hpp) writes behind the others of a vertex, on demand.
constexpr uint32_t kSpectralChannels = 18;

}  // namespace sinew
#endif
