// SPDX-License-Identifier: MIT
// What the page's worker calls: one character at a time is read from the module's files, given a skeleton where it has
// none, bound, coloured, posed and written. Calls that can fail return JSON, {"error": "one line"} when they did; arrays are read where web_buffer()
// says they lie.
#include <emscripten.h>

#include <algorithm>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "binds.hpp"
#include "capi/handle.hpp"
#include "characters.hpp"
#include "colours.hpp"
#include "handles.hpp"
#include "keep.hpp"
#include "paint.hpp"
#include "session.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

extern "C" sinew_progress character_progress();  // of samples/npm

namespace {

using namespace sinew;
using namespace sinew::web;

// Joints that turn less are not told among the bends of a pose, and of a motion's frame, where all turn a little.
constexpr double kLeastPosedDegrees = 1, kLeastPlayedDegrees = 15;

enum Buffer : uint32_t {
  kTriangles = 0,
  kVertexOf,
  kPositions,
  kNormals,
  kColours,
  kJointPositions,
  kStrongest,
  kVertexQuestions,
  kPalette
};

// Runs a call; what it throws becomes its reply.
template <class Call>
const char* answer(Call call) {
  Json reply;
  try {
    reply = call();
  } catch (const std::bad_alloc&) {
    reply = {{"error", "out of memory: the file is too large for this browser; try the sinew command"}};
  } catch (const OutOfMemory& error) {
    reply = {{"error", std::string(error.what()) + ", more than this browser gives a page; try the sinew command"}};
  } catch (const std::exception& error) {
    reply = {{"error", error.what()}};
  }
  session().reply = reply.dump(-1, ' ', false, Json::error_handler_t::replace);
  return session().reply.c_str();
}

// Vertices whose strongest joint is among these keep their rows from the next bind on; none: no vertex does.
void lock(Session& s, const std::vector<uint32_t>& joints) {
  s.locked.clear();
  if (joints.empty()) return;
  s.locked.assign(s.character.vertices.size(), 0);
  for (size_t v = 0; v < s.locked.size(); ++v) {
    const std::vector<Influence>& row = s.character.influences[v];
    s.locked[v] = !row.empty() && std::find(joints.begin(), joints.end(), row[0].joint) != joints.end() ? 1 : 0;
  }
}

void paint(Session& s, const Stroke& stroke) {
  end_preview(s);
  if (s.hints.empty()) s.hints.assign(s.character.vertices.size(), 0);
  web::paint(s.character, s.posed, stroke, s.slots, &s.character.influences, &s.hints);
  fill_slots(s);
}

void show_joints(Session& s, const std::vector<Affine>& palette) {
  s.palette.clear();
  s.joint_positions.clear();
  for (size_t j = 0; j < palette.size(); ++j) {
    const Vec3& rest = s.character.joints[j].position;
    for (const double x : palette[j]) s.palette.push_back(static_cast<float>(x));
    for (const double x : transform_point(palette[j], rest.x, rest.y, rest.z))
      s.joint_positions.push_back(static_cast<float>(x));
  }
}

// Returns {bends} of joints that are turned by `least_degrees` or more, see Skinning.
Json show_pose(Session& s, const std::vector<Affine>& palette, SkinMethod method, double least_degrees) {
  show_joints(s, palette);
  s.skinning.pose({s.character, s.rest, s.joints, s.weights, s.slots}, palette, method, &s.posed);
  show(s);
  return {{"bends", s.skinning.bends(s.character, palette, least_degrees, s.posed)}};
}

// turns: [J x 3] degrees about x, then y, then z.
Json pose(Session& s, const float* turns, SkinMethod method) {
  std::vector<JointRotation> list;
  for (size_t j = 0; j < s.character.joints.size(); ++j) {
    const float* const turn = turns + 3 * j;
    if (turn[0] != 0 || turn[1] != 0 || turn[2] != 0) list.push_back({j, turn[0], turn[1], turn[2]});
  }
  return show_pose(s, pose_palette(s.character, list), method, kLeastPosedDegrees);
}

SkinMethod skin_method(uint32_t number) {
  if (number > static_cast<uint32_t>(SkinMethod::kVolumeAndContact)) throw Error("no such skinning");
  return static_cast<SkinMethod>(number);
}

}  // namespace

