// SPDX-License-Identifier: MIT
// What the page's worker calls: one character at a time is read from the module's files, given a skeleton where it has
// none, bound, coloured, posed and written. Calls that can fail return JSON, {"error": "one line"} when they did; arrays are read where web_buffer()
// says they lie.
#include <emscripten.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "paint.hpp"
#include "player.hpp"
#include "rig/rig_task.hpp"
#include "rig_json.hpp"
#include "rigs.hpp"
#include "sinew/sinew.h"
#include "sinew_datasets/image.hpp"
#include "sinew_formats/answers.hpp"
#include "sinew_formats/bind_character.hpp"
#include "sinew_formats/engine_views.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/pose.hpp"
#include "sinew_formats/predict_details.hpp"
#include "sinew_formats/predict_skeleton.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_formats/skeleton_repair.hpp"
#include "sinew_formats/style.hpp"
#include "skinning.hpp"
#include "surface.hpp"

using Json = nlohmann::ordered_json;

EM_JS(void, show_progress, (uint32_t permille), {
  if (Module["onProgress"]) Module["onProgress"](permille / 1000);
});

namespace {

using namespace sinew;

constexpr uint32_t kQuestions = 8;  // listed beside the mesh
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

// What a bind of the character gives and pictures, poses and files show.
struct Rows {
  std::vector<std::vector<Influence>> influences;  // [V]
  std::vector<uint8_t> confidence;                 // [V]
};

// The block stays where it is, and with it what the model points to.
struct OpenModel {
  std::vector<uint64_t> bytes;
  sinew_model model = {};
};

struct Session {
  OpenModel bind_model, rig_model, hands_model;
  Character character;                    // with the joints of rigs().now()
  std::map<uint32_t, web::Rigs> rigs_of;  // of all characters that are open, by the page's numbers
  uint32_t number = 0;                    // the character's
  Style style;                            // for the next characters
  web::Player player;
  web::Skinning skinning;
  web::Rigs& rigs() { return rigs_of[number]; }
  const web::Rigs& rigs() const { return rigs_of.at(number); }
  web::Surface surface;
  std::vector<float> rest;                        // [V x 3]
  uint32_t slots = 4;                             // influences a vertex keeps
  std::vector<uint16_t> joints, weights;          // [V x slots]
  std::vector<std::vector<Influence>> reference;  // [V] of the file, or empty
  std::vector<uint8_t> locked, hints;             // [V] or empty: rows that the next bind keeps, see BindOptions
  std::vector<uint8_t> confidence;                // [V]
  Rows taken;  // what is written to files while the character shows a preview; else empty
  // What web_buffer() hands out, but for the surface.
  std::vector<float> posed, shown_positions, shown_normals, joint_positions;
  std::vector<float> palette;              // [J x 12] of the last pose
  std::vector<uint8_t> colours;            // [R x 3] sRGB
  std::vector<uint16_t> strongest;         // [R] joint
  std::vector<uint32_t> vertex_questions;  // [V] see sinew_bind_outputs, of the last questions listed
  std::string reply;
};

Session& session() {
  static Session only;
  return only;
}

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

void check(const std::string& what, sinew_status status) {
  if (status != SINEW_OK) throw Error(what + ": " + sinew_status_text(status));
}

void show(Session& s) {
  const size_t shown = s.surface.vertex_of.size();
  s.shown_positions.resize(shown * 3);
  for (size_t i = 0; i < shown; ++i)
    std::memcpy(&s.shown_positions[i * 3], &s.posed[size_t{s.surface.vertex_of[i]} * 3], 3 * sizeof(float));
  web::surface_normals(s.surface, s.posed, &s.shown_normals);
}

int progress(void*, uint32_t permille) {
  show_progress(permille);
  return 0;
}

// The rows as skin() takes them: [V x slots], unused slots 0.
void fill_slots(Session& s) {
  s.skinning.forget();
  s.joints.assign(s.character.vertices.size() * s.slots, 0);
  s.weights.assign(s.joints.size(), 0);
  for (size_t v = 0; v < s.character.influences.size(); ++v) {
    const std::vector<Influence>& row = s.character.influences[v];
    for (size_t i = 0; i < row.size() && i < s.slots; ++i) {
      s.joints[v * s.slots + i] = static_cast<uint16_t>(row[i].joint);
      s.weights[v * s.slots + i] = static_cast<uint16_t>(std::lround(row[i].weight * 65535.0f));
    }
  }
}

// How sure the least sure tenth is on average, 0 to 1.
double sure_of_least_tenth(std::vector<uint8_t> confidence) {
  const size_t tenth = (confidence.size() + 9) / 10;
  std::partial_sort(confidence.begin(), confidence.begin() + static_cast<std::ptrdiff_t>(tenth), confidence.end());
  double sum = 0;
  for (size_t i = 0; i < tenth; ++i) sum += confidence[i] / 255.0;
  return sum / static_cast<double>(tenth);
}

// Shows rows instead of those that are shown, which become the argument.
void swap_rows(Session& s, Rows* rows) {
  std::swap(s.character.influences, rows->influences);
  std::swap(s.confidence, rows->confidence);
  fill_slots(s);
}

void end_preview(Session& s) {
  if (s.taken.influences.empty()) return;
  swap_rows(s, &s.taken);
  s.taken = {};
}

// text: [[vertex, kind, joint], ...]
std::vector<sinew_answer> read_answers(const std::string& text) {
  std::vector<sinew_answer> answers;
  for (const Json& one : Json::parse(text))
    answers.push_back({one.at(0).get<uint32_t>(), one.at(1).get<uint16_t>(), one.at(2).get<uint16_t>(), 0});
  return answers;
}

struct Bound {
  CharacterBind result;
  JointChoice choice;  // with the joints that answers named
};

// How the page wants characters bound.
struct Wish {
  uint32_t method = 0, up_axis = 0, rigid_parts = 0, softness_percent = 100, influences = 4;
  bool symmetric = false;
  std::vector<size_t> never, always;  // joints that the user switched off, and those that were off
  sinew_progress progress = nullptr;
};

// text: {method, upAxis, symmetric, rigidParts, softness, influences, never, always}
Wish read_wish(const char* text, sinew_progress progress) {
  const Json json = Json::parse(text);
  Wish wish;
  wish.method = json.at("method").get<uint32_t>();
  wish.up_axis = json.at("upAxis").get<uint32_t>();
  wish.symmetric = json.at("symmetric").get<bool>();
  wish.rigid_parts = json.at("rigidParts").get<uint32_t>();
  wish.softness_percent = static_cast<uint32_t>(std::lround(json.at("softness").get<double>() * 100));
  wish.influences = json.at("influences").get<uint32_t>();
  wish.never = json.at("never").get<std::vector<size_t>>();
  wish.always = json.at("always").get<std::vector<size_t>>();
  wish.progress = progress;
  return wish;
}

// The user's word about joints, after the file's names and weights.
void switch_joints(const Character& character, const Wish& wish, JointChoice* choice) {
  take_back_joints(wish.always, {}, choice);
  for (const size_t joint : wish.never) {
    if (joint >= character.joints.size()) continue;
    if ((choice->flags[joint] & SINEW_JOINT_NEVER) == 0) choice->left_out.push_back({joint, "never deforms, as asked"});
    choice->flags[joint] |= SINEW_JOINT_NEVER;
    choice->tips.erase(std::remove(choice->tips.begin(), choice->tips.end(), joint), choice->tips.end());
  }
}

Bound bind_with(const Session& s, const Wish& wish, const std::vector<sinew_answer>& answers, uint32_t questions) {
  CharacterBindOptions options;
  options.bind.method = static_cast<sinew_method>(wish.method);
  if (options.bind.method == SINEW_METHOD_MODEL) {
    if (s.bind_model.bytes.empty()) throw Error("no model is loaded");
    options.bind.model = &s.bind_model.model;
  }
  options.bind.influence_count = wish.influences;
  options.bind.up_axis = wish.up_axis;
  options.bind.symmetric = wish.symmetric;
  options.bind.rigid_parts = wish.rigid_parts;
  options.bind.softness_percent = options.bind.method == SINEW_METHOD_MODEL ? wish.softness_percent : 100;
  if (!s.character.influences.empty()) {  // rows to keep
    options.bind.locked = s.locked;
    options.bind.hints = s.hints;
  }
  options.bind.progress = wish.progress;
  options.bind.answers = answers;
  options.bind.question_count = questions;
  options.keep_tips = options.bind_props = s.rigs().now().predicted;
  Bound bound;
  bound.choice = s.rigs().now().choice;
  switch_joints(s.character, wish, &bound.choice);
  std::vector<size_t> named;
  for (const sinew_answer& answer : answers)
    if (answer.kind == SINEW_ANSWER_RIGID && answer.joint < s.character.joints.size()) named.push_back(answer.joint);
  take_back_joints(named, {}, &bound.choice);
  bound.result = bind_character(s.character, bound.choice, options);
  return bound;
}

Json question_json(const std::vector<Joint>& joints, const sinew_question& question) {
  Json alternatives = Json::array();
  for (uint32_t a = 0; a < question.alternative_count; ++a) {
    const sinew_alternative& alternative = question.alternatives[a];
    alternatives.push_back({{"answer", answer_text(joints, alternative.kind, alternative.joint)},
                            {"kind", alternative.kind},
                            {"joint", alternative.joint},
                            {"change", alternative.change / 65536.0}});
  }
  return {{"part", question.vertex},           {"parts", question.part_count},
          {"vertices", question.vertex_count}, {"joint", joints[question.joint].name},
          {"share", question.share / 65535.0}, {"doubt", question.doubt / 65536.0},
          {"gain", question.gain / 65536.0},   {"alternatives", std::move(alternatives)}};
}

void need_joints(const Session& s) {
  if (s.character.joints.empty()) throw Error(s.character.name + ": has no skeleton yet");
}

Json bind_shown(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers) {
  need_joints(s);
  Bound bound = bind_with(s, wish, answers, kQuestions);
  CharacterBind& result = bound.result;
  s.taken = {};
  s.slots = wish.influences;
  Rows rows = {std::move(result.influences), std::move(result.confidence)};
  swap_rows(s, &rows);
  s.vertex_questions = std::move(result.vertex_questions);
  std::vector<double> sums(s.character.joints.size(), 0);
  size_t pairs = 0;
  for (const std::vector<Influence>& row : s.character.influences) {
    for (const Influence& influence : row) sums[influence.joint] += influence.weight;
    pairs += row.size();
  }
  s.strongest.resize(s.surface.vertex_of.size());
  for (size_t i = 0; i < s.strongest.size(); ++i) s.strongest[i] = s.joints[size_t{s.surface.vertex_of[i]} * s.slots];
  Json off = Json::array();
  for (size_t j = 0; j < bound.choice.flags.size(); ++j)
    if ((bound.choice.flags[j] & SINEW_JOINT_NEVER) != 0) off.push_back(j);
  Json left_out = Json::array();
  for (const LeftOutJoint& left : bound.choice.left_out)
    left_out.push_back(s.character.joints[left.joint].name + " (" + left.why + ")");
  Json questions = Json::array();
  for (const sinew_question& question : result.questions)
    questions.push_back(question_json(s.character.joints, question));
  return {{"seconds", result.seconds},
          {"workspaceBytes", result.workspace_bytes},
          {"usedBytes", result.used_bytes},
          {"hash", bind_hash(s.character.influences, s.slots)},
          {"jointWeights", sums},
          {"leftOut", left_out},
          {"off", off},
          {"lockedVertices", std::count(s.locked.begin(), s.locked.end(), uint8_t{1})},
          {"paintedVertices", std::count(s.hints.begin(), s.hints.end(), uint8_t{1})},
          {"symmetricVertices", result.symmetric_vertices},
          {"keptMeshes", result.kept_meshes},
          {"lookFirst", (s.confidence.size() + 9) / 10},
          {"lookFirstSure", sure_of_least_tenth(s.confidence)},
          {"meanInfluences", static_cast<double>(pairs) / static_cast<double>(s.character.vertices.size())},
          {"questions", std::move(questions)}};
}

// A bind that shows weights while a joint is dragged: no questions, no sums.
Json rebind(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers) {
  need_joints(s);
  CharacterBind result = bind_with(s, wish, answers, 0).result;
  s.taken = {};
  s.slots = wish.influences;
  Rows rows = {std::move(result.influences), std::move(result.confidence)};
  swap_rows(s, &rows);
  return {{"seconds", result.seconds}};
}

// Shows the character as these answers would bind it; what was taken stays what is written.
Json preview(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers) {
  CharacterBind result = bind_with(s, wish, answers, 0).result;
  end_preview(s);
  s.taken = {std::move(result.influences), std::move(result.confidence)};
  swap_rows(s, &s.taken);
  return {{"hash", bind_hash(s.character.influences, s.slots)}};
}

// Answers that the loaded style has for the character: with each its question, and the question's number in
// web_buffer(kVertexQuestions).
Json style_answers(Session& s, const Wish& wish) {
  Json list = Json::array();
  if (s.style.sheets.empty()) return {{"answers", std::move(list)}};
  CharacterBind proposed = bind_with(s, wish, {}, SINEW_MAX_QUESTIONS).result;
  const AskedBind asked = {proposed.questions, proposed.vertex_parts};
  for (const sinew_answer& answer : answer_by_style(s.style, s.character, asked, s.rigs().now().choice.flags)) {
    const uint32_t number = proposed.vertex_questions[answer.vertex];
    list.push_back({{"question", question_json(s.character.joints, proposed.questions[number])},
                    {"number", number},
                    {"answer", answer_text(s.character.joints, answer.kind, answer.joint)},
                    {"kind", answer.kind},
                    {"joint", answer.joint}});
  }
  s.vertex_questions = std::move(proposed.vertex_questions);
  return {{"answers", std::move(list)}};
}

// The loaded style with these answers.
void save_style(const Session& s, const Wish& wish, const std::vector<sinew_answer>& answers, const std::string& path) {
  const CharacterBind proposed = bind_with(s, wish, {}, SINEW_MAX_QUESTIONS).result;
  Style style = s.style;
  style.sheets.push_back(learn_style(s.character, {proposed.questions, proposed.vertex_parts}, answers));
  if (style.sheets.back().rules.empty()) throw Error("there is no answer to keep in a style; answer a question first");
  write_style(path, style);
}

// The character has the present rig. Weights stay where joints were moved or renamed, until the next bind.
Json show_rig(Session& s) {
  const std::vector<Joint>&before = s.character.joints, &now = s.rigs().now().joints;
  const bool alike = std::equal(before.begin(), before.end(), now.begin(), now.end(),
                                [](const Joint& a, const Joint& b) { return a.parent == b.parent; });
  s.character.joints = now;
  s.taken = {};
  if (!alike) {
    s.character.influences.clear();
    s.locked.clear();
    s.hints.clear();
    s.reference.clear();
    s.joints.clear();
    s.weights.clear();
    s.skinning.forget();
    s.posed = s.rest;
    show(s);
  }
  return web::rig_json(s.rigs());
}

Json predict(Session& s, const Json& wishes) {
  if (s.rig_model.bytes.empty()) throw Error("no model of skeletons is loaded");
  SkeletonOptions options;
  options.model = &s.rig_model.model;
  options.up_axis = wishes.at("upAxis").get<uint32_t>();
  options.mirror = wishes.at("mirror").get<uint32_t>();
  options.spine_count = wishes.at("spine").get<uint32_t>();
  options.toes = wishes.at("toes").get<bool>();
  options.ends = wishes.at("ends").get<bool>();
  PredictedSkeleton skeleton = predict_skeleton(s.character, options);
  const auto detail = static_cast<SkeletonDetail>(wishes.at("detail").get<uint8_t>());
  if (detail != SkeletonDetail::kBody && s.hands_model.bytes.empty()) throw Error("no model of hands is loaded");
  const std::vector<std::string> notes = predict_details(s.character, detail, s.hands_model.model, options, &skeleton);
  web::Rig rig = web::predicted_rig(s.character, std::move(skeleton));
  if (s.character.joints.empty())
    s.rigs().start(std::move(rig));  // a mesh without skeleton is no step to go back to
  else
    s.rigs().put(std::move(rig), false);
  Json reply = show_rig(s);
  reply["notes"] = notes;
  return reply;
}

Json edit(Session& s, const Json& edits, bool mirror, bool continues) {
  try {
    s.rigs().edit(s.character, web::read_edits(edits), mirror, continues);
  } catch (const Error& error) {  // the option of the command is a box on the page
    std::string line = error.what();
    const std::string option = " (--no-mirror)";
    const size_t at = line.find(option);
    throw Error(at == std::string::npos ? line : line.erase(at, option.size()));
  }
  return show_rig(s);
}

// The weights of a rig.txt, or none where its skin lines are not of this mesh.
std::vector<std::vector<Influence>> weights_of_file(const std::string& skeleton, Character character) {
  try {
    read_skeleton(skeleton, true, &character);
    return std::move(character.influences);
  } catch (const Error&) {
    return {};
  }
}

Json load(Session& s, const std::string& mesh, const std::string& skeleton, uint32_t number) {
  Character character = read_mesh(mesh);
  if (!skeleton.empty()) read_skeleton(skeleton, false, &character);
  if (character.vertices.empty()) throw Error(mesh + ": has no vertices to bind");
  if (character.face_count() == 0) throw Error(mesh + ": has no faces to show; drop a mesh with polygons");
  JointChoice choice;
  if (!character.joints.empty()) {
    check_bindable(character);
    (void)infer_parents(&character.joints);
    choice = choose_joints(character, skeleton.empty() ? JointsFrom::kAuto : JointsFrom::kNames);
  }
  std::vector<std::vector<Influence>> reference =
      skeleton.empty() ? std::move(character.influences) : weights_of_file(skeleton, read_mesh(mesh));
  character.influences.clear();
  if (s.rigs_of.find(number) == s.rigs_of.end()) {
    web::Rig rig = web::rig_of_file(character, std::move(choice));
    s.rigs_of[number].start(std::move(rig));
  }
  s.number = number;
  character.joints = s.rigs().now().joints;
  s.surface = web::make_surface(character);
  s.character = std::move(character);
  s.rest.clear();
  for (const Vec3& p : s.character.vertices) s.rest.insert(s.rest.end(), {p.x, p.y, p.z});
  s.posed = s.rest;
  s.joints.clear();
  s.weights.clear();
  s.locked.clear();
  s.hints.clear();
  s.taken = {};
  const bool is_files = !s.rigs().now().predicted && reference.size() == s.character.vertices.size();
  const bool some = std::any_of(reference.begin(), reference.end(), [](const auto& row) { return !row.empty(); });
  s.reference = is_files && some ? std::move(reference) : std::vector<std::vector<Influence>>();
  show(s);
  Json reply = web::rig_json(s.rigs());
  reply["hasReference"] = !s.reference.empty();
  reply["name"] = s.character.name;
  reply["vertices"] = s.character.vertices.size();
  reply["faces"] = s.character.face_count();
  return reply;
}

// Half of the sum over joints of |weight - the file's weight|: the share of a vertex that moves otherwise. [V]
std::vector<float> differences(const Session& s) {
  std::vector<float> values(s.character.vertices.size(), 0);
  for (size_t v = 0; v < values.size(); ++v) {
    std::map<uint32_t, float> sums;
    for (const Influence& influence : s.character.influences[v]) sums[influence.joint] += influence.weight;
    for (const Influence& influence : s.reference[v]) sums[influence.joint] -= influence.weight;
    for (const auto& [joint, weight] : sums) values[v] += std::abs(weight) / 2;
  }
  return values;
}

std::vector<float> field(const std::vector<std::vector<Influence>>& rows, uint32_t joint) {
  std::vector<float> values(rows.size(), 0);
  for (size_t v = 0; v < rows.size(); ++v)
    for (const Influence& influence : rows[v])
      if (influence.joint == joint) values[v] = influence.weight;
  return values;
}

enum class ColourMode : uint32_t {
  kJoints = 0,   // joints' colours by weight
  kField,        // of one joint
  kDoubt,        // red: unsure
  kArtist,       // as kJoints, by the file's weights
  kArtistField,  // as kField, the same
  kDifference    // between the two
};

// Returns the mean of what is shown: of kDifference twice it is the L1 of the READMEs.
double colour(Session& s, ColourMode mode, uint32_t joint) {
  std::vector<std::array<uint8_t, 3>> of_vertex;
  std::vector<float> values;
  const bool is_artist =
      mode == ColourMode::kArtist || mode == ColourMode::kArtistField || mode == ColourMode::kDifference;
  if (is_artist && s.reference.empty())
    throw Error(s.character.name + ": the file has no weights of its own to compare with");
  if (mode == ColourMode::kJoints) {
    of_vertex = weight_colours(s.character);
  } else if (mode == ColourMode::kArtist) {
    std::swap(s.character.influences, s.reference);
    of_vertex = weight_colours(s.character);
    std::swap(s.character.influences, s.reference);
  } else {
    values.assign(s.character.vertices.size(), 0);
    if (mode == ColourMode::kField) values = field(s.character.influences, joint);
    if (mode == ColourMode::kArtistField) values = field(s.reference, joint);
    if (mode == ColourMode::kDifference) values = differences(s);
    for (size_t v = 0; v < values.size() && mode == ColourMode::kDoubt; ++v)
      values[v] = 1.0f - static_cast<float>(s.confidence[v]) / 255.0f;
    of_vertex = heat_colours(values, 1.0f);
  }
  s.colours.clear();
  for (const uint32_t v : s.surface.vertex_of)
    s.colours.insert(s.colours.end(), of_vertex[v].begin(), of_vertex[v].end());
  double sum = 0;
  for (const float value : values) sum += static_cast<double>(value);
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
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

void paint(Session& s, const web::Stroke& stroke) {
  end_preview(s);
  if (s.hints.empty()) s.hints.assign(s.character.vertices.size(), 0);
  web::paint(s.character, s.posed, stroke, s.slots, &s.character.influences, &s.hints);
  fill_slots(s);
}

// Returns {bends} of joints that are turned by `least_degrees` or more, see Skinning.
Json show_pose(Session& s, const std::vector<Affine>& palette, web::SkinMethod method, double least_degrees) {
  s.palette.clear();
  s.joint_positions.clear();
  for (size_t j = 0; j < palette.size(); ++j) {
    const Vec3& rest = s.character.joints[j].position;
    for (const double x : palette[j]) s.palette.push_back(static_cast<float>(x));
    for (const double x : transform_point(palette[j], rest.x, rest.y, rest.z))
      s.joint_positions.push_back(static_cast<float>(x));
  }
  s.skinning.pose({s.character, s.rest, s.joints, s.weights, s.slots}, palette, method, &s.posed);
  show(s);
  return {{"bends", s.skinning.bends(s.character, palette, least_degrees, s.posed)}};
}

// turns: [J x 3] degrees about x, then y, then z.
Json pose(Session& s, const float* turns, web::SkinMethod method) {
  std::vector<JointTurn> list;
  for (size_t j = 0; j < s.character.joints.size(); ++j) {
    const float* const turn = turns + 3 * j;
    if (turn[0] != 0 || turn[1] != 0 || turn[2] != 0) list.push_back({j, turn[0], turn[1], turn[2]});
  }
  return show_pose(s, pose_palette(s.character, list), method, kLeastPosedDegrees);
}

web::SkinMethod skin_method(uint32_t number) {
  if (number > static_cast<uint32_t>(web::SkinMethod::kVolume)) throw Error("no such skinning");
  return static_cast<web::SkinMethod>(number);
}

web::MotionMethod motion_method(uint32_t number) {
  if (number > static_cast<uint32_t>(web::MotionMethod::kReferencePoints)) throw Error("no such method");
  return static_cast<web::MotionMethod>(number);
}

void need_weights(const Session& s) {
  if (s.weights.empty()) throw Error("no character is bound yet");
}

}  // namespace

extern "C" {

// "auto" of this module: "simd128" or "ref".
EMSCRIPTEN_KEEPALIVE const char* web_kernel() { return sinew_kernel_name(sinew_kernel_select(SINEW_KERNEL_AUTO)); }
EMSCRIPTEN_KEEPALIVE const char* web_version() { return sinew_version(); }

// A model of weights, of skeletons or of hands: the file says which.
EMSCRIPTEN_KEEPALIVE const char* web_model(const char* path) {
  return answer([&]() -> Json {
    Session& s = session();
    const std::vector<uint8_t> bytes = read_file(path);
    OpenModel opened;
    opened.bytes.resize(bytes.size() / 8 + 1);
    if (!bytes.empty()) std::memcpy(opened.bytes.data(), bytes.data(), bytes.size());
    sinew_status status = sinew_rig_model_open(opened.bytes.data(), bytes.size(), &opened.model);
    const bool of_weights = status == SINEW_ERROR_MODEL_TASK;
    if (of_weights) status = sinew_model_open(opened.bytes.data(), bytes.size(), &opened.model);
    check(path, status);
    const bool of_hands = !of_weights && opened.model.feature_set == kHandsFeatureSet;
    const Json reply = {{"bytes", bytes.size()},
                        {"parameters", opened.model.parameter_count},
                        {"layers", opened.model.layer_count},
                        {"task", of_weights ? "weights"
                                 : of_hands ? "hands"
                                            : "skeletons"}};
    (of_weights ? s.bind_model : of_hands ? s.hands_model : s.rig_model) = std::move(opened);
    return reply;
  });
}

// skeleton: "" when the mesh file has its own or none. number: of the character; where one has been loaded before, it has
// the skeleton that it had last. A failure leaves the present character as it was.
EMSCRIPTEN_KEEPALIVE const char* web_load(const char* mesh, const char* skeleton, uint32_t number) {
  return answer([&] { return load(session(), mesh, skeleton, number); });
}

// A character that is open no more.
EMSCRIPTEN_KEEPALIVE void web_forget(uint32_t number) {
  if (number != session().number) session().rigs_of.erase(number);
}

// A new skeleton for the character. wishes: {upAxis, mirror, spine, toes, ends} as SkeletonOptions has them, and the
// number of a SkeletonDetail. Replies with notes on what the mesh does not show, too.
EMSCRIPTEN_KEEPALIVE const char* web_rig(const char* wishes) {
  return answer([&] { return predict(session(), Json::parse(wishes)); });
}

// continues: in the place of the step before, as the moves of one drag.
EMSCRIPTEN_KEEPALIVE const char* web_edit(const char* edits, uint32_t mirror, uint32_t continues) {
  return answer([&] { return edit(session(), Json::parse(edits), mirror != 0, continues != 0); });
}

EMSCRIPTEN_KEEPALIVE const char* web_undo_edit(uint32_t forward) {
  return answer([&] {
    Session& s = session();
    (void)(forward != 0 ? s.rigs().redo() : s.rigs().undo());
    return show_rig(s);
  });
}

EMSCRIPTEN_KEEPALIVE const char* web_rebind(const char* wish, const char* answers) {
  return answer([&] { return rebind(session(), read_wish(wish, nullptr), read_answers(answers)); });
}

// answers: [[vertex, kind, joint], ...], as sinew_answer has them.
EMSCRIPTEN_KEEPALIVE const char* web_bind(const char* wish, const char* answers) {
  return answer([&] { return bind_shown(session(), read_wish(wish, progress), read_answers(answers)); });
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
    web::Stroke one;
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

// method: web::SkinMethod. Returns {bends: [{joint, degrees, kept}]} of the joints that are turned.
EMSCRIPTEN_KEEPALIVE const char* web_pose(const float* turns, uint32_t method) {
  return answer([&] {
    need_weights(session());
    return pose(session(), turns, skin_method(method));
  });
}

// Clips of a .bvh or an animated glTF for the character as it is; "" closes what was open.
// wish: {upAxis, own, method, pins: [[joint, joint of the file or -1], ...]}, method a web::MotionMethod
EMSCRIPTEN_KEEPALIVE const char* web_motion(const char* path, const char* wish) {
  return answer([&]() -> Json {
    Session& s = session();
    need_weights(s);
    if (*path == 0) {
      s.player.close();
      return Json::object();
    }
    const Json json = Json::parse(wish);
    std::vector<sinew_map_pin> pins;
    for (const Json& pin : json.at("pins")) pins.push_back({pin.at(0).get<uint32_t>(), pin.at(1).get<int32_t>()});
    return s.player.open(path, s.character, json.at("upAxis").get<uint32_t>(), json.at("own").get<bool>(),
                         motion_method(json.at("method").get<uint32_t>()), pins);
  });
}

// The open motion by another method. Returns {clips}.
EMSCRIPTEN_KEEPALIVE const char* web_motion_method(uint32_t method) {
  return answer([&] { return session().player.use(motion_method(method)); });
}

// As web_pose(), of joints that are turned far; and {spots} as Player has them.
EMSCRIPTEN_KEEPALIVE const char* web_frame(uint32_t clip, double seconds, uint32_t method) {
  return answer([&] {
    Session& s = session();
    need_weights(s);
    Json reply = show_pose(s, s.player.palette(clip, seconds), skin_method(method), kLeastPlayedDegrees);
    reply["spots"] = s.player.spots(clip, seconds);
    return reply;
  });
}

// With the clips of the motion that is open.
EMSCRIPTEN_KEEPALIVE const char* web_write_glb(const char* path) {
  return answer([&] {
    need_weights(session());
    end_preview(session());
    GlbOptions options;
    options.motion = session().player.for_file();
    write_glb(path, session().character, options);
    return Json::object();
  });
}

EMSCRIPTEN_KEEPALIVE const char* web_write_rig(const char* path) {
  return answer([&] {
    need_weights(session());
    end_preview(session());
    write_rig(path, session().character);
    return Json::object();
  });
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
