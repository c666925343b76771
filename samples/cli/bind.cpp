// SPDX-License-Identifier: MIT
// sinew bind: one mesh, one skeleton, weights out.
#include "sinew_formats/bind.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "sinew_datasets/image.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"
#include "style_options.hpp"
#include "support.hpp"
#include "thread_pool.hpp"

namespace sinew::cli {
namespace {

struct Settings {
  std::string mesh, skeleton, output, model, method, deform, never, lock, hints, png, png_confidence, up = "y";
  unsigned influences = 4, threads = 1;
  StyleOptions style;
  bool json = false, symmetric = false, confidence = false;
};

int show_progress(void* user, uint32_t done_permille) {
  uint32_t* shown = static_cast<uint32_t*>(user);
  if (done_permille / 10 != *shown) {
    *shown = done_permille / 10;
    std::fprintf(stderr, "\rbinding %3u %%", *shown);
    if (*shown >= 100) std::fprintf(stderr, "\r              \r");
    std::fflush(stderr);
  }
  return 0;
}

void set_flags(const Settings& settings, const Character& character, std::vector<uint8_t>* flags) {
  if (settings.deform.empty() && settings.never.empty()) return;
  flags->assign(character.joints.size(), 0);
  if (!settings.deform.empty()) {
    for (size_t j : read_joint_list(settings.deform, character)) (*flags)[j] |= SINEW_JOINT_DEFORMS;
  }
  if (!settings.never.empty()) {
    for (size_t j : read_joint_list(settings.never, character)) (*flags)[j] |= SINEW_JOINT_NEVER;
  }
}

void set_locks(const Settings& settings, const Character& character, std::vector<uint8_t>* locked) {
  if (settings.lock.empty()) return;
  if (character.influences.empty()) {
    throw Error(settings.lock + ": vertices can keep only weights they have, and neither " + settings.mesh +
                " nor its skeleton file brings any");
  }
  locked->assign(character.vertices.size(), 0);
  for (size_t v : read_vertex_list(settings.lock, character)) {
    if (character.influences[v].empty())
      throw Error(settings.lock + ": vertex " + std::to_string(v) + " has no weights to keep");
    (*locked)[v] = 1;
  }
}

// Rows of the hint file go where the mesh's own are; joints are matched by name.
void set_hints(const Settings& settings, Character* character, std::vector<uint8_t>* hints) {
  if (settings.hints.empty()) return;
  Character painted;
  painted.name = character->name;
  painted.vertices = character->vertices;
  painted.gltf = character->gltf;
  read_skeleton(settings.hints, true, &painted);
  std::vector<uint32_t> joint_of(painted.joints.size());
  for (size_t j = 0; j < painted.joints.size(); ++j) {
    const auto at = std::find_if(character->joints.begin(), character->joints.end(),
                                 [&](const Joint& joint) { return joint.name == painted.joints[j].name; });
    joint_of[j] = static_cast<uint32_t>(at - character->joints.begin());
  }
  hints->assign(character->vertices.size(), 0);
  character->influences.resize(character->vertices.size());
  size_t count = 0;
  for (size_t v = 0; v < painted.influences.size(); ++v) {
    if (painted.influences[v].empty()) continue;
    for (Influence& influence : painted.influences[v]) {
      if (joint_of[influence.joint] == character->joints.size()) {
        throw Error(settings.hints + ": vertex " + std::to_string(v) + " is painted with joint " +
                    painted.joints[influence.joint].name + ", which the skeleton does not have");
      }
      influence.joint = joint_of[influence.joint];
    }
    character->influences[v] = std::move(painted.influences[v]);
    (*hints)[v] = 1;
    ++count;
  }
  if (count == 0) throw Error(settings.hints + ": paints no vertex; expected weights (skin lines) for some of them");
}

// Vertices that are more likely wrong than right, and the joints that most of them went to.
struct Doubts {
  size_t vertices = 0;
  std::vector<std::string> joints;  // three at most, by falling number of vertices
};

Doubts find_doubts(const Character& character, const std::vector<uint8_t>& confidence) {
  Doubts doubts;
  std::vector<std::pair<size_t, size_t>> counts(character.joints.size());  // vertices, joints in reverse for ties
  for (size_t j = 0; j < counts.size(); ++j) counts[j].second = counts.size() - 1 - j;
  for (size_t v = 0; v < confidence.size(); ++v) {
    if (confidence[v] >= 128 || character.influences[v].empty()) continue;
    ++doubts.vertices;
    ++counts[character.influences[v][0].joint].first;
  }
  std::sort(counts.rbegin(), counts.rend());
  for (size_t i = 0; i < counts.size() && i < 3 && counts[i].first > 0; ++i)
    doubts.joints.push_back(character.joints[counts.size() - 1 - counts[i].second].name);
  return doubts;
}

void draw_confidence(const Settings& settings, const Character& character, const std::vector<uint8_t>& confidence) {
  std::vector<float> doubt;
  for (const uint8_t c : confidence) doubt.push_back(1.0f - static_cast<float>(c) / 255.0f);
  RenderOptions view;
  view.up_z = settings.up == "z";
  write_file(settings.png_confidence, encode_png(render(character, heat_colours(doubt, 1.0f), view)));
}

void run(Settings settings) {
  const bool to_stream = settings.output == "-";
  if (settings.output.empty()) settings.output = stem_of(settings.mesh) + ".bound.glb";
  check_output(settings.output, {".glb", ".rig.txt"}, true);
  if (!settings.png.empty()) check_output(settings.png, {".png"});
  if (!settings.png_confidence.empty()) check_output(settings.png_confidence, {".png"});
  if (settings.method == "heat" && !settings.model.empty())
    throw UsageError("--method heat uses no model: leave out --model");
  if (to_stream && settings.json)
    throw UsageError("-o - and --json both want standard output: give the weights a file name");

  Character character = read_mesh_and_skeleton(settings.mesh, settings.skeleton, !settings.lock.empty());
  BindOptions options;
  options.method = settings.method == "heat" ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  std::unique_ptr<LoadedModel> model;
  if (options.method == SINEW_METHOD_MODEL) {
    model = load_model(settings.model);
    options.model = &model->model;
  }
  options.influence_count = settings.influences;
  options.up_axis = settings.up == "z" ? 1 : 0;
  set_flags(settings, character, &options.joint_flags);
  set_locks(settings, character, &options.locked);
  set_hints(settings, &character, &options.hints);
  options.symmetric = settings.symmetric;
  apply_style(settings.style, &options);
  uint32_t shown = 0;
  if (isatty(STDERR_FILENO) != 0) {
    options.progress = show_progress;
    options.progress_user = &shown;
  }
  ThreadPool pool(settings.threads);
  options.thread_count = settings.threads;
  options.parallel_for = ThreadPool::parallel_for;
  options.parallel_user = &pool;
  BindResult result = bind(character, options);
  character.influences = std::move(result.influences);
  if (settings.confidence) character.confidence = result.confidence;
  const Doubts doubts = find_doubts(character, result.confidence);

  write_character(settings.output, character);
  if (!settings.png.empty()) {
    RenderOptions view;
    view.up_z = settings.up == "z";
    const std::vector<uint8_t> png = encode_png(render(character, weight_colours(character), view));
    write_file(settings.png, png);
  }
  if (!settings.png_confidence.empty()) draw_confidence(settings, character, result.confidence);

  size_t pairs = 0;
  std::vector<bool> used(character.joints.size(), false);
  for (const std::vector<Influence>& row : character.influences) {
    pairs += row.size();
    for (const Influence& i : row) used[i.joint] = true;
  }
  const size_t used_joints = static_cast<size_t>(std::count(used.begin(), used.end(), true));
  const double mean = static_cast<double>(pairs) / static_cast<double>(std::max<size_t>(1, character.vertices.size()));
  const std::string method = options.method == SINEW_METHOD_HEAT ? "heat"
                             : settings.model.empty()            ? "bundled model"
                                                                 : file_name(settings.model);
  if (settings.json) {
    nlohmann::ordered_json summary = {{"mesh", settings.mesh},
                                      {"method", method},
                                      {"vertices", character.vertices.size()},
                                      {"faces", character.face_count()},
                                      {"joints", character.joints.size()},
                                      {"joints_used", used_joints},
                                      {"influences", settings.influences},
                                      {"mean_influences", mean},
                                      {"seconds", result.seconds},
                                      {"workspace_bytes", result.workspace_bytes},
                                      {"workspace_used_bytes", result.used_bytes},
                                      {"output", settings.output}};
    if (!settings.png.empty()) summary["png"] = settings.png;
    if (!settings.png_confidence.empty()) summary["png_confidence"] = settings.png_confidence;
    summary["to_look_at"] = {{"vertices", doubts.vertices}, {"joints", doubts.joints}};
    if (settings.symmetric) summary["symmetric_vertices"] = result.symmetric_vertices;
    std::printf("%s\n", summary.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return;
  }
  std::FILE* out = to_stream ? stderr : stdout;
  std::fprintf(out, "%s: %zu vertices, %zu faces, %zu joints (%zu used)\n", character.name.c_str(),
               character.vertices.size(), character.face_count(), character.joints.size(), used_joints);
  std::fprintf(out, "bound with %s in %.3f s, %.1f MB workspace (%.1f MB used), %.2f influences per vertex\n",
               method.c_str(), result.seconds, static_cast<double>(result.workspace_bytes) / 1e6,
               static_cast<double>(result.used_bytes) / 1e6, mean);
  if (settings.symmetric && result.symmetric_vertices > 0) {
    std::fprintf(out, "%u of %zu vertices mirrored\n", result.symmetric_vertices, character.vertices.size());
  } else if (settings.symmetric) {
    std::fprintf(out, "not symmetric: too few vertices or joints have a mirror image, nothing was mirrored\n");
  }
  if (doubts.vertices > 0) {
    std::string names;
    for (const std::string& name : doubts.joints) names += (names.empty() ? "" : ", ") + name;
    std::fprintf(out, "%zu vertices to look at (less than half sure), mostly on %s\n", doubts.vertices, names.c_str());
  }
  std::string written = to_stream ? "standard output" : settings.output;
  for (const std::string& picture : {settings.png, settings.png_confidence})
    written += picture.empty() ? "" : " and " + picture;
  std::fprintf(out, "wrote %s\n", written.c_str());
}

}  // namespace

void add_bind(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("bind", "Predict the skin weights of a mesh for a skeleton");
  auto s = std::make_shared<Settings>();
  sub->add_option("mesh", s->mesh, "Mesh: .obj, .gltf, .glb, .vrm, or - for an OBJ on standard input")
      ->required()
      ->type_name("MESH");
  sub->add_option("--skeleton", s->skeleton,
                  "Skeleton: .rig.txt, .gltf, .glb or .vrm. Not needed when the mesh has its own")
      ->type_name("FILE");
  sub->add_option("-o,--output", s->output,
                  "Output: .glb or .rig.txt, - for rig.txt on standard output [MESH.bound.glb]")
      ->type_name("OUT");
  sub->add_option("--model", s->model, "Model file [the bundled one]")->type_name("FILE");
  sub->add_option("--method", s->method, "heat: heat fields alone, no model; model: the network")
      ->check(CLI::IsMember({"heat", "model"}));
  sub->add_option("--influences", s->influences, "Most joints per vertex")
      ->check(CLI::Range(1, 12))
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--deform", s->deform, "Joints that deform, one name per line; all others get no weight")
      ->type_name("FILE");
  sub->add_option("--never", s->never, "Joints that must get no weight, one name per line")->type_name("FILE");
  sub->add_option("--lock", s->lock, "Vertices that keep the weights they have, one 0-based index per line")
      ->type_name("FILE");
  sub->add_option(
         "--hints", s->hints,
         "Weights of some vertices, a .rig.txt with skin lines for these alone (or a glTF of the same mesh whose "
         "other vertices have none): they are kept and steer the vertices around them")
      ->type_name("FILE");
  sub->add_option("--up", s->up, "Axis that points up")->check(CLI::IsMember({"y", "z"}))->capture_default_str();
  sub->add_option("--threads", s->threads,
                  "Threads that work on the mesh, each with some memory of its own; the same bytes for any N")
      ->check(CLI::Range(1, static_cast<int>(SINEW_MAX_THREADS)))
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--png", s->png, "Also draw the mesh with its joints, coloured by weight")->type_name("FILE");
  add_style_options(sub, &s->style);
  sub->add_flag("--symmetric", s->symmetric,
                "Vertices and joints that are mirror images get mirrored weights, to the last bit; says so when the "
                "character has no mirror plane x = c");
  sub->add_flag("--confidence", s->confidence,
                "Also write how sure each vertex is, 0 to 1, as the attribute _CONFIDENCE of a .glb");
  sub->add_option("--png-confidence", s->png_confidence,
                  "Also draw where to look: dark blue = sure, yellow = half, red = not at all")
      ->type_name("FILE");
  sub->add_flag("--json", s->json, "Print the summary as JSON");
  sub->footer(
      "Examples:\n  sinew bind hero.obj --skeleton hero.rig.txt -o hero.glb --png hero.png\n"
      "  sinew bind hero.glb --method heat --influences 8 -o hero.rig.txt\n"
      "  sinew bind hero.obj --skeleton hero.rig.txt --hints painted.rig.txt -o hero.glb\n"
      "  cat hero.obj | sinew bind - --skeleton hero.rig.txt -o - > weights.rig.txt");
  sub->callback([s] { run(*s); });
}

}  // namespace sinew::cli
