// SPDX-License-Identifier: MIT
// The contents of a sinew_character, and the common part of all calls of sinew/character.h: options, errors,
// cancellation.
#ifndef SINEW_CHARACTER_CAPI_HANDLE_HPP
#define SINEW_CHARACTER_CAPI_HANDLE_HPP

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sinew/character.h"
#include "sinew_character/check/check.hpp"
#include "sinew_character/jobs/character_file.hpp"
#include "sinew_character/jobs/picture_job.hpp"
#include "sinew_character/models/models.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_character/springs/spring_player.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/keypoints_stream.hpp"
#include "sinew_formats/memory_files.hpp"
#include "sinew_formats/morphs.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/springs.hpp"

namespace sinew {

// Arrays that were handed out.
struct CharacterViews {
  std::vector<const char*> joint_names, mesh_names;
  std::vector<float> positions, joint_positions, weights;
  std::vector<int32_t> parents, mesh_joints;
  std::vector<uint32_t> row_offsets, joint_indices;
  std::vector<uint8_t> mesh_skinned;
  uint32_t influence_count = 0;
};

// Results of a picture's outline.
struct OutlineViews {
  std::vector<uint32_t> offsets;
  std::vector<float> points;
};

struct ClipView {
  std::vector<double> rotations, translations;
  std::vector<const char*> joint_names;
  std::vector<int32_t> parents;
};

// Arrays of results.
struct ResultViews {
  std::vector<sinew_character_left_out> left_out;
  std::vector<uint32_t> vertex_questions;
  std::vector<std::string> texts;
  std::vector<sinew_question> questions;
  std::vector<uint8_t> ends, reasons;
  std::vector<float> confidence, parent_confidence;
  std::vector<int32_t> sources;
  std::vector<sinew_limb_quality> before, after;
  std::vector<uint8_t> spot_kinds;
  std::vector<float> spot_positions, spot_errors;
  std::string joint_names, kinds;
  std::vector<sinew_transfer_part> parts;
  std::vector<sinew_character_seam> seams;
  std::vector<sinew_character_doubt> doubtful;
  std::string text;
  RigCheck check;
  std::vector<sinew_character_finding> findings;
};

}  // namespace sinew

struct sinew_character {
  sinew::Character character;
  std::string path;                                        // file that it is from; empty: arrays
  std::shared_ptr<const sinew::FileBytes> files;           // where that lies; null: the disk
  std::shared_ptr<const sinew::PictureCharacter> picture;  // that it is of, without its mesh; null: of none
  bool own_skeleton = true;                                // of the mesh's own file
  bool same_skin = true;                                   // weights and skeleton are the file's
  bool drop_animations = false;                            // the file's animations are not written
  bool posed = false;                                      // a mesh in a pose: an .obj of it has no skeleton
  bool keep_confidence = false;
  std::string profile;  // what is written for another program; empty: none
  sinew::ProfileOptions profile_options;
  std::optional<sinew::Motion> own_motion;                  // of the file, once it was asked for
  std::vector<sinew::Clip> clips;                           // added ones, of the character's joints
  std::shared_ptr<const sinew::KeypointsStream> keypoints;  // that it is of; null: of a file or of arrays
  sinew::Morphs morphs;
  std::optional<sinew::Springs> springs;               // replace those of the file
  std::unique_ptr<sinew::SpringPlayer> spring_player;  // for frames that arrive one by one; made at the first one
  sinew::CharacterViews views;
  sinew::OutlineViews outline;
  bool viewed = false;
  std::vector<sinew::ClipView> clip_views;  // by number
  sinew::ResultViews results;
  std::string notes, controls;
  std::vector<sinew::NamedBytes> written;
  std::vector<sinew_file> written_files;
  mutable std::string error;
};

namespace sinew {

// A status of its own, where Error would be SINEW_ERROR_INPUT.
class Failure : public Error {
 public:
  Failure(sinew_status status, const std::string& line) : Error(line), status_(status) {}
  sinew_status status() const { return status_; }

 private:
  sinew_status status_;
};

// Keeps the line for sinew_character_error().
sinew_status fail(const sinew_character* character, sinew_status status, const char* line) noexcept;

// The caller's progress callback, and whether it asked to stop.
class ProgressOfCaller {
 public:
  ProgressOfCaller(sinew_progress progress, void* user) : progress_(progress), user_(user) {}
  sinew_progress callback() const { return progress_ == nullptr ? nullptr : call; }
  void* user() { return this; }
  // Without an engine that calls: a share of the work.
  bool step(size_t done, size_t total) {
    return progress_ == nullptr ||
           call(this, total == 0 ? 0 : static_cast<uint32_t>(std::min<size_t>(1000, done * 1000 / total))) == 0;
  }
  bool cancelled() const { return cancelled_; }

