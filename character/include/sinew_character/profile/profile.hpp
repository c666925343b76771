// SPDX-License-Identifier: MIT
// What a program wants of a character: --for mixamo, unreal, vrm, ... A profile is a row of the table in profile/profiles.cpp.
#ifndef SINEW_CHARACTER_PROFILE_HPP
#define SINEW_CHARACTER_PROFILE_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew/names.h"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/document_form.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"

namespace sinew {

// Parts of a body whose joints have axes of their own in a convention.
enum class AxesPart : uint8_t {
  kTrunk,  // pelvis to head
  kClavicle,
  kUpperArm,
  kForearm,
  kHand,
  kFinger,
  kThumb,
  kThigh,
  kCalf,
  kFoot,
  kToe
};
constexpr size_t kAxesParts = 11;

// Where x, y and z of a joint point in the T pose, in letters: Left, Right, Up, Down, Front, Back of the body.
struct PartAxes {
  const char *left, *right;  // of a joint on the left and in the middle, on the right
  const char*
      bone;  // where the bone points then: a letter, O away from the body; small: only its direction along the floor counts
};
using AxesTable = std::array<PartAxes, kAxesParts>;

// How joints are called.
struct ProfileNames {
  int naming = -1;             // sinew_naming, -1: as they are
  const char* without = "";    // a prefix that is left out
  bool capital = false;        // the first letter is made one
  bool older_thumb = false;    // Proximal, Intermediate, Distal where VRM 1.0 has Metacarpal, Proximal, Distal
  const char* forbidden = "";  // letters that names cannot have
};

struct Profile {
  const char* name;       // "vrm"
  const char* about;      // one line
  const char* container;  // extension of a file that is not named
  const char* pose;       // rest pose: "t", "a", "" as it stands
  uint32_t influences;    // most joints a vertex, 0 = any number
  ProfileNames names;
  const char* root;       // a joint on the floor above all others; "": none is wanted
  const AxesTable* axes;  // null: those of the world
  bool faces_back;        // -z, else +z
  int vrm;                // 10: VRM 1.0, 1: VRM 0.x, 0: none
};
const std::vector<Profile>& profiles();
// Throws Error that lists them.
const Profile& profile_named(const std::string& name);

// Humanoid bones of VRM 1.0 for each joint [J], "" for none: by the classes of names, of chains the parts that a VRM has. Throws Error with
// one line that lists the required bones that are missing.
std::vector<std::string> vrm_bones(const std::vector<Joint>& joints, const std::string& name, bool zero = false);

// [J] names by the profile: standard ones where the convention has one for a joint, its own elsewhere; unique.
std::vector<std::string> profile_names(const std::vector<Joint>& joints, const ProfileNames& names);

// Left, up and front of a body as columns, each along an axis of the world, by sides that names tell and by legs; y up and +z front where they
// do not tell.
Rotation body_axes(const std::vector<Joint>& joints);

// [J] axes of joints that stand with y up and face +z, as columns. The roll rule: the axes that `table` has for the joint's part in the T pose,
// turned the shortest way with the bone from where it points there to where it points here; half a turn goes about the front. A bone points to
// the next joint of its limb, of a hand to the middle finger or amid the fingers, else to its end, else on as its parent's does. A joint of no part
// (tail, wing, ear, hair, what has no name) has its parent's axes, turned in the same way from the parent's bone to its own; eyes, jaw
// and what ends a bone its parent's as they are, a root the upright body's. The same skeleton has the same axes everywhere up to rounding.
std::vector<Rotation> joint_axes(const std::vector<Joint>& joints, const AxesTable& table);

struct ProfileOptions {
  std::vector<std::string> authors;  // empty: those of a VRM's file, else "unknown"
  std::string title;                 // empty: the file's, else the character's name
  std::string license;     // as parse_vrm_license() has it; what it does not say is the file's, else not allowed
  bool keep_axes = false;  // the skeleton stays: axes, names and roots
  bool controls = false;   // a glTF's extras say which joints controls hang on: controls.hpp
};
// What can be said before work starts: throws Error where the profile needs more than `options` has.
void check_profile(const Profile& profile, const ProfileOptions& options);
// As write_character(), in the profile's form: poses stay, of each vertex the strongest influences. A body that faces elsewhere or stands with
// z up is turned. Returns remarks for the user, a line each. Throws Error; the target is as it was then.
std::vector<std::string> write_for_profile(const Profile& profile, const ProfileOptions& options,
                                           const std::string& path, const Character& character,
                                           const GlbOptions& glb = {}, const Morphs& morphs = {});
// What ProfileOptions::controls puts into extras: controls_text() of the skeleton as it is written.
std::string controls_for_profile(const Profile& profile, const ProfileOptions& options, const Character& character);

}  // namespace sinew
#endif
