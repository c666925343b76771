// SPDX-License-Identifier: MIT
// Samples on disk: features take half a second per character, reading them back a few milliseconds. Changed copies
// of characters, whose features are computed anew.
#ifndef SINEW_TRAINER_DATA_SAMPLE_CACHE_HPP
#define SINEW_TRAINER_DATA_SAMPLE_CACHE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_data_sets/synthesize.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew {

struct SampleRequest {
  std::string mesh_path;             // as list_characters() gives it; empty: a synthetic character
  std::string name;                  // of the sample; empty: the character's own
  uint32_t variant = 0;              // 0 = the character itself, n = its n-th augmented variant
  BodyPlan plan = BodyPlan::kBiped;  // of a synthetic character
  uint64_t synthetic_seed = 0;
};
struct SampleSource {
  uint32_t candidates = 8, grid = 64;
  uint32_t feature_flags = 0;
  uint64_t seed = 0;          // of the variants
  uint32_t vertex_limit = 0;  // characters with more vertices are decimated to about as many; 0 = off
  std::string cache_dir;
  uint32_t threads = 1;
  bool quiet = true;
  bool silent = false;  // not even the names of those that failed: another rank says them
};
// One sample per request, in order; without those that failed, which are named on stderr. A cache file is found by the
// content of the character's files and everything the features depend on; a damaged one is made again. Throws Error
// when the cache folder cannot be written or when every request failed.
std::vector<Sample> load_requests(const std::vector<SampleRequest>& requests, const SampleSource& source);

// Makes what the cache lacks, without keeping it in memory; the part-th of `parts` processes that work on one cache
// (part from 0). It begins with its own part and then looks what the others have left, so that none waits and almost
// nothing is made twice; files appear whole. Returns how many it made; throws as load_requests.
size_t fill_cache(const std::vector<SampleRequest>& requests, const SampleSource& source, uint32_t part,
                  uint32_t parts);

constexpr uint32_t kAugmentVersion = 3;  // part of the cache key: grows whenever augment() changes

// Turned about the up axis (Y) by any angle, perhaps mirrored in X, stretched by 0.8..1.2 per axis, vertices and
// joints jittered, for two seeds in five decimated to 0.4..0.9 of its vertices, and for one in five, with at most 1,500
// vertices, subdivided once. Weights follow their vertices.
// Perhaps with a thinner skeleton (joints removed, their weights given to the parent; end markers removed), with joints
// that do not deform (a root on the floor, controls, end markers) and in another rest pose (posed by its own weights).
// Vertices or joints at the same position stay at the same position. The same seed gives the same character. What only
// writers need (UVs, materials) is dropped.
Character augment(const Character& character, uint64_t seed);

}  // namespace sinew
#endif
