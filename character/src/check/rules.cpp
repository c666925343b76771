// SPDX-License-Identifier: MIT
// The table of rules. A rule is a row here and a call of Findings::add() with its name. Bounds were chosen on
// families of train with `sinew-lab eval check`, without val and val2.
#include "sinew_character/check/check.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr CheckSeverity kNote = CheckSeverity::kNote, kWarning = CheckSeverity::kWarning,
                        kError = CheckSeverity::kError;

const std::vector<CheckRule> kRules = {
    // name, severity, cheap, bound, value, title, cure
    {"unweighted", kError, true, 0, "vertices", "Vertices without weight stay behind",
     "bind them with sinew bind, or paint them"},
    {"weight-sum", kWarning, true, 0.02, "largest difference of a sum from 1",
     "Weights that do not sum to 1 shrink or stretch the mesh", "normalize the weights"},
    {"influences", kNote, true, 0.15, "weight beyond a vertex's four strongest joints",
     "Programs with four joints per vertex drop weight", "limit the joints per vertex: sinew bind --influences 4"},
    {"speck", kWarning, true, 0, "vertices", "Single vertices differ from all their neighbors",
     "smooth the weights there"},
    {"far-weight", kWarning, true, 0, "vertices", "Weight for a joint across the body",
     "remove the weight, or bind again with sinew bind"},
    {"left-right", kError, true, 0, "vertices", "Weight for the joint of the other side",
     "mirror the weights from the correct side"},
    {"leak", kWarning, true, 0.45, "largest weight",
     "Weight of a joint on an island apart from everything else it moves",
     "remove the weight there; sinew bind finds fused parts"},
    {"crack", kWarning, true, 0.3, "difference of the weights",
     "Edges at one position have different weights and come apart",
     "weld the vertices, or give both sides the same weights"},
    {"skeleton-apart", kError, true, 0, "1", "The skeleton is not inside the mesh",
     "move it there with sinew bind --fit"},
    {"joint-outside", kWarning, true, 0.1, "distance from what it moves, of the size", "A joint is outside the body",
     "move the joint into the limb"},
    {"zero-length", kWarning, true, 0, "1", "A bone without length",
     "move one of the two joints, or remove one with sinew simplify"},
    {"dead-joint", kWarning, true, 0, "1", "A joint of the body moves nothing",
     "give it nearby weights with sinew bind"},
    {"sides", kError, true, 0, "joints", "Joints called left are on the right side",
     "rename the joints: left is the character's own"},
    {"name-order", kError, true, 0, "1; 2: on another limb", "A joint's name does not fit its parent or children",
     "rename the joint, or change its parent"},
    {"name-place", kWarning, true, 0.5, "share of the limbs", "Joints are in other limbs than their names say",
     "rename the joints; sinew map shows what they are"},
    {"unlike-joints", kWarning, true, 0.03, "distance from the mirror image, of the size",
     "A joint is not at the mirror image of its twin", "mirror the joint"},
    {"unlike-weights", kWarning, true, 0.2, "share of the joint's vertices", "Mirrored vertices have different weights",
     "mirror the weights with sinew bind --symmetric"},
    {"bind-matrices", kError, true, 0.02, "distance, of the size", "Inverse bind matrices disagree with each other",
     "set the bind pose again and export"},
    {"exploded-rest", kError, true, 0.03, "share of edges that are twice or half as long",
     "The mesh is distorted in the file's rest pose", "set the bind pose again, or export at rest"},
    {"mirrored-scale", kError, true, 0, "joints", "Joints have a negative scale", "apply the scale before export"},
    {"uneven-scale", kWarning, true, 1.05, "ratio of the scales", "Joints have a nonuniform scale",
     "apply the scale before export"},
    {"scaled-skin", kWarning, true, 1.05, "the scale, or 1 over it", "A node above the skeleton has a scale",
     "apply the scale before export; programs treat its children differently"},
    {"unused-skin", kWarning, true, 0, "skins", "Skins without a mesh",
     "delete the unused skeleton; sinew rig leaves it out"},
    {"stray-mesh", kWarning, true, 0, "meshes", "Meshes without a parent joint do not move with the character",
     "delete helpers, or bind the parts of the character"},
    {"springs-broken", kError, true, 0, "1", "Springs refer to missing nodes, or have parameters out of range",
     "find them again with sinew springs --replace"},
    {"springs-shared", kError, true, 0, "1", "Two chains of springs rotate one joint",
     "leave one out with sinew springs --drop"},
    {"springs-inside", kWarning, true, 0.02, "depth, of the radius", "A spring starts inside a collider",
     "shrink the collider or the hit radius, or use sinew springs --replace"},
    {"springs-skinless", kNote, true, 0, "1", "No vertex follows a chain of springs",
     "leave it out, or bind the mesh to it"},
    {"tear", kError, false, 0.02, "share of the joint's edges", "The mesh tears in a test pose",
     "smooth the weights between the two joints"},
    {"lost-volume", kWarning, false, 0.85, "lost share of the bend's volume", "A bend collapses in a test pose",
     "bind again, or keep the volume with sinew bake"},
    {"flip", kWarning, false, 0.6, "share of the bend's surface", "Faces are inverted in a test pose",
     "smooth the weights there"},
    {"crossing", kNote, false, 0.5, "share of the faces", "Parts pass through each other in a test pose",
     "check the weights there, or the limits of the joint"},
    {"foot-slide", kWarning, true, 0.1, "of the height, per second", "A foot slides while it is planted",
     "sinew animate keeps contacts"},
    {"foot-float", kWarning, true, 0.05, "of the height", "No foot reaches the floor", "lower the root"},
    {"foot-sink", kWarning, true, 0.03, "of the height", "A foot sinks through the floor", "raise the root"},
    {"clip-flip", kError, true, 90, "degrees", "A joint flips from one frame to the next",
     "check the keys: two of them express one rotation differently"},
    {"clip-jump", kWarning, true, 0.1, "of the height", "A joint jumps from one frame to the next",
     "check the keys around that frame"},
};

}  // namespace

const std::vector<CheckRule>& check_rules() { return kRules; }

const CheckRule& check_rule(const std::string& name) {
  std::string known;
  for (const CheckRule& rule : kRules) {
    if (rule.name == name) return rule;
    known += (known.empty() ? "" : ", ") + std::string(rule.name);
  }
  throw Error("unknown rule " + name + "; expected one of " + known);
}

const char* severity_text(CheckSeverity severity) {
  return severity == kError ? "error" : severity == kWarning ? "warning" : "note";
}

}  // namespace sinew
