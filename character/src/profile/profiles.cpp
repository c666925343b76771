// SPDX-License-Identifier: MIT
// The table of profiles. To add one: a row here, with where its conventions are written down, and a row in the README.
#include "sinew_character/profile/profile.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// In the order of AxesPart. Mixamo's characters, by rest rotations that its auto-rigger writes (github.com/DaveDubUK/walkTools,
// mixamo-pre-rotations.js, has them as Euler angles of the FBX; fingers and thumbs are not in it and go with the hand): +y along the bone, knees
// and elbows bend about x and z.
constexpr AxesTable kMixamoAxes = {{{"LUF", "LUF", "U"},
                                    {"BLD", "FRD", "O"},
                                    {"BLD", "FRD", "O"},
                                    {"BLD", "FRD", "O"},
                                    {"BLD", "FRD", "O"},
                                    {"BLD", "FRD", "O"},
                                    {"BLD", "FRD", "O"},
                                    {"RDF", "RDF", "D"},
                                    {"RDF", "RDF", "D"},
                                    {"RFU", "RFU", "F"},
                                    {"RFU", "RFU", "F"}}};

// Unreal's mannequin, as its skeleton comes out of a glTF or FBX (right-handed): x along the bone on the left arm, trunk and right leg, against it
// on the other side, which is mirrored by behavior as Maya does it; a foot keeps the leg's axes. Thumbs go with the hand here.
constexpr AxesTable kUnrealAxes = {{{"UBR", "UBR", "U"},
                                    {"LBU", "LFD", "O"},
                                    {"LBU", "LFD", "O"},
                                    {"LBU", "LFD", "O"},
                                    {"LDB", "LUF", "O"},
                                    {"LDB", "LUF", "O"},
                                    {"LDB", "LUF", "O"},
                                    {"UBR", "DFR", "D"},
                                    {"UBR", "DFR", "D"},
                                    {"UBR", "DFR", "f"},
                                    {"FUR", "BDR", "F"}}};

// github.com/godotengine/godot, scene/resources/skeleton_profile.cpp, reference poses of SkeletonProfileHumanoid.
constexpr AxesTable kGodotAxes = {{{"LUF", "LUF", "U"},
                                   {"FLU", "BRU", "O"},
                                   {"BLD", "FRD", "O"},
                                   {"DLF", "URF", "O"},
                                   {"BLD", "FRD", "O"},
                                   {"BLD", "FRD", "O"},
                                   {"UFL", "DFR", "F"},
                                   {"RDF", "RDF", "D"},
                                   {"LDB", "LDB", "D"},
                                   {"RFU", "RFU", "F"},
                                   {"LFD", "LFD", "F"}}};

constexpr const char* kGlb = ".glb";
constexpr const char* kVrm = ".vrm";
constexpr const char* kFbx = ".fbx";

}  // namespace

const std::vector<Profile>& profiles() {
  static const std::vector<Profile> kProfiles = {
      // Names and axes as above; helpx.adobe.com, Mixamo FAQ: T pose. FBX in centimeters.
      {"mixamo",
       "Mixamo: mixamorig: names, bones along +y, T pose",
       kFbx,
       "t",
       4,
       {SINEW_NAMING_MIXAMO},
       "",
       &kMixamoAxes,
       false,
       0},
      // dev.epicgames.com, Epic skeleton: names, root at the origin, A pose; eight influences unless a project allows more.
      {"unreal",
       "Unreal: the mannequin's names, root bone and +x axes, A pose",
       kFbx,
       "a",
       8,
       {SINEW_NAMING_UNREAL},
       "root",
       &kUnrealAxes,
       false,
       0},
      // docs.unity3d.com, HumanBodyBones: names; Mecanim reads any axes, wants a T pose and has four influences by default.
      {"unity",
       "Unity: HumanBodyBones names, world axes, T pose",
       kFbx,
       "t",
       4,
       {SINEW_NAMING_VRM, "", true, true},
       "",
       nullptr,
       false,
       0},
      // github.com/vrm-c/vrm-specification, specification/VRMC_vrm-1.0. Axes are free in 1.0; those of the world suit readers of both versions.
      {"vrm",
       "VRM 1.0: humanoid map, author and license, T pose",
       kVrm,
       "t",
       4,
       {SINEW_NAMING_VRM},
       "",
       nullptr,
       false,
       10},
      // The same, specification/0.0, VRM rules: T pose, faces -z, no rotation and no scale of bones.
      {"vrm0", "VRM 0.x: the same, facing -z", kVrm, "t", 4, {SINEW_NAMING_VRM, "", false, true}, "", nullptr, true, 1},
      // docs.blender.org, Rigify, Basic human meta-rig: names; a bone is its y axis. Rolls are Mixamo's, Blender has none of its own.
      {"blender",
       "Blender: Rigify's names with .L and .R, bones along +y",
       kGlb,
       "",
       0,
       {SINEW_NAMING_RIGIFY, "DEF-"},
       "",
       &kMixamoAxes,
       false,
       0},
      // docs.godotengine.org, SkeletonProfileHumanoid: names, Root, reference pose.
      {"godot",
       "Godot 4: SkeletonProfileHumanoid's names, axes, Root and T pose",
       kGlb,
       "t",
       8,
       {SINEW_NAMING_VRM, "", true},
       "Root",
       &kGodotAxes,
       false,
       0},
      // threejs.org, PropertyBinding: letters that a node's name cannot have; skinning has four influences.
      {"three",
       "three.js: four influences, names that its animations can bind to",
       kGlb,
       "",
       4,
       {-1, "", false, false, "[].:/\\ "},
       "",
       nullptr,
       false,
       0},
      // help.autodesk.com, HumanIK character structure: names, T stance along x; joints point along x. Axes are the mannequin's, HumanIK reads any.
      {"maya",
       "Maya: HumanIK's names, joints along x, T pose",
       kFbx,
       "t",
       0,
       {SINEW_NAMING_MIXAMO, "mixamorig:"},
       "",
       &kUnrealAxes,
       false,
       0},
  };
  return kProfiles;
}

const Profile& profile_named(const std::string& name) {
  std::string known;
  for (const Profile& one : profiles()) {
    if (one.name == name) return one;
    known += (known.empty() ? "" : ", ") + std::string(one.name);
  }
  throw Error("unknown profile " + name + "; expected one of " + known);
}

}  // namespace sinew
