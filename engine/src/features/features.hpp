// SPDX-License-Identifier: MIT
// Stages 5 to 7 of a bind: everything the network sees, as int16 in Q13 (8192 = 1.0), clamped to [-16384, 16383].
// One implementation: the trainer calls this code, so what is trained is what runs.
#ifndef SINEW_FEATURES_FEATURES_HPP
#define SINEW_FEATURES_FEATURES_HPP

#include "candidates/candidates.hpp"
#include "core/build.hpp"
#include "heat/heat.hpp"
#include "mesh/mesh.hpp"
#include "skeleton/skeleton.hpp"

namespace sinew {

constexpr uint32_t kFeatureSet = 1;  // grows whenever a feature changes its meaning; models name the set they need
// A model's feature set is kFeatureSet in its low 16 bits and flags of what it wants beside it in the high ones.
constexpr uint32_t kSpectralFlag = 1u << 16;  // the channels of spectral/spectral.hpp, behind the others of a vertex
constexpr uint32_t kAttributesFlag =
    1u << 17;  // those of features/attributes.hpp instead of all others but the spectral ones
constexpr uint32_t kFeatureFlags = kHasExtras ? kSpectralFlag | kAttributesFlag : 0;
constexpr int kFeatureBits = 13;
// Buffers of the network that the rows are for.
constexpr uint16_t kVertexInput = 0;
constexpr uint16_t kPairInput = 1;
extern const uint32_t kVertexFeatures;  // channels of a vertex without flags
extern const uint32_t kPairFeatures;    // channels of a pair
// Pair channels of the prior: natural log of the rule and parts field, divided by 8 to fit Q13.
extern const uint32_t kPairLogRule;
extern const uint32_t kPairLogParts;
constexpr int kLogFeatureDivisor = 8;
// Channels of a vertex for a feature set or its flags alone, those in front of the spectral ones, and channels of a pair.
uint32_t vertex_channels(uint32_t feature_flags);
uint32_t plain_vertex_channels(uint32_t feature_flags);
uint32_t pair_channels(uint32_t feature_flags);

struct Features {
  int16_t* vertex = nullptr;  // [U x vertex_channels]
  uint32_t vertex_channels = 0;
  int16_t* pair = nullptr;  // [U x K x pair_channels()]; absent slots are all 0
  // The final candidates: the voxel candidates with heat joints merged in. kNoJoint at the end.
  uint16_t* joints = nullptr;  // [U x K]

  bool allocate(Arena& arena, const Counts& counts);
};

// Fills everything but the channels of flags, which their own stages write.
sinew_status build_features(const Mesh& mesh, const Skeleton& skeleton, const Candidates& candidates,
                            const HeatFields& heat, const Counts& counts, Arena& arena, Features* out);

}  // namespace sinew
#endif