 private:
  static int call(void* self, uint32_t permille) {
    auto* progress = static_cast<ProgressOfCaller*>(self);
    if (!progress->cancelled_) progress->cancelled_ = progress->progress_(progress->user_, permille) != 0;
    return progress->cancelled_ ? 1 : 0;
  }
  sinew_progress progress_;
  void* user_;
  bool cancelled_ = false;
};

// Runs `work`; what it throws becomes a status and a line. Nothing is thrown.
template <class Work>
sinew_status guarded(const sinew_character* character, Work&& work,
                     const ProgressOfCaller* progress = nullptr) noexcept {
  const auto status_of = [&](sinew_status usual) {
    return progress != nullptr && progress->cancelled() ? SINEW_ERROR_CANCELLED : usual;
  };
  try {
    work();
    return SINEW_OK;
  } catch (const Failure& error) {
    return fail(character, status_of(error.status()), error.what());
  } catch (const OutOfMemory& error) {
    return fail(character, SINEW_ERROR_MEMORY, error.what());
  } catch (const std::bad_alloc&) {
    return fail(character, SINEW_ERROR_MEMORY, "not enough memory");
  } catch (const std::length_error&) {
    return fail(character, SINEW_ERROR_MEMORY, "not enough memory");
  } catch (const std::exception& error) {
    return fail(character, status_of(SINEW_ERROR_INPUT), error.what());
  } catch (...) {
    return fail(character, SINEW_ERROR_INPUT, "unknown failure");
  }
}

inline void need(bool given, const char* what) {
  if (!given) throw Failure(SINEW_ERROR_ARGUMENT, std::string(what) + ": expected a pointer, found null");
}

// The caller's options: all defaults for null, members that an older header lacks are 0.
template <class Options>
Options options_of(const Options* given) {
  Options options;
  std::memset(&options, 0, sizeof options);
  options.struct_size = sizeof options;
  if (given == nullptr) return options;
  constexpr uint32_t kMost = 4096;
  if (given->struct_size < 2 * sizeof(uint32_t) || given->struct_size > kMost)
    throw Failure(SINEW_ERROR_ARGUMENT, "options: struct_size is not set; start from SINEW_INIT()");
  std::memcpy(&options, given, std::min<size_t>(given->struct_size, sizeof options));
  const auto* bytes = reinterpret_cast<const uint8_t*>(given);
  for (size_t i = sizeof options; i < given->struct_size; ++i)
    if (bytes[i] != 0)
      throw Failure(SINEW_ERROR_VERSION,
                    "options: a member is set that this library does not know; update the library");
  return options;
}

template <class Result>
void check_result(const Result* result) {
  if (result != nullptr && (result->struct_size < 2 * sizeof(uint32_t) || result->struct_size > 4096))
    throw Failure(SINEW_ERROR_ARGUMENT, "result: struct_size is not set; start from SINEW_INIT()");
}

// Writes what the caller's header has.
template <class Result>
void give(const Result& filled, Result* result) {
  if (result == nullptr) return;
  const uint32_t size = result->struct_size;
  std::memcpy(result, &filled, std::min<size_t>(size, sizeof filled));
  result->struct_size = size;
}

inline void check_at_most(const char* what, uint32_t value, uint32_t most) {
  if (value > most)
    throw Failure(SINEW_ERROR_ARGUMENT,
                  std::string(what) + ": expected 0 to " + std::to_string(most) + ", found " + std::to_string(value));
}

// `known`: the bits of sinew_without that the call takes.
inline void check_without(uint32_t without, uint32_t known) {
  if ((without & ~known) != 0)
    throw Failure(SINEW_ERROR_ARGUMENT, "without: contains a bit that this call does not take");
}

// A caller's pins name joints of both skeletons; a source may be -1, none.
inline void check_pins(const sinew_map_pin* pins, uint32_t pin_count, size_t target_joints, size_t source_joints) {
  for (uint32_t p = 0; p < pin_count; ++p)
    if (pins[p].target >= target_joints || pins[p].source < -1 || pins[p].source >= static_cast<int32_t>(source_joints))
      throw Failure(SINEW_ERROR_RANGE, "pins: pin " + std::to_string(p) + " names a joint that does not exist");
}

// The progress members of options, before these are checked: they have the same offsets in every struct.
template <class Options>
ProgressOfCaller progress_of(const Options* given) {
  const bool has = given != nullptr && given->struct_size >= offsetof(Options, progress_user) + sizeof(void*);
  return has ? ProgressOfCaller(given->progress, given->progress_user) : ProgressOfCaller(nullptr, nullptr);
}

// Throws Failure for X, which no mesh has up.
inline Axis up_axis_of(const char* what, uint32_t up) {
  check_at_most(what, up, SINEW_UP_Z);
  if (up == SINEW_UP_X) throw Failure(SINEW_ERROR_ARGUMENT, std::string(what) + ": expected Y or Z");
  return up == SINEW_UP_Z ? Axis::kZ : Axis::kY;
}

// None for SINEW_UP_AUTO.
inline MaybeAxis maybe_axis(uint32_t up) {
  return up == SINEW_UP_X   ? MaybeAxis(Axis::kX)
         : up == SINEW_UP_Y ? MaybeAxis(Axis::kY)
         : up == SINEW_UP_Z ? MaybeAxis(Axis::kZ)
                            : std::nullopt;
}

inline uint32_t count32(size_t count) { return static_cast<uint32_t>(count); }

// Copies of a caller's files.
std::shared_ptr<FileBytes> bytes_of(const sinew_file* files, uint32_t file_count);
// Reads the file at `opened->path`.
void open_into(sinew_character* opened);
// Reads the figure of the picture at `opened->path`.
void open_picture_into(const PictureJobOptions& options, sinew_character* opened);
// Everything but the mesh, which the handle has.
std::shared_ptr<const PictureCharacter> without_mesh(PictureCharacter picture);

// Files of a character in memory are seen while this lives.
class FilesOf {
 public:
  explicit FilesOf(const sinew_character& character) {
    if (character.files != nullptr) scope_.emplace(character.files.get(), memory_outputs());
  }

 private:
  std::optional<MemoryFiles> scope_;
};

// The file's motion, read once; without clips where it has none.
const Motion& own_motion(sinew_character* character);
// Clips that sinew_character_get_clip() numbers: the file's where they are kept, then the added ones.
size_t own_clip_count(sinew_character* character);

// Another skin or skeleton than the file's; what was handed out is void.
void changed(sinew_character* character);

// Throws Error where calls have added clips or morph targets, which are of the joints and vertices that are there.
void check_nothing_added(const sinew_character& character);

std::unique_ptr<LoadedModel> model_of(const sinew_character_models* models, ModelUse use);

}  // namespace sinew
#endif