extern "C" {

// "auto" of this module: "simd128" or "ref".
EMSCRIPTEN_KEEPALIVE const char* web_kernel() { return sinew_kernel_name(sinew_kernel_select(SINEW_KERNEL_AUTO)); }
EMSCRIPTEN_KEEPALIVE const char* web_version() { return sinew_version(); }

// A model, for the task that its file says.
EMSCRIPTEN_KEEPALIVE const char* web_model(const char* path) {
  return answer([&]() -> Json {
    static const struct {
      ModelUse use;
      const char* task;
      std::unique_ptr<LoadedModel> Session::*place;
    } kTasks[] = {{ModelUse::kBind, "weights", &Session::bind_model},
                  {ModelUse::kHands, "hands", &Session::hands_model},
                  {ModelUse::kFront, "fronts", &Session::front_model},
                  {ModelUse::kRig, "skeletons", &Session::rig_model}};
    const std::vector<uint8_t> bytes = read_file(path);
    for (const auto& one : kTasks) {
      try {
        std::unique_ptr<LoadedModel>& place = session().*one.place;
        place = model_from_bytes(bytes, path, one.use);
        return {{"bytes", bytes.size()},
                {"parameters", place->model.parameter_count},
                {"layers", place->model.layer_count},
                {"task", one.task}};
      } catch (const Error&) {
        if (one.use == ModelUse::kRig) throw;
      }
    }
    return {};
  });
}

// skeleton: "" when the mesh file has its own or none. number: of the character; where one has been loaded before, it has
// the skeleton that it had last. A failure leaves the present character as it was.
// place: {turns, height, floor} as CharacterTransform has them, up (1 = z), anew; all may be missing. Where anew is true, or it is another one than before, the skeleton is the file's.
EMSCRIPTEN_KEEPALIVE const char* web_load(const char* mesh, const char* skeleton, uint32_t number, const char* place) {
  return answer([&] { return load(session(), mesh, skeleton, number, Json::parse(place)); });
}

// A PNG or JPEG of a character. wishes: {class, figure, mask (a file), flat, outline: [[[x, y], ...], ...]}, all may be missing: found; places are
// pixels, x right, y down from the top left corner. Replies as web_load() does, for which a picture is one without wishes, with
// {picture: {width, height, figures, figure, clip, flat, cut, outline, place}}; place: {scale, left, bottom}, where the picture lies behind its mesh: pixel
// (x, y) is at ((x - left) scale, (bottom - y) scale, 0). `clip` is what the page plays where the user has none. web_rig() replies with `picture` but
// its place, too.
EMSCRIPTEN_KEEPALIVE const char* web_picture(const char* path, const char* wishes, uint32_t number) {
  return answer([&] { return load_picture(session(), path, Json::parse(wishes), number); });
}

// A character that is open no more.
EMSCRIPTEN_KEEPALIVE void web_forget(uint32_t number) {
  if (number == session().number) return;
  session().rigs_of.erase(number);
  session().placement_of.erase(number);
  session().pictures_of.erase(number);
}

// A new skeleton for the character. wishes: {up (0 = y, 1 = z, 2 = found), category, front, mirror, spine, toes, ends, at, alike} as SkeletonOptions has them, and the
// number of a SkeletonDetail; at: markers as edits, alike: of both sides. Replies with notes on what the mesh does not show, too.
EMSCRIPTEN_KEEPALIVE const char* web_rig(const char* wishes) {
  return answer([&] { return predict(session(), Json::parse(wishes)); });
}

// continues: in the place of the step before, as the moves of one drag.
EMSCRIPTEN_KEEPALIVE const char* web_edit(const char* edits, uint32_t mirror, uint32_t continues) {
  return answer([&] { return edit(session(), Json::parse(edits), mirror != 0, continues != 0); });
}

// The character as it is now, under a number that web_restore() knows until web_drop().
EMSCRIPTEN_KEEPALIVE void web_keep(uint32_t number) { keep(session(), number); }
EMSCRIPTEN_KEEPALIVE void web_drop(uint32_t number) { session().kept.erase(number); }
EMSCRIPTEN_KEEPALIVE const char* web_restore(uint32_t number) {
  return answer([&] { return restore(session(), number); });
}

// Rows that are locked or painted, as keep.hpp has them: for a project's file, and from one.
EMSCRIPTEN_KEEPALIVE const char* web_rows() {
  return answer([&] { return kept_rows(session()); });
}
EMSCRIPTEN_KEEPALIVE const char* web_put_rows(const char* rows) {
  return answer([&] {
    need_weights(session());
    end_preview(session());
    put_rows(session(), Json::parse(rows));
    return Json::object();
  });
}

EMSCRIPTEN_KEEPALIVE const char* web_rebind(const char* wish, const char* answers) {
  return answer([&] { return rebind(session(), read_wish(wish, nullptr), read_answers(answers)); });
}

// answers: [[vertex, kind, joint], ...], as sinew_answer has them.
EMSCRIPTEN_KEEPALIVE const char* web_bind(const char* wish, const char* answers) {
  return answer([&] { return bind_shown(session(), read_wish(wish, character_progress()), read_answers(answers)); });
}

// Until web_end_preview(), colours and poses are of a bind with these answers. Files never are.
EMSCRIPTEN_KEEPALIVE const char* web_preview(const char* wish, const char* answers) {
  return answer([&] {
    need_weights(session());
    return preview(session(), read_wish(wish, nullptr), read_answers(answers));
  });
}

EMSCRIPTEN_KEEPALIVE const char* web_end_preview() {
  return answer([&] {
    end_preview(session());
    return Json::object();
  });
}

// The style for characters from now on; "" for none.
EMSCRIPTEN_KEEPALIVE const char* web_style(const char* path) {
  return answer([&]() -> Json {
    Style style;
    if (*path != 0) style = read_style(path);
    session().style = std::move(style);
    return {{"characters", session().style.sheets.size()}};
  });
}

EMSCRIPTEN_KEEPALIVE const char* web_style_answers(const char* wish) {
  return answer([&] { return style_answers(session(), read_wish(wish, nullptr)); });
}

EMSCRIPTEN_KEEPALIVE const char* web_save_style(const char* wish, const char* answers, const char* path) {
  return answer([&] {
    need_weights(session());
    save_style(session(), read_wish(wish, nullptr), read_answers(answers), path);
    return Json::object();
  });
}

EMSCRIPTEN_KEEPALIVE const char* web_colour(uint32_t mode, uint32_t joint) {
  return answer([&] {
    need_weights(session());
    if (mode > static_cast<uint32_t>(ColourMode::kDifference)) throw Error("no such colours");
    return Json({{"mean", colour(session(), static_cast<ColourMode>(mode), joint)}});
  });
}

// joints: [joint, ...] whose vertices are locked from now on, [] for none.
EMSCRIPTEN_KEEPALIVE const char* web_lock(const char* joints) {
  return answer([&] {
    need_weights(session());
    end_preview(session());
    lock(session(), Json::parse(joints).get<std::vector<uint32_t>>());
    return Json::object();
  });
}

// stroke: {vertex (shown), radius, joint (-1: smooths), strength}; painted vertices are hints of the next bind.
EMSCRIPTEN_KEEPALIVE const char* web_paint(const char* stroke) {
  return answer([&] {
    Session& s = session();
    need_weights(s);
    const Json json = Json::parse(stroke);
    Stroke one;
    one.vertex = s.surface.vertex_of.at(json.at("vertex").get<size_t>());
    one.radius = json.at("radius").get<float>();
    one.joint = json.at("joint").get<int32_t>();
    one.strength = json.at("strength").get<float>();
    if (one.joint >= static_cast<int32_t>(s.character.joints.size())) throw Error("no such joint");
    paint(s, one);
    return Json({{"painted", std::count(s.hints.begin(), s.hints.end(), uint8_t{1})}});
  });
}

// What was painted is no hint any more.
EMSCRIPTEN_KEEPALIVE void web_forget_paint() { session().hints.clear(); }

// method: SkinMethod. Returns {bends: [{joint, degrees, kept}]} of the joints that are turned.
EMSCRIPTEN_KEEPALIVE const char* web_pose(const float* turns, uint32_t method) {
  return answer([&] {
    need_weights(session());
    return pose(session(), turns, skin_method(method));
  });
}

// A handle of the character, see handle_of().
EMSCRIPTEN_KEEPALIVE sinew_status web_character(uint32_t what, const sinew_character* moving, sinew_character** out) {
  return guarded(nullptr, [&] {
    if (static_cast<CopyOf>(what) != CopyOf::kShown) end_preview(session());
    *out = handle_of(session(), static_cast<CopyOf>(what), moving).release();
  });
}

// See put_on_floor(): for the page's up axis.
EMSCRIPTEN_KEEPALIVE sinew_status web_put_on_floor(sinew_character* handle, double* height) {
  return guarded(handle, [&] { *height = put_on_floor(handle, session().up_axis); });
}

// The clips of a handle, see clips_json().
EMSCRIPTEN_KEEPALIVE const char* web_clips(const sinew_character* moving) {
  return answer([&] { return clips_json(*moving); });
}
EMSCRIPTEN_KEEPALIVE const char* web_map_reason(uint32_t reason) {
  return map_reason_text(static_cast<uint8_t>(reason));
}

// As web_pose(), by a clip of a handle, of joints that are turned far.
EMSCRIPTEN_KEEPALIVE const char* web_frame(const sinew_character* moving, uint32_t clip, double seconds,
                                           uint32_t method) {
  return answer([&] {
    Session& s = session();
    return show_pose(s, palette_at(s, moving, clip, seconds), skin_method(method), kLeastPlayedDegrees);
  });
}

// The joints alone, where the picture skins linearly by itself; positions and normals stay what they were.
EMSCRIPTEN_KEEPALIVE const char* web_frame_joints(const sinew_character* moving, uint32_t clip, double seconds) {
  return answer([&] {
    show_joints(session(), palette_at(session(), moving, clip, seconds));
    return Json::object();
  });
}

// A handle with one clip of another, springs played into it, see swung(); and springs of a handle into all its clips, see swing().
EMSCRIPTEN_KEEPALIVE sinew_status web_swing(const sinew_character* moving, const sinew_character* springs,
                                            uint32_t clip, sinew_character** out) {
  return guarded(nullptr, [&] { *out = swung(*moving, *springs, clip).release(); });
}
EMSCRIPTEN_KEEPALIVE sinew_status web_swing_all(sinew_character* handle) {
  return guarded(handle, [&] { swing(handle); });
}

// As web_frame(), dragged. springs: a handle that has some; moving: null for a pose of turns [J x 3], see web_pose(). drag: {move, degrees, passed, begins}:
// how far from its place, degrees about what is up, seconds since the frame before, whether it is the first one.
EMSCRIPTEN_KEEPALIVE const char* web_dragged(const sinew_character* springs, const sinew_character* moving,
                                             uint32_t clip, double seconds, const float* turns, const char* drag,
                                             uint32_t method) {
  return answer([&] {
    Session& s = session();
    need_weights(s);
    const Json wish = Json::parse(drag);
    const auto pose_at = [&](double at) {
      return moving == nullptr ? turned_frame(s.character.joints, turns) : frame_of(s, moving, clip, at);
    };
    if (wish.at("begins").get<bool>() || !s.live)
      s.live.emplace(*springs->springs, s.character.joints, s.up_axis == Axis::kZ ? 2 : 1, pose_at, seconds);
    const Drag by = {wish.at("move").get<Point3>(), wish.at("degrees").get<double>()};
    const std::vector<Affine> palette = s.live->palette(pose_at(seconds), seconds, wish.at("passed").get<double>(), by);
    return show_pose(s, palette, skin_method(method), kLeastPlayedDegrees);
  });
}

// {pose}: the rest pose that files of a profile have, "" for as it stands.
EMSCRIPTEN_KEEPALIVE const char* web_profile(const char* name) {
  return answer([&]() -> Json { return {{"pose", profile_named(name).pose}}; });
}

EMSCRIPTEN_KEEPALIVE const void* web_buffer(uint32_t which, size_t* bytes) {
  const Session& s = session();
  const auto give = [&](const auto& values) -> const void* {
    *bytes = values.size() * sizeof(values[0]);
    return values.data();
  };
  switch (which) {
    case kTriangles:
      return give(s.surface.triangles);
    case kVertexOf:
      return give(s.surface.vertex_of);
    case kPositions:
      return give(s.shown_positions);
    case kNormals:
      return give(s.shown_normals);
    case kColours:
      return give(s.colours);
    case kJointPositions:
      return give(s.joint_positions);
    case kPalette:
      return give(s.palette);
    case kStrongest:
      return give(s.strongest);
    default:
      return give(s.vertex_questions);
  }
}

}  // extern "C"
