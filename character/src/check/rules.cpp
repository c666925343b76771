// SPDX-License-Identifier: MIT
// The one table of what is looked for. A rule is a row here and the call of Findings::add() that names it.
// Bounds were chosen on families of train with `sinew-lab eval check`; no family of val or val2 was looked at.
#include "sinew_character/check/check.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr CheckSeverity kNote = CheckSeverity::kNote, kWarning = CheckSeverity::kWarning,
                        kError = CheckSeverity::kError;

const std::vector<CheckRule> kRules = {
    // name, severity, cheap, bound, value, title, cure
    {"unweighted", kError, true, 0, "vertices", "Vertices without weight stay behind",
     "bind them: sinew bind, or paint them"},
    {"weight-sum", kWarning, true, 0.02, "largest difference of a sum from 1",
     "Weights that do not add up to 1 shrink or stretch the mesh", "normalise the weights"},
    {"influences", kNote, true, 0.15, "weight beyond a vertex's four strongest joints",
     "Programs that take four joints a vertex cut weight off",
     "limit the joints per vertex: sinew bind --influences 4"},
    {"speck", kWarning, true, 0, "vertices", "Single vertices follow something else than all around them",
     "smooth the weights there"},
    {"far-weight", kWarning, true, 0, "vertices", "Weight for a joint across the body",
     "take the weight away, or bind again with sinew bind"},
    {"left-right", kError, true, 0, "vertices", "Weight for the joint of the other side",
     "mirror the weights from the side that is right"},
    {"leak", kWarning, true, 0.45, "largest weight", "Weight of a joint on an island apart from all else that it moves",
     "take the weight away there; sinew bind finds where parts have grown together"},
    {"crack", kWarning, true, 0.3, "difference of the weights",
     "Edges at one place have different weights and come apart",
     "weld the vertices, or give both sides the same weights"},
    {"skeleton-apart", kError, true, 0, "1", "The skeleton does not lie in the mesh",
     "sinew bind --fit brings it there"},
    {"joint-outside", kWarning, true, 0.1, "distance from what it moves, of the size", "A joint lies out of the body",
     "move the joint into the limb"},
    {"zero-length", kWarning, true, 0, "1", "A bone without length",
     "move one of the two joints, or leave one out: sinew simplify"},
    {"dead-joint", kWarning, true, 0, "1", "A joint of the body moves nothing",
     "give it the weights around it: sinew bind"},
    {"sides", kError, true, 0, "joints", "Joints called left lie on the right side",
     "rename the joints: left is the character's own"},
    {"name-order", kError, true, 0, "1; 2: on another limb", "A joint's name does not go with what it hangs on",
     "rename the joint, or hang it where it belongs"},
    {"name-place", kWarning, true, 0.5, "share of the limbs", "Joints lie where their names do not say",
     "rename the joints: sinew map shows what they are"},
    {"unlike-joints", kWarning, true, 0.03, "distance from the mirror image, of the size",
     "A joint is not where its twin's mirror image is", "mirror the joint"},
    {"unlike-weights", kWarning, true, 0.2, "share of the joint's vertices", "Mirrored vertices have other weights",
     "mirror the weights: sinew bind --symmetric"},
    {"bind-matrices", kError, true, 0.02, "distance, of the size", "Inverse bind matrices disagree with each other",
     "set the bind pose again and export"},
    {"exploded-rest", kError, true, 0.03, "share of edges that are twice or half as long",
     "The mesh is torn as the file shows it", "set the bind pose again, or export at rest"},
    {"mirrored-scale", kError, true, 0, "joints", "Joints are scaled by a negative number",
     "apply the scale before export"},
    {"uneven-scale", kWarning, true, 1.05, "ratio of the scales", "Joints are scaled unevenly",
     "apply the scale before export"},
    {"scaled-skin", kWarning, true, 1.05, "the scale, or 1 over it", "A node above the skeleton is scaled",
     "apply the scale before export: programs disagree about what hangs below it"},
    {"unused-skin", kWarning, true, 0, "skins", "Skins that no mesh has",
     "delete the skeleton that is left over; sinew rig leaves it out"},
    {"stray-mesh", kWarning, true, 0, "meshes", "Meshes that hang on nothing stay behind when the character moves",
     "delete helpers, or bind what belongs to the character"},
    {"springs-broken", kError, true, 0, "1", "Springs name what is not there, or have numbers out of their range",
     "write them again: sinew springs --replace"},
    {"springs-shared", kError, true, 0, "1", "Two chains of springs turn one joint",
     "leave one out: sinew springs --drop"},
    {"springs-inside", kWarning, true, 0.02, "depth, of the radius", "A spring begins in a collider",
     "make the collider or the hit radius smaller: sinew springs --replace"},
    {"springs-skinless", kNote, true, 0, "1", "Nothing follows a chain of springs",
     "leave it out, or bind the mesh to it"},
    {"tear", kError, false, 0.02, "share of the joint's edges", "The mesh tears in a test pose",
     "smooth the weights between the two joints"},
    {"lost-volume", kWarning, false, 0.85, "share of the bend's volume that goes", "A bend collapses in a test pose",
     "bind again, or keep the volume: sinew bake"},
    {"flip", kWarning, false, 0.6, "share of the bend's surface", "Faces turn inside out in a test pose",
     "smooth the weights there"},
    {"crossing", kNote, false, 0.5, "share of the faces", "Parts go through each other in a test pose",
     "look at the weights there, or at the limits of the joint"},
    {"foot-slide", kWarning, true, 0.1, "of the height, a second", "A foot slides while it stands",
     "sinew animate keeps contacts"},
    {"foot-float", kWarning, true, 0.05, "of the height", "No foot reaches the floor", "lower the root"},
    {"foot-sink", kWarning, true, 0.03, "of the height", "A foot goes through the floor", "raise the root"},
    {"clip-flip", kError, true, 90, "degrees", "A joint turns over from one frame to the next",
     "look at the keys: two of them are one rotation told in two ways"},
    {"clip-jump", kWarning, true, 0.1, "of the height", "A joint jumps from one frame to the next",
     "look at the keys around that frame"},
};

}  // namespace

const std::vector<CheckRule>& check_rules() { return kRules; }

const CheckRule& check_rule(const std::string& name) {
  std::string known;
  for (const CheckRule& rule : kRules) {
    if (rule.name == name) return rule;
    known += (known.empty() ? "" : ", ") + std::string(rule.name);
  }
  throw Error("no rule is called " + name + "; there are " + known);
}

const char* severity_text(CheckSeverity severity) {
  return severity == kError ? "error" : severity == kWarning ? "warning" : "note";
}

}  // namespace sinew
