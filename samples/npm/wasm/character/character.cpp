// SPDX-License-Identifier: MIT
// sinew/character.h for JavaScript: options and results are JSON, arrays are read where a reply says they lie. src/character.js calls it.
// Members of an options struct have its names here too; what a caller does not give is 0, the default.
#include "sinew/character.h"

#include <emscripten.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

EM_JS(int, tell_progress, (uint32_t permille),
      { return Module["onProgress"] && Object.is(Module["onProgress"](permille / 1000), true) ? 1 : 0; });

namespace {

using Json = nlohmann::json;

std::string reply;

const char* say(const Json& json) {
  reply = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return reply.c_str();
}

const char* refuse(sinew_status status, const sinew_character* character) {
  std::string line = sinew_character_error(character);
  return say({{"error", line.empty() ? sinew_status_text(status) : line}, {"status", status}});
}

size_t address(const void* at) { return reinterpret_cast<size_t>(at); }

// The number behind a member's name; one that no struct has is the caller's mistake.
class Wish {
 public:
  explicit Wish(const char* text) : json_(Json::parse(text)) {}
  void take(const char* name, uint32_t* out) {
    const auto at = json_.find(name);
    if (at == json_.end()) return;
    *out = at->is_boolean() ? at->get<bool>() : at->get<uint32_t>();
    json_.erase(at);
  }
  void take(const char* name, double* out) {
    const auto at = json_.find(name);
    if (at == json_.end()) return;
    *out = at->get<double>();
    json_.erase(at);
  }
  // The text stays as long as the wish.
  void take(const char* name, const char** out) {
    const auto at = json_.find(name);
    if (at == json_.end()) return;
    texts_.push_back(std::make_unique<std::string>(at->get<std::string>()));
    *out = texts_.back()->c_str();
    json_.erase(at);
  }
  // Lists of places [[[x, y], ...], ...] as CSR.
  void take_lines(const char* name, std::vector<uint32_t>* offsets, std::vector<float>* places) {
    const auto at = json_.find(name);
    if (at == json_.end()) return;
    *offsets = {0};
    for (const Json& line : *at) {
      for (const Json& place : line)
        places->insert(places->end(), {place.at(0).get<float>(), place.at(1).get<float>()});
      offsets->push_back(static_cast<uint32_t>(places->size() / 2));
    }
    json_.erase(at);
  }
  // A list of texts, which stay as long as the wish.
  void take_texts(const char* name, std::vector<const char*>* out) {
    const auto at = json_.find(name);
    if (at == json_.end()) return;
    for (const Json& text : *at) {
      texts_.push_back(std::make_unique<std::string>(text.get<std::string>()));
      out->push_back(texts_.back()->c_str());
    }
    json_.erase(at);
  }
  // {name: number}, in the order of the names.
  void take_numbers(const char* name, std::vector<const char*>* names, std::vector<double>* numbers) {
    const auto at = json_.find(name);
    if (at == json_.end()) return;
    for (const auto& [one, number] : at->items()) {
      texts_.push_back(std::make_unique<std::string>(one));
      names->push_back(texts_.back()->c_str());
      numbers->push_back(number.get<double>());
    }
    json_.erase(at);
  }
  // An array that JavaScript has put into memory.
  template <class T>
  void take_array(const char* name, const T** out) {
    const auto at = json_.find(name);
    if (at == json_.end()) return;
    *out = reinterpret_cast<const T*>(at->get<size_t>());
    json_.erase(at);
  }
  // Its name, where one is left.
  std::string unknown() const { return json_.empty() ? "" : json_.begin().key(); }

