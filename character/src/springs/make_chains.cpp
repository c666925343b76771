// SPDX-License-Identifier: MIT
// Joints along the lines of garments, and weights between them.
#include "sinew_character/springs/make_chains.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/error.hpp"
#include "springs/find_garments.hpp"

namespace sinew {
namespace {

// The body goes on holding a garment, as legs do a skirt: chains alone let legs through (trainer/configs/RESULTS.md). By how far down a vertex is.
constexpr double kHeld = 0.15;      // wholly above it
constexpr double kHemShare = 0.4;   // of the weight at the hem that chains have
constexpr float kLeastMade = 0.5f;  // certainty of a garment that gets chains

std::string word_of(SpringKind kind) { return kind == SpringKind::kSkirt ? "Skirt" : "Cape"; }

bool is_garment(SpringKind kind) {
  return kind == SpringKind::kSkirt || kind == SpringKind::kCape || kind == SpringKind::kHair ||
         kind == SpringKind::kLongHair;
}

// Lines of a ring begin at the front and go over the left; others go from left to right, an arc's too, whose gap is at the front.
std::string line_name(const Garment& garment, size_t line) {
  const std::string word = word_of(garment.kind);
  const size_t count = garment.lines.size();
  if (garment.ring) {
    if (line == 0) return word + "Front";
    if (2 * line == count) return word + "Back";
    return 2 * line < count ? "Left" + word + std::to_string(line) : "Right" + word + std::to_string(count - line);
  }
  if (2 * line + 1 == count) return word + "Back";
  return 2 * line + 1 < count ? "Left" + word + std::to_string(line + 1)
                              : "Right" + word + std::to_string(count - line);
}

// The weights of one vertex, by how far along the lines and how far down it is.
std::vector<Influence> row_between(const Garment& garment, size_t first_joint, const std::array<double, 2>& place,
                                   const std::vector<Influence>& before) {
  const size_t count = garment.lines.size(), rows = garment.lines[0].size() - 1;
  std::map<uint32_t, double> weights;
  const double along = std::floor(place[0]), share = place[0] - along;
  const size_t low = static_cast<size_t>(along) % count,
               high = garment.ring ? (low + 1) % count : std::min(low + 1, count - 1);
  // Bones hold their middles: half a bone below its top a vertex is the bone's alone.
  const double bones = place[1] * static_cast<double>(rows) - 0.5;
  const double floor = std::floor(bones), next = bones - floor;
  const auto add = [&](double bone, double weight) {
    if (!(weight > 0)) return;
    if (bone < 0) {
      for (const Influence& one : before) weights[one.joint] += weight * static_cast<double>(one.weight);
      return;
    }
    const size_t row = std::min(static_cast<size_t>(bone), rows - 1);
    weights[static_cast<uint32_t>(first_joint + low * rows + row)] += weight * (1 - share);
    weights[static_cast<uint32_t>(first_joint + high * rows + row)] += weight * share;
  };
  const double swings = kHemShare * std::clamp((place[1] - kHeld) / (1 - kHeld), 0.0, 1.0);
  add(-1, 1 - swings);
  add(floor, swings * (1 - next));
  add(floor + 1, swings * next);
  std::vector<Influence> out;
  for (const auto& [joint, weight] : weights)
    if (weight > 0) out.push_back({joint, static_cast<float>(weight)});
  return out;
}

void keep_largest(size_t count, std::vector<Influence>* row) {
  std::stable_sort(row->begin(), row->end(),
                   [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  if (row->size() > count) row->resize(count);
  double sum = 0;
  for (const Influence& one : *row) sum += static_cast<double>(one.weight);
  for (Influence& one : *row) one.weight = static_cast<float>(static_cast<double>(one.weight) / sum);
}

}  // namespace

std::vector<MadeChains> make_chains(size_t influence_count, Character* character) {
  std::vector<uint8_t> swings(character->joints.size(), 0);
  for (const FoundChain& found : find_springs(*character))
    if (found.kept)
      for (const SpringJoint& joint : found.chain.joints)
        swings[joint.joint] = is_garment(found.kind) ? kSwingsAsGarment : kSwings;
  std::vector<uint8_t> classes = joint_verdicts(character->joints, follows_of(*character)).classes;
  if (std::count(classes.begin(), classes.end(), SINEW_CLASS_THIGH) < 2)
    classes = limb_classes(map_rig_of(*character), character->up);
  std::set<std::string> names;
  for (const Joint& joint : character->joints) names.insert(joint.name);
  std::vector<MadeChains> out;
  for (const Garment& garment : find_garments(*character, classes, swings)) {
    if (garment.certainty < kLeastMade) continue;
    MadeChains made;
    made.kind = garment.kind;
    made.on = garment.on;
    made.chains = garment.lines.size();
    made.closed = garment.ring;
    made.certainty = garment.certainty;
    made.vertices = garment.vertices.size();
    const size_t first = character->joints.size(), rows = garment.lines[0].size() - 1;
    for (size_t line = 0; line < garment.lines.size(); ++line)
      for (size_t row = 0; row < rows; ++row) {
        const std::string base = line_name(garment, line) + "_" + std::to_string(row + 1);
        std::string name = base;
        for (size_t twin = 2; !names.insert(name).second; ++twin) name = base + "_" + std::to_string(twin);
        const size_t parent = row == 0 ? garment.parents[line] : character->joints.size() - 1;
        character->joints.push_back({name, to_vec3(garment.lines[line][row]), static_cast<int>(parent), true});
      }
    made.joints = character->joints.size() - first;
    for (size_t i = 0; i < garment.vertices.size(); ++i) {
      std::vector<Influence>& row = character->influences[garment.vertices[i]];
      row = row_between(garment, first, garment.coordinates[i], row);
      keep_largest(influence_count, &row);
    }
    out.push_back(made);
  }
  return out;
}

std::string made_chains_text(const MadeChains& made, const std::vector<Joint>& joints) {
  return "laid " + std::to_string(made.chains) + " chains of " + std::to_string(made.joints / made.chains) +
         " joints into what is taken for a " + spring_kind_text(made.kind) + ", on " + joints[made.on].name + "; " +
         std::to_string(made.vertices) + " vertices follow them (certainty " +
         std::to_string(std::lround(100 * static_cast<double>(made.certainty))) + " %)";
}

}  // namespace sinew
