// SPDX-License-Identifier: MIT
// Requirements of a program for a character: --for mixamo, unreal, vrm, ... A profile is a row of the table in
// profile/profiles.cpp.
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

// Parts of a body whose joints have specific axes in a convention.
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

// Directions of a joint's x, y and z axes in the T pose, in letters: Left, Right, Up, Down, Front, Back of the body.
struct PartAxes {
  const char *left, *right;  // for a joint on the left or in the middle, and on the right
  const char*
      bone;  // direction of the bone in the T pose: a letter, O away from the body; lower case: only its horizontal direction counts
};
using AxesTable = std::array<PartAxes, kAxesParts>;

// Names of joints.
struct ProfileNames {
  int naming = -1;             // sinew_naming, -1: unchanged
  const char* without = "";    // prefix to remove
  bool capital = false;        // capitalize the first letter
  bool older_thumb = false;    // Proximal, Intermediate, Distal where VRM 1.0 has Metacarpal, Proximal, Distal
  const char* forbidden = "";  // characters that names must not contain
};

struct Profile {
  const char* name;       // "vrm"
  const char* about;      // one line
  const char* container;  // default extension
  const char* pose;       // rest pose: "t", "a", "" unchanged
  uint32_t influences;    // maximum number of joints per vertex, 0 = any number
  ProfileNames names;
  const char* root;       // name of a root joint on the floor; "": none
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

// Returns [J] unique names by the profile: standard names if the convention has one for a joint, else its own name.
std::vector<std::string> profile_names(const std::vector<Joint>& joints, const ProfileNames& names);

// Returns left, up and front of a body as columns, each along a world axis, from sides in names and from legs; y up
// and +z front if unknown.
Rotation body_axes(const std::vector<Joint>& joints);

// Returns [J] axes of joints with y up and facing +z, as columns. The roll rule: the axes in `table` for the joint's
// part in the T pose are rotated along the shortest arc from the bone's direction there to its direction here; a
// rotation by 180 degrees is about the front. A bone points to the next joint of its limb, for a hand to the middle
// finger or the center of the fingers, else to its end, else in the direction of its parent. A joint outside these
// parts (tail, wing, ear, hair, unnamed) has its parent's axes, rotated likewise from the parent's bone to its own;
// eyes, jaw and bone ends have their parent's axes unchanged, a root those of the upright body. The same skeleton has
// the same axes on every machine up to rounding.
std::vector<Rotation> joint_axes(const std::vector<Joint>& joints, const AxesTable& table);

struct ProfileOptions {
  std::vector<std::string> authors;  // empty: those of a VRM's file, else "unknown"
  std::string title;                 // empty: the file's, else the character's name
  std::string license;     // as in parse_vrm_license(); missing permissions are those of the file, else denied
  bool keep_axes = false;  // keeps axes, names and roots of the skeleton
  bool controls = false;   // stores the joints of controls in a glTF's extras: controls.hpp
};
// Validates options before the job starts: throws Error if the profile needs more than `options` has.
void check_profile(const Profile& profile, const ProfileOptions& options);
// Writes like write_character() in the profile's form: poses are kept, each vertex keeps its strongest influences,
// and a body with another front or z up is rotated. Returns notes for the user, one line each. Throws Error and then
// leaves the target unchanged.
std::vector<std::string> write_for_profile(const Profile& profile, const ProfileOptions& options,
                                           const std::string& path, const Character& character,
                                           const GlbOptions& glb = {}, const Morphs& morphs = {});
// Returns the extras for ProfileOptions::controls: controls_text() of the written skeleton.
std::string controls_for_profile(const Profile& profile, const ProfileOptions& options, const Character& character);

}  // namespace sinew
#endif
