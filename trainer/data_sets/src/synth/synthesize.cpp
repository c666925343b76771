// SPDX-License-Identifier: MIT
// Characters of our own with exact ground truth: blueprint, polygonised body, clothes and parts, rounded and named.
#include "sinew_data_sets/synthesize.hpp"

#include "sinew_formats/error.hpp"
#include "synth/blueprint.hpp"
#include "synth/surface.hpp"

namespace sinew {

const char* body_plan_name(BodyPlan plan) {
  switch (plan) {
    case BodyPlan::kBiped:
      return "biped";
    case BodyPlan::kQuadruped:
      return "quadruped";
    case BodyPlan::kBird:
      return "bird";
    case BodyPlan::kSnake:
      return "snake";
    case BodyPlan::kManyLegged:
      return "many-legged";
    case BodyPlan::kDinosaur:
      return "dinosaur";
    case BodyPlan::kFish:
      return "fish";
    case BodyPlan::kBlob:
      return "blob";
    case BodyPlan::kBeast:
      return "beast";
    case BodyPlan::kToy:
      return "toy";
    case BodyPlan::kFowl:
      return "fowl";
    case BodyPlan::kCrawler:
      return "crawler";
    case BodyPlan::kMascot:
      return "mascot";
  }
  return "biped";
}

namespace {

// Short decimals keep the text files small; 1e-5 of two units is far below a voxel.
float rounded(double v) {
  const double scaled = v * 1e5;
  const auto whole = static_cast<int64_t>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
  return static_cast<float>(static_cast<double>(whole) / 1e5);
}
Vec3 rounded(synth::Point p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

void take(const synth::Surface& surface, Character* character) {
  const uint32_t base = static_cast<uint32_t>(character->vertices.size());
  for (const synth::Point& p : surface.positions) character->vertices.push_back(rounded(p));
  for (const std::vector<uint32_t>& face : surface.faces) {
    for (uint32_t v : face) character->face_vertices.push_back(base + v);
    character->face_offsets.push_back(static_cast<uint32_t>(character->face_vertices.size()));
  }
  character->influences.insert(character->influences.end(), surface.influences.begin(), surface.influences.end());
}

// The plan is mixed into the seed, so that seed 1 of two plans does not share its draws.
synth::Random random_of(const SynthesizeOptions& options) {
  const uint64_t plan = static_cast<uint64_t>(options.plan), first = static_cast<uint64_t>(kCreaturePlans[0]);
  return synth::Random(plan < first ? options.seed * 8 + plan : (options.seed * 8 + plan - first) * 8 + first);
}

synth::Surface rigid_surface(const synth::Blueprint& plan, synth::Random* random) {
  return plan.build == synth::Build::kCapsules ? synth::capsule_body(plan, random->integer(6, 12))
                                               : synth::rigid_body(plan, random);
}

}  // namespace

Character synthesize(const SynthesizeOptions& options) {
  if (options.resolution < 24 || options.resolution > 256) {
    throw Error("synthesize: resolution " + std::to_string(options.resolution) + " is outside 24..256");
  }
  synth::Random random = random_of(options);
  synth::Blueprint plan = synth::make_blueprint(options.plan, options.resolution, &random);
  const bool end_markers = random.chance(0.4);
  if (options.clothing && random.chance(0.12)) plan.build = synth::Build::kBoxes;
  const bool rigid = options.clothing && plan.build != synth::Build::kSmooth;

  Character character;
  std::string digits = std::to_string(options.seed);
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  character.name = std::string(body_plan_name(options.plan)) + "__" + digits;

  if (rigid) {
    take(rigid_surface(plan, &random), &character);
    take(synth::eyes(plan, &random), &character);
  } else {
    const synth::Surface body = synth::polygonise(plan);
    take(body, &character);
    if (options.clothing) {
      take(synth::eyes(plan, &random), &character);
      take(synth::dress(plan, body, options.plan, &random), &character);
    }
  }

  std::vector<bool> leaf(plan.joints.size(), true);
  for (const synth::PlanJoint& joint : plan.joints) {
    if (joint.parent >= 0) leaf[static_cast<size_t>(joint.parent)] = false;
  }
  for (const synth::PlanJoint& joint : plan.joints)
    character.joints.push_back({joint.name, rounded(joint.position), joint.parent});
  if (end_markers) {
    for (size_t j = 0; j < plan.joints.size(); ++j) {
      if (!leaf[j] || !plan.joints[j].has_tip) continue;
      character.joints.push_back({plan.joints[j].name + "_end", rounded(plan.joints[j].tip), static_cast<int>(j)});
    }
  }
  return character;
}

}  // namespace sinew
