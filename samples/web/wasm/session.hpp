// SPDX-License-Identifier: MIT
// What the page's module holds: models, and one character with its skeletons, weights and pose.
#ifndef SINEW_WEB_SESSION_HPP
#define SINEW_WEB_SESSION_HPP

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rigs.hpp"
#include "sinew/sinew.h"
#include "sinew_character/bind/seams.hpp"
#include "sinew_character/jobs/picture_job.hpp"
#include "sinew_character/models/models.hpp"
#include "sinew_character/style/style.hpp"
#include "skinning.hpp"
#include "surface.hpp"
#include "swinging.hpp"

namespace sinew::web {

// What a bind of the character gives and pictures, poses and files show.
struct Rows {
  std::vector<std::vector<Influence>> influences;  // [V]
  std::vector<uint8_t> confidence;                 // [V]
};

// All that undo brings back of a character in the module. Rows are there where some are locked or painted, which the bind began with.
struct Kept {
  uint32_t number = 0;  // the character's
  Rig rig;
  std::vector<std::vector<Influence>> rows;  // [V] or empty
  std::vector<uint8_t> locked, hints;        // [V] or empty
  std::shared_ptr<const PictureCharacter> picture;
};

// Of a character that is shown in another rest pose, or flat: how it stands in its file, or round, which binds and edits are of.
struct Stance {
  std::vector<Vec3> vertices, corner_normals;
  std::vector<Joint> joints;
  std::shared_ptr<const GltfSource> gltf;
};

struct Session {
  std::unique_ptr<LoadedModel> bind_model, rig_model, hands_model, front_model;  // null: not fetched
  Character character;                                                           // with the joints of rigs().now()
  std::map<uint32_t, Rigs> rigs_of;              // of all characters that are open, by the page's numbers
  std::map<uint32_t, std::string> placement_of;  // of the same, as JSON
  // Of those that are of pictures, without their meshes.
  std::map<uint32_t, std::shared_ptr<const PictureCharacter>> pictures_of;
  uint32_t number = 0;            // the character's
  std::map<uint32_t, Kept> kept;  // by the page's numbers
  Style style;                    // for the next characters
  Skinning skinning;
  std::optional<LiveSprings> live;                           // while the character is dragged
  std::shared_ptr<const PictureCharacter> picture() const {  // null: the character is of none
    const auto found = pictures_of.find(number);
    return found == pictures_of.end() ? nullptr : found->second;
  }
  Rigs& rigs() { return rigs_of[number]; }
  const Rigs& rigs() const { return rigs_of.at(number); }
  Surface surface;
  std::optional<Stance> standing;                 // there is one while `character` is in the pose `to_pose`, or flat
  std::string to_pose;                            // of the last bind: "t", "a", "" as it stands
  Axis up_axis = Axis::kY;                        // of the last bind
  Seams seams;                                    // of the last bind
  std::vector<float> rest;                        // [V x 3]
  uint32_t slots = 4;                             // influences a vertex keeps
  std::vector<uint16_t> joints, weights;          // [V x slots]
  std::vector<std::vector<Influence>> reference;  // [V] of the file, or empty
  std::vector<uint8_t> locked, hints;             // [V] or empty: rows that the next bind keeps, see BindOptions
  std::vector<std::vector<Influence>> began;  // [V] or empty: rows that the last bind began with, where it kept some
  std::vector<uint8_t> confidence;            // [V]
  Rows taken;  // what is written to files while the character shows a preview; else empty
  // What web_buffer() hands out, but for the surface.
  std::vector<float> posed, shown_positions, shown_normals, joint_positions;
  std::vector<float> palette;              // [J x 12] of the last pose
  std::vector<uint8_t> colours;            // [R x 3] sRGB
  std::vector<uint16_t> strongest;         // [R] joint
  std::vector<uint32_t> vertex_questions;  // [V] see sinew_bind_outputs, of the last questions listed
  std::string reply;
};

Session& session();
// Positions and normals of the shown mesh from the posed vertices.
void show(Session& s);
// The rows as skin() takes them: [V x slots], unused slots 0.
void fill_slots(Session& s);
// Shows rows instead of those that are shown, which become the argument.
void swap_rows(Session& s, Rows* rows);
// Back to what was taken.
void end_preview(Session& s);
// The character as its file has it; weights stay.
void stand(Session& s);
// The character that stands and has weights in the pose `to_pose`, where there is one, a picture's flat where that is asked for. Throws Error; it
// stands as it did then.
void strike(Session& s);
// What a file of it is: with its seams open where it is in another pose, as the command writes it.
Character written(const Session& s);
// Throw Error where there are none.
void need_joints(const Session& s);
void need_weights(const Session& s);

}  // namespace sinew::web
#endif
