// SPDX-License-Identifier: MIT
// Characters of our own with exact ground truth: smooth-union bodies polygonised into closed meshes, with clothing and
// floating parts.
#ifndef SINEW_DATA_SETS_SYNTHESIZE_HPP
#define SINEW_DATA_SETS_SYNTHESIZE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

enum class BodyPlan {
  kBiped,
  kQuadruped,
  kBird,
  kSnake,
  kManyLegged,
  kDinosaur,
  kFish,
  kBlob,
  kBeast,
  kToy,
  kFowl,
  kCrawler,
  kMascot
};

// Characters as artists make them, with clothes: what weights are learned from.
constexpr BodyPlan kBodyPlans[] = {BodyPlan::kBiped, BodyPlan::kQuadruped, BodyPlan::kBird, BodyPlan::kSnake,
                                   BodyPlan::kManyLegged};

// Creatures of every proportion, a smooth skin or a rigid part for every bone: what skeletons are learned from besides.
//   dinosaur   two legs, level or upright, big tail and head, small arms
//   fish       flippers, and a tail that most often ends in a fin
//   blob       head and body about one, short legs, stubby arms
//   beast      four legs, from short-legged to tall, necks, ears and tails of any length
//   toy        upright, big head, short or long legs: robots, cartoon people
//   fowl       two legs and wings
//   crawler    1 to 4 pairs of legs and another in front, or claws
//   mascot     a head of half the height, stubby limbs; pigtails, long ears, wings, a big tail: chibi, plush
constexpr BodyPlan kCreaturePlans[] = {BodyPlan::kDinosaur, BodyPlan::kFish, BodyPlan::kBlob,    BodyPlan::kBeast,
                                       BodyPlan::kToy,      BodyPlan::kFowl, BodyPlan::kCrawler, BodyPlan::kMascot};

struct SynthesizeOptions {
  BodyPlan plan = BodyPlan::kBiped;
  uint64_t seed = 1;     // the same seed gives the same character on every machine
  int resolution = 48;   // cells along the longest side
  bool clothing = true;  // open shells, capes, hats, floating parts, bodies of rigid parts
};

const char* body_plan_name(BodyPlan plan);  // "biped", ..., "many-legged", "dinosaur", ..., "mascot"
Character synthesize(const SynthesizeOptions& options);

}  // namespace sinew
#endif
