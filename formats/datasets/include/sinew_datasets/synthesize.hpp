// SPDX-License-Identifier: MIT
// Characters of our own with exact ground truth: smooth-union bodies polygonised into closed meshes, with clothing and
// floating parts.
#ifndef SINEW_DATASETS_SYNTHESIZE_HPP
#define SINEW_DATASETS_SYNTHESIZE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

enum class BodyPlan { kBiped, kQuadruped, kBird, kSnake, kManyLegged };
constexpr BodyPlan kBodyPlans[] = {BodyPlan::kBiped, BodyPlan::kQuadruped, BodyPlan::kBird, BodyPlan::kSnake,
                                   BodyPlan::kManyLegged};

struct SynthesizeOptions {
  BodyPlan plan = BodyPlan::kBiped;
  uint64_t seed = 1;     // the same seed gives the same character on every machine
  int resolution = 48;   // cells along the longest side
  bool clothing = true;  // open shells, capes, hats, floating parts
};

const char* body_plan_name(BodyPlan plan);  // "biped", "quadruped", "bird", "snake", "many-legged"
Character synthesize(const SynthesizeOptions& options);

}  // namespace sinew
#endif