 private:
  Json json_;
  std::vector<std::unique_ptr<std::string>> texts_;
};

int progress(void*, uint32_t permille) { return tell_progress(permille); }

// Runs a job with the options that `fill` takes out of the wish.
template <class Options, class Fill, class Job>
const char* run(const sinew_character* character, const char* text, Options options, Fill fill, Job job) {
  try {
    Wish wish(text);
    fill(wish, options);
    if (const std::string name = wish.unknown(); !name.empty())
      return say({{"error", "there is no option " + name}, {"status", SINEW_ERROR_ARGUMENT}});
    Json said = Json::object();
    const sinew_status status = job(options, said);
    return status == SINEW_OK ? say(said) : refuse(status, character);
  } catch (const std::exception& error) {
    return say({{"error", std::string("options: ") + error.what()}, {"status", SINEW_ERROR_ARGUMENT}});
  }
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* character_open(const sinew_file* files, uint32_t count) {
  sinew_character* opened = nullptr;
  const sinew_status status = sinew_character_open_files(files, count, &opened);
  return status == SINEW_OK ? say({{"handle", address(opened)}}) : refuse(status, nullptr);
}

EMSCRIPTEN_KEEPALIVE const char* character_open_picture(const sinew_file* files, uint32_t count, const char* text) {
  std::vector<uint32_t> offsets;
  std::vector<float> places;
  return run(
      nullptr, text, sinew_character_picture_options_init(),
      [&](Wish& wish, sinew_character_picture_options& o) {
        wish.take("body_class", &o.body_class);
        wish.take("figure", &o.figure);
        wish.take("flat", &o.flat);
        wish.take("cut", &o.cut);
        wish.take("pixels", &o.pixels);
        wish.take("mask", &o.mask);
        wish.take_lines("outline", &offsets, &places);
        o.line_count = offsets.empty() ? 0 : static_cast<uint32_t>(offsets.size() - 1);
        o.line_offsets = offsets.data();
        o.outline = places.data();
      },
      [&](const sinew_character_picture_options& o, Json& said) {
        sinew_character* opened = nullptr;
        const sinew_status status = sinew_character_open_picture_files(files, count, &o, &opened);
        if (status == SINEW_OK) said["handle"] = address(opened);
        return status;
      });
}

// What was found in a picture; `lines` are numbers of places, which lie at `outline`.
EMSCRIPTEN_KEEPALIVE const char* character_picture(sinew_character* character) {
  sinew_character_picture_info info = sinew_character_picture_info_init();
  const sinew_status status = sinew_character_picture(character, &info);
  if (status != SINEW_OK) return refuse(status, character);
  return say({{"width", info.width},
              {"height", info.height},
              {"figureCount", info.figure_count},
              {"figure", info.figure},
              {"bodyClass", info.body_class},
              {"view", info.view},
              {"certainty", info.certainty},
              {"lineOffsets", std::vector<uint32_t>(info.line_offsets, info.line_offsets + info.line_count + 1)},
              {"outline", address(info.outline)}});
}

EMSCRIPTEN_KEEPALIVE const char* character_open_places(const char* layout, const float* places, uint32_t place_count,
                                                       uint32_t frame_count) {
  sinew_character* opened = nullptr;
  const sinew_status status = sinew_character_open_places(layout, places, place_count, frame_count, &opened);
  return status == SINEW_OK ? say({{"handle", address(opened)}}) : refuse(status, nullptr);
}

// rotations [J x 4], translations [J x 3]
EMSCRIPTEN_KEEPALIVE const char* character_places_frame(const sinew_character* character, const float* places,
                                                        uint32_t place_count, float* rotations, float* translations) {
  const sinew_status status = sinew_character_places_frame(character, places, place_count, rotations, translations);
  return status == SINEW_OK ? say(Json::object()) : refuse(status, character);
}

EMSCRIPTEN_KEEPALIVE void character_close(sinew_character* character) { sinew_character_close(character); }

EMSCRIPTEN_KEEPALIVE const char* character_notes(sinew_character* character) {
  return say(sinew_character_notes(character));
}

EMSCRIPTEN_KEEPALIVE const char* character_extensions(uint32_t uses) { return sinew_character_extensions(uses); }

// Counts, names, and where arrays lie; 0 = there is none.
EMSCRIPTEN_KEEPALIVE const char* character_view(sinew_character* character) {
  sinew_character_arrays arrays = sinew_character_arrays_init();
  const sinew_status status = sinew_character_view(character, &arrays);
  if (status != SINEW_OK) return refuse(status, character);
  Json names = Json::array(), meshes = Json::array();
  for (uint32_t j = 0; j < arrays.joint_count; ++j) names.push_back(arrays.joint_names[j]);
  for (uint32_t m = 0; m < arrays.mesh_count; ++m)
    meshes.push_back(
        {{"name", arrays.mesh_names[m]}, {"joint", arrays.mesh_joints[m]}, {"skinned", arrays.mesh_skinned[m] != 0}});
  return say({{"name", arrays.name},
              {"vertexCount", arrays.vertex_count},
              {"faceCount", arrays.face_count},
              {"cornerCount", arrays.corner_count},
              {"jointCount", arrays.joint_count},
              {"jointNames", std::move(names)},
              {"meshes", std::move(meshes)},
              {"positions", address(arrays.positions)},
              {"faceOffsets", address(arrays.face_offsets)},
              {"faceVertices", address(arrays.face_vertices)},
              {"jointPositions", address(arrays.joint_positions)},
              {"parents", address(arrays.parents)},
              {"rowOffsets", address(arrays.row_offsets)},
              {"jointIndices", address(arrays.joint_indices)},
              {"weights", address(arrays.weights)},
              {"confidence", address(arrays.confidence)}});
}

EMSCRIPTEN_KEEPALIVE const char* character_write(sinew_character* character, const char* name) {
  const sinew_file* files = nullptr;
  uint32_t count = 0;
  const sinew_status status = sinew_character_write(character, name, &files, &count);
  if (status != SINEW_OK) return refuse(status, character);
  Json list = Json::array();
  for (uint32_t f = 0; f < count; ++f)
    list.push_back({{"name", files[f].name}, {"at", address(files[f].bytes)}, {"size", files[f].size_bytes}});
  return say(list);
}

EMSCRIPTEN_KEEPALIVE const char* character_bind(sinew_character* character, const char* text) {
  return run(
      character, text, sinew_character_bind_options_init(),
      [](Wish& wish, sinew_character_bind_options& o) {
        o.progress = progress;
        wish.take("method", &o.method);
        wish.take("influence_count", &o.influence_count);
        wish.take("up", &o.up);
        wish.take("joints", &o.joints);
        wish.take("rigid_parts", &o.rigid_parts);
        wish.take("softness_percent", &o.softness_percent);
        wish.take("surface_vertices", &o.surface_vertices);
        wish.take("keep_tips", &o.keep_tips);
        wish.take("bind_props", &o.bind_props);
        wish.take("fit", &o.fit);
        wish.take("symmetric", &o.symmetric);
        wish.take("keep_confidence", &o.keep_confidence);
        wish.take("cut", &o.cut);
        wish.take("to_pose", &o.to_pose);
        wish.take_array("joint_flags", &o.joint_flags);
        wish.take_array("locked", &o.locked);
        wish.take_array("hinted", &o.hinted);
        wish.take_array("like", &o.like);
      },
      [&](const sinew_character_bind_options& o, Json& said) {
        sinew_character_bind_result result = sinew_character_bind_result_init();
        const sinew_status status = sinew_character_bind(character, &o, &result);
        if (status != SINEW_OK) return status;
        said["hash"] = result.hash;
        said["seconds"] = result.seconds;
        said["symmetricVertices"] = result.symmetric_vertices;
        said["keptMeshes"] = result.kept_meshes;
        said["foldedTips"] = result.folded_tips;
        said["seams"] = result.seam_count;
        said["leftOut"] = Json::array();
        for (uint32_t i = 0; i < result.left_out_count; ++i)
          said["leftOut"].push_back({{"joint", result.left_out[i]}, {"why", result.left_out_why[i]}});
        return status;
      });
}

EMSCRIPTEN_KEEPALIVE const char* character_rig(sinew_character* character, const char* text) {
  return run(
      character, text, sinew_character_rig_options_init(),
      [](Wish& wish, sinew_character_rig_options& o) {
        o.progress = progress;
        wish.take("method", &o.method);
        wish.take("detail", &o.detail);
        wish.take("mirror", &o.mirror);
        wish.take("up", &o.up);
        wish.take("spine_count", &o.spine_count);
        wish.take("no_toes", &o.no_toes);
        wish.take("no_ends", &o.no_ends);
        wish.take("no_bind", &o.no_bind);
        wish.take("keep_lengths", &o.keep_lengths);
        wish.take("influence_count", &o.influence_count);
        wish.take("category", &o.category);
        wish.take("gate", &o.gate);
        wish.take("cut", &o.cut);
        wish.take("to_pose", &o.to_pose);
        wish.take("skeleton", &o.skeleton);
        wish.take_array("skeleton_character", &o.skeleton_character);
      },
      [&](const sinew_character_rig_options& o, Json& said) {
        sinew_character_rig_result result = sinew_character_rig_result_init();
        const sinew_status status = sinew_character_rig(character, &o, &result);
        if (status != SINEW_OK) return status;
        said["mirrored"] = result.mirrored != 0;
        said["matched"] = result.matched;
        said["spread"] = static_cast<double>(result.spread);
        said["seconds"] = result.seconds;
        said["doubtful"] = Json::array();
        for (uint32_t i = 0; i < result.doubtful_count; ++i)
          said["doubtful"].push_back({{"name", result.doubtful[i].name}, {"doubt", result.doubtful[i].doubt}});
        return status;
      });
}

EMSCRIPTEN_KEEPALIVE const char* character_animate(sinew_character* character, sinew_character* motion,
                                                   const char* text) {
  return run(
      character, text, sinew_character_animate_options_init(),
      [](Wish& wish, sinew_character_animate_options& o) {
        o.progress = progress;
        wish.take("method", &o.method);
        wish.take("in_place", &o.in_place);
        wish.take("no_range", &o.no_range);
        wish.take("force", &o.force);
        wish.take("translations", &o.translations);
        wish.take("target_up", &o.target_up);
        wish.take("motion_up", &o.motion_up);
        wish.take("deform", &o.deform);
        wish.take("body_contact", &o.body_contact);
        wish.take("stiffness", &o.stiffness);
        wish.take("tet_weights", &o.tet_weights);
        wish.take("no_smoothing", &o.no_smoothing);
        wish.take("shapes", &o.shapes);
        wish.take("fps", &o.fps);
        wish.take("from", &o.from);
        wish.take("to", &o.to);
        wish.take("clip", &o.clip);
        wish.take("layout", &o.layout);
        wish.take("limits", &o.limits);
        wish.take("actor", &o.actor);
        wish.take("depth", &o.depth);
        wish.take_array("sources", &o.sources);
      },
      [&](const sinew_character_animate_options& o, Json& said) {
        sinew_character_animate_result result = sinew_character_animate_result_init();
        const sinew_status status = sinew_character_animate(character, motion, &o, &result);
        if (status != SINEW_OK) return status;
        said["clipCount"] = result.clip_count;
        said["mapped"] = result.mapped;
        said["rigged"] = result.rigged != 0;
        said["shapeCount"] = result.shape_count;
        said["certainty"] = static_cast<double>(result.certainty);
        said["mappedBy"] = result.mapped_by;
        return status;
      });
}

EMSCRIPTEN_KEEPALIVE const char* character_transfer(const sinew_character* source, sinew_character* target,
                                                    const char* text) {
  return run(
      target, text, sinew_character_transfer_options_init(),
      [](Wish& wish, sinew_character_transfer_options& o) {
        o.progress = progress;
        wish.take("method", &o.method);
        wish.take("influence_count", &o.influence_count);
        wish.take("target_up", &o.target_up);
        wish.take("source_up", &o.source_up);
        wish.take("garment", &o.garment);
        wish.take("heat", &o.heat);
      },
      [&](const sinew_character_transfer_options& o, Json& said) {
        sinew_character_transfer_result result = sinew_character_transfer_result_init();
        const sinew_status status = sinew_character_transfer(source, target, &o, &result);
        if (status != SINEW_OK) return status;
        said["carried"] = result.carried;
        said["fitted"] = result.fitted != 0;
        said["bound"] = result.bound != 0;
        return status;
      });
}

EMSCRIPTEN_KEEPALIVE const char* character_place(sinew_character* character, const char* text) {
  std::vector<const char*> turns;
  return run(
      character, text, sinew_character_place_options_init(),
      [&](Wish& wish, sinew_character_place_options& o) {
        wish.take("height", &o.height);
        wish.take("floor", &o.floor);
        wish.take("up", &o.up);
        wish.take_texts("turns", &turns);
        o.turns = turns.data();
        o.turn_count = static_cast<uint32_t>(turns.size());
      },
      [&](const sinew_character_place_options& o, Json&) { return sinew_character_place(character, &o); });
}

EMSCRIPTEN_KEEPALIVE const char* character_profile(sinew_character* character, const char* text) {
  std::vector<const char*> authors;
  return run(
      character, text, sinew_character_profile_options_init(),
      [&](Wish& wish, sinew_character_profile_options& o) {
        wish.take("profile", &o.profile);
        wish.take("keep_axes", &o.keep_axes);
        wish.take("controls", &o.controls);
        wish.take("licence", &o.licence);
        wish.take("title", &o.title);
        wish.take_texts("authors", &authors);
        o.authors = authors.data();
        o.author_count = static_cast<uint32_t>(authors.size());
      },
      [&](const sinew_character_profile_options& o, Json&) { return sinew_character_set_profile(character, &o); });
}

// The text as a text: its bytes are those of a file.
EMSCRIPTEN_KEEPALIVE const char* character_controls(sinew_character* character) {
  const char* text = nullptr;
  const sinew_status status = sinew_character_controls(character, &text);
  return status == SINEW_OK ? say(text) : refuse(status, character);
}

EMSCRIPTEN_KEEPALIVE const char* character_check(sinew_character* character, const char* text) {
  std::vector<const char*> rules;
  std::vector<double> bounds;
  return run(
      character, text, sinew_character_check_options_init(),
      [&](Wish& wish, sinew_character_check_options& o) {
        wish.take("no_poses", &o.no_poses);
        wish.take("no_clips", &o.no_clips);
        wish.take("score", &o.score);
        wish.take_numbers("bounds", &rules, &bounds);
        o.bound_rules = rules.data();
        o.bounds = bounds.data();
        o.bound_count = static_cast<uint32_t>(rules.size());
      },
      [&](const sinew_character_check_options& o, Json& said) {
        sinew_character_check_result result = sinew_character_check_result_init();
        const sinew_status status = sinew_character_check(character, &o, &result);
        if (status != SINEW_OK) return status;
        said["line"] = result.line;
        said["score"] = o.score != 0 ? Json(result.score) : Json();
        said["findings"] = Json::array();
        for (uint32_t i = 0; i < result.finding_count; ++i) {
          const sinew_character_finding& f = result.findings[i];
          said["findings"].push_back({{"rule", f.rule},
                                      {"severity", f.severity},
                                      {"what", f.what},
                                      {"cure", f.cure},
                                      {"pose", f.pose},
                                      {"clip", f.clip},
                                      {"seconds", f.seconds},
                                      {"value", f.value},
                                      {"bound", f.bound},
                                      {"joint", f.joint},
                                      {"other", f.other},
                                      {"mesh", f.mesh},
                                      {"position", {f.position[0], f.position[1], f.position[2]}},
                                      {"radius", f.radius},
                                      {"vertices", std::vector<uint32_t>(f.vertices, f.vertices + f.vertex_count)}});
        }
        return status;
      });
}

}  // extern "C"
