// SPDX-License-Identifier: MIT
// sinew rig: a bare mesh in, a skeleton with weights out.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bind_summary.hpp"
#include "commands.hpp"
#include "option_groups.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "rig_options.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_character/jobs/rig_job.hpp"
#include "sinew_character/pose/character_transform.hpp"
#include "sinew_character/predict/skeleton_template.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct RigCommandSettings {
  std::string hands_model, front_model;
  std::string mesh, output, model, bind_model, png, up = "auto", format = "glb", prediction, skeleton, to_pose;
  bool pose_preferred = false;
  SkeletonDetail detail = SkeletonDetail::kBody;
  uint32_t front = SINEW_FRONT_AUTO;
  MethodOptions method;
  PictureOptions picture;
  std::vector<SkeletonEdit> edits;
  CharacterTransform transform;
  unsigned spine = 0, influences = 4;
  StyleOptions style;
  ProfileSettings profile;
  bool mirror = false, no_mirror = false, no_toes = false, no_ends = false, no_bind = false, json = false,
       keep_lengths = false, gate = false, cut = false;
};

struct Models {
  std::unique_ptr<LoadedModel> rig, bind, hands, front;
};

Models load_models(const RigCommandSettings& s) {
  Models models;
  if (s.prediction.empty() && !s.method.extracts())
    models.rig = load_model(s.model, s.method.slots() ? ModelUse::kSlotJoints : ModelUse::kRig);
  if (!s.no_bind) models.bind = load_model(s.bind_model);
  if (s.detail != SkeletonDetail::kBody || s.method.method == RigMethod::kAuto)
    models.hands = load_model(s.hands_model, ModelUse::kHands);
  if (s.prediction.empty() && !is_picture(s.mesh) && (s.front == SINEW_FRONT_AUTO || s.up == "auto"))
    models.front = load_front_model(s.front_model);
  return models;
}

struct RiggedInput : RiggedCharacter {
  std::optional<PictureCharacter> picture;  // without its `rigged`, which is this
};

const Words kFronts = {"auto", "+z", "-z", "+x", "-x", "+y", "-y"};  // by sinew_front

RigJobOptions job_options(const RigCommandSettings& s) {
  RigJobOptions job;
  job.method = s.method.method;
  job.category = s.method.category;
  job.detail = s.detail;
  job.mirror = s.mirror ? SINEW_MIRROR_ALWAYS : s.no_mirror ? SINEW_MIRROR_NEVER : SINEW_MIRROR_AUTO;
  if (s.up != "auto") job.up = axis_of(s.up);
  job.front = s.front;
  job.spine_count = s.spine;
  job.toes = !s.no_toes;
  job.ends = !s.no_ends;
  job.bind = !s.no_bind;
  job.keep_lengths = s.keep_lengths;
  job.gate = s.gate;
  job.cut = s.cut;
  job.to_pose = s.to_pose;
  job.pose_preferred = s.pose_preferred;
  job.influence_count = s.influences;
  BindOptions style;
  style.method = SINEW_METHOD_MODEL;
  apply_style(s.style, &style);
  job.rigid_parts = style.rigid_parts;
  job.softness_percent = style.softness_percent;
  job.surface_vertices = style.surface_vertices;
  job.edits = s.edits;
  job.skeleton = s.skeleton;
  return job;
}

RiggedInput rig_one(const RigCommandSettings& s, const Models& models, const std::string& path) {
  const auto opened = [](const std::unique_ptr<LoadedModel>& model) { return model ? &model->model : nullptr; };
  const RigModels ready = {opened(models.rig), opened(models.bind), opened(models.hands), opened(models.front)};
  if (is_picture(path)) {
    PictureJobOptions figure = picture_job(s.picture);
    RigJobOptions job = job_options(s);
    std::swap(figure.figure.cut, job.cut);  // its figure is cut, not its mesh
    PictureCharacter made = rig_picture(path, figure, job, ready);
    RiggedInput rigged = {std::move(made.rigged), {}};
    rigged.picture = std::move(made);
    return rigged;
  }
  Character mesh = transformed(read_mesh(path), s.transform, axis_of(s.up));
  if (!s.prediction.empty()) {
    Character file;
    read_skeleton(s.prediction, false, &file);
    PredictedSkeleton given = skeleton_from_joints(file.joints);
    given.up_axis = axis_of(s.up);
    return {rig_character(std::move(mesh), std::move(given), true, job_options(s), ready), {}};
  }
  return {rig_character(std::move(mesh), job_options(s), ready), {}};
}

Json summary_json(const RigCommandSettings& s, const RiggedInput& rigged, const std::string& mesh,
                  const std::string& output) {
  const PredictedSkeleton& skeleton = rigged.skeleton;
  Json json = {{"sinew_rig", 1}};
  json["mesh"] = mesh;
  json["output"] = output;
  json["vertices"] = rigged.character.vertices.size();
  json["symmetric"] = skeleton.mirrored;
  json["spread"] = skeleton.spread;
  if (skeleton.usable) json["usable"] = std::round(100.0 * static_cast<double>(*skeleton.usable)) / 100;
  if (rigged.picture) json["picture"] = picture_json(*rigged.picture);
  if (s.prediction.empty() && !rigged.picture) {
    json["up"] = skeleton.up_axis == Axis::kZ ? "z" : "y";
    json["up_certainty"] = skeleton.up_confidence;
    json["front"] = skeleton.front;
    json["front_certainty"] = skeleton.front_confidence;
  }
  json["seconds"] = skeleton.seconds;
  json["workspace_bytes"] = skeleton.workspace_bytes;
  if (rigged.fitted) {
    json["skeleton"] = s.skeleton;
    json["matched"] = rigged.fitted->matched;
    json["scale"] = rigged.fitted->scale;
  }
  if (!s.no_bind) json["bind_seconds"] = rigged.bind_seconds;
  for (size_t j = 0; j < skeleton.joints.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    Json one;
    one["name"] = joint.name;
    one["parent"] = joint.parent < 0 ? "" : skeleton.joints[static_cast<size_t>(joint.parent)].name;
    one["position"] = {joint.position.x, joint.position.y, joint.position.z};
    one["end"] = skeleton.ends[j] != 0;
    one["confidence"] = skeleton.confidence[j];
    one["parent_confidence"] = skeleton.parent_confidence[j];
    json["joints"].push_back(std::move(one));
  }
  json["doubtful"] = Json::array();
  for (const LimbDoubt& limb : rigged.doubtful)
    json["doubtful"].push_back(
        {{"name", limb.name}, {"doubt", std::round(100.0 * static_cast<double>(limb.doubt)) / 100}});
  if (!s.no_bind) json["seams"] = seams_json(rigged.character.joints, rigged.seams);
  json["notes"] = rigged.character.notes;
  if (s.gate) {
    const GateFigures& figures = rigged.gate_figures;
    json["gate"] = {
        {"usable", figures.usable},         {"front", figures.front},       {"weak_parents", figures.weak_parents},
        {"unweighted", figures.unweighted}, {"exploded", figures.exploded}, {"fails", rigged.gate}};
  }
  return json;
}

void tell(const RigCommandSettings& s, const RiggedInput& rigged, const std::string& mesh, const std::string& output,
          std::FILE* out) {
  if (s.json) {
    std::fprintf(out, "%s\n", json_line(summary_json(s, rigged, mesh, output)).c_str());
    return;
  }
  const PredictedSkeleton& skeleton = rigged.skeleton;
  size_t joints = 0;
  for (const uint8_t end : skeleton.ends) joints += end == 0 ? 1 : 0;
  if (rigged.fitted)
    std::fprintf(out, "%s: fitted %s, %zu of its %zu joints by anatomy, the others along with them\n",
                 printable(mesh).c_str(), printable(s.skeleton).c_str(), rigged.fitted->matched,
                 rigged.fitted->joints.size());
  std::fprintf(out, "%s: %zu joints and %zu bone ends, %s; %.0f ms%s\n", printable(mesh).c_str(), joints,
               skeleton.joints.size() - joints, skeleton.mirrored ? "symmetric" : "not symmetric",
               1e3 * skeleton.seconds, s.no_bind ? "" : print(", weights %.0f ms", 1e3 * rigged.bind_seconds).c_str());
  for (const std::string& note : rigged.character.notes) std::fprintf(out, "  %s\n", printable(note).c_str());
  if (output != "-") std::fprintf(out, "wrote %s\n", printable(output).c_str());
}

// The joints of limbs that may be wrong; of a skeleton of the user's own those that lie where such joints were.
std::vector<uint8_t> doubtful_joints(const RiggedInput& rigged) {
  const std::vector<Joint>& joints = rigged.character.joints;
  std::vector<uint8_t> doubtful(joints.size(), 0);
  for (const LimbDoubt& limb : rigged.doubtful)
    for (const int one : limb.joints) {
      const Vec3& at = rigged.skeleton.joints[static_cast<size_t>(one)].position;
      for (size_t j = 0; j < joints.size(); ++j)
        if (joints[j].position.x == at.x && joints[j].position.y == at.y && joints[j].position.z == at.z)
          doubtful[j] = 1;
    }
  return doubtful;
}

void write_rigged(const RigCommandSettings& s, const std::string& output, RiggedInput* made) {
  RiggedInput& rigged = *made;
  write_as(s.profile, output, rigged.character, &rigged.character.notes);
  if (rigged.picture) write_mask(s.picture, *rigged.picture);
  if (s.png.empty()) return;
  RenderOptions view;
  if (rigged.picture) view.yaw_degrees = view.pitch_degrees = 0;
  view.up = rigged.skeleton.up_axis;
  view.red_joints = doubtful_joints(rigged);
  const auto colors = rigged.character.influences.empty()
                          ? heat_colors(std::vector<float>(rigged.character.vertices.size(), 0.0f), 1.0f)
                          : weight_colors(rigged.character);
  write_file(s.png, encode_png(render(rigged.character, colors, view)));
}

void run_rig_folder(const RigCommandSettings& s) {
  if (s.output.empty()) throw UsageError(s.mesh + " is a folder; give -o OUTDIR for its files");
  refuse_given(
      {{"--png", !s.png.empty()}, {"--prediction", !s.prediction.empty()}, {"--controls", !s.profile.controls.empty()}},
      " takes one mesh, but " + s.mesh + " is a folder");
  check_skeleton_source(s.skeleton);
  const std::vector<FolderFile> files = folder_files(s.mesh, s.output, "." + s.format, true);
  const Models models = load_models(s);
  size_t failed = 0, wanting = 0;
  Progress progress(files.size(), "meshes");
  for (const FolderFile& file : files) {
    try {
      RiggedInput rigged = rig_one(s, models, file.mesh);
      make_folder(std::filesystem::path(file.output).parent_path().string());
      write_rigged(s, file.output, &rigged);
      if (s.json) progress.say(stdout, json_line(summary_json(s, rigged, file.mesh, file.output)));
      wanting += rigged.gate.empty() ? 0 : 1;
      for (const std::string& line : rigged.gate)
        progress.say(stderr, "sinew: gate: " + printable(file.mesh + ": " + line));
    } catch (const Error& error) {
      ++failed;
      progress.say(stderr, "sinew: error: " + printable(error.what()));
    }
    progress.step();
  }
  check_failed(failed, files.size(), "meshes");
  if (!s.json) std::printf("wrote %zu files to %s\n", files.size(), printable(s.output).c_str());
  if (wanting > 0)
    throw GateError(std::to_string(wanting) + " of " + std::to_string(files.size()) +
                    " meshes fail the gate, see above; their files are written");
}

void run_rig(RigCommandSettings s) {
  s.pose_preferred = settle_profile(s.profile, &s.to_pose);
  if (s.mirror && s.no_mirror) throw UsageError("--mirror and --no-mirror: give one of the two");
  if (s.keep_lengths && s.skeleton.empty()) throw UsageError("--keep-lengths needs your own skeleton; give --skeleton");
  if (!s.to_pose.empty() && s.no_bind) throw UsageError("--to-pose moves the mesh by its weights: leave out --no-bind");
  if (s.cut && s.no_bind && !is_picture(s.mesh)) throw UsageError("--cut finds seams by weights: leave out --no-bind");
  if (!s.hands_model.empty() && s.detail == SkeletonDetail::kBody)
    throw UsageError("--hands-model needs --detail hands or full");
  const std::string& front = kFronts[s.front];
  if (s.front != SINEW_FRONT_AUTO && front[1] == s.up[0])
    throw UsageError("--front " + front + " is along --up " + s.up + ": give a horizontal axis");
  if (is_picture(s.mesh))
    refuse_given({{"--up", s.up != "auto"},
                  {"--front", s.front != SINEW_FRONT_AUTO},
                  {"--prediction", !s.prediction.empty()},
                  {"--turn, --height or --floor", !is_identity(s.transform)}},
                 " are for meshes, but " + s.mesh + " is a picture");
  if (!s.prediction.empty() && !is_identity(s.transform))
    throw UsageError("--prediction uses the coordinates of the mesh: leave out --turn, --height and --floor");
  if (!s.prediction.empty() && !s.model.empty()) throw UsageError("--prediction replaces the model: leave out --model");
  std::error_code ignored;
  if (std::filesystem::is_directory(s.mesh, ignored)) return run_rig_folder(s);
  if (s.output.empty()) s.output = stem_of(s.mesh) + ".rigged" + container_of(s.profile);
  check_output(s.output, kWritesSkin, true);
  if (!s.png.empty()) check_output(s.png, {".png"});
  if (s.output == "-" && s.json)
    throw UsageError("-o - and --json both write to standard output; give the skeleton a file name");
  if (s.cut && !has_use(s.output, kWritesWithMesh) && !is_picture(s.mesh))
    throw UsageError("--cut changes the mesh, and rig.txt holds none; write a .glb");
  check_skeleton_source(s.skeleton);
  RiggedInput rigged = rig_one(s, load_models(s), s.mesh);
  write_rigged(s, s.output, &rigged);
  tell(s, rigged, s.mesh, s.output, s.output == "-" ? stderr : stdout);
  if (!rigged.gate.empty()) throw GateError(s.mesh + ": fails the gate: " + rigged.gate.front() + "; check the output");
}

// Options that most meshes need.
void add_rig_inputs(CLI::App* sub, RigCommandSettings* s) {
  sub->add_option("mesh", s->mesh,
                  "Mesh, picture of a character (" + picture_files() +
                      "), or a folder: all meshes in it and its subfolders, or all pictures if there are no meshes. " +
                      mesh_files() + ", or - for an OBJ on standard input")
      ->required()
      ->type_name("MESH|PICTURE|DIR");
  shared_option(sub, "-o,--output", s->output, skin_output_text("for a folder, a folder"))
      ->default_str("MESH.rigged.glb");
  shared_option(sub, "--skeleton", s->skeleton,
                "Fitted into the mesh, with its own names and hierarchy: " + skeleton_files() + " or template:NAME");
  sub->add_flag_callback(
      "--list-templates",
      [] {
        for (const TemplateInfo& one : skeleton_templates())
          std::printf("template:%-12s %s\n", one.name.c_str(), one.about.c_str());
        throw CLI::Success();
      },
      "List the built-in skeletons for --skeleton");
  shared_word_option(sub, "--detail", s->detail, kCharacterDetail,
                     "body: down to the hands; hands: also fingers, where the mesh has them; full: also a jaw, and "
                     "eyes that are separate spheres");
  add_method_options(sub, &s->method);
  sub->add_flag("--no-bind", s->no_bind, "Write the skeleton only, without weights");
  add_influences(sub, s->influences);
  shared_option(sub, "--up", s->up, "auto: y for glTF, else found")
      ->check(CLI::IsMember({"auto", "y", "z"}))
      ->capture_default_str();
  word_option(sub, "--front", s->front, kFronts, "Direction that the mesh faces. auto: found, at any angle")
      ->type_name("AXIS");
  shared_option(sub, "--png", s->png, "The mesh with its joints, colored by weight");
  shared_flag(sub, "--json", s->json, "Joints with confidences; for a folder, one line per mesh");
  sub->add_flag("--gate", s->gate,
                "Exit with status 3 if the result is doubtful, for pipelines: doubtful votes, joints with uncertain "
                "parents, vertices without weight, or a mesh that tears in a test pose. Files are written anyway");
}

void add_shape_options(CLI::App* sub, RigCommandSettings* s) {
  section(sub, "Skeleton");
  sub->add_flag("--mirror", s->mirror, "Make both sides equal even if the mesh is not symmetric");
  sub->add_flag("--no-mirror", s->no_mirror, "Predict the sides separately even if the mesh is symmetric");
  sub->add_option("--spine", s->spine,
                  "Number of spine joints between the hips and the neck. By default the model decides")
      ->check(CLI::Range(1, 16))
      ->type_name("N");
  sub->add_flag("--no-toes", s->no_toes, "Leave out toe joints");
  sub->add_flag("--no-ends", s->no_ends, "Leave out NAME_end joints at chain ends");
  shared_flag(sub, "--cut", s->cut, kPictureCut);
  shared_option(
      sub, "--to-pose", s->to_pose,
      "The mesh follows, its bends keep their volume, and the result is bound in that pose; fused parts are cut first");
  sub->add_flag("--keep-lengths", s->keep_lengths,
                "With --skeleton: rotate its bones and scale them all by one factor");
  sub->add_option("--prediction", s->prediction,
                  "Use the skeleton of this file instead of a prediction. Its names determine the anatomy")
      ->type_name("FILE");
}

void add_models(CLI::App* sub, RigCommandSettings* s) {
  section(sub, "Models and files");
  shared_option(sub, "--model", s->model, "It predicts skeletons")->default_str("bundled");
  sub->add_option("--bind-model", s->bind_model, "Model of weights")->type_name("FILE")->default_str("bundled");
  sub->add_option("--hands-model", s->hands_model, "Model of hands, for --detail hands or full")
      ->type_name("FILE")
      ->default_str("bundled");
  sub->add_option("--front-model", s->front_model, "Model of the front direction")
      ->type_name("FILE")
      ->default_str("bundled");
  shared_option(sub, "--format", s->format, "For a folder")
      ->check(CLI::IsMember(format_names(kWritesSkin)))
      ->capture_default_str();
}

}  // namespace

void add_rig(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("rig", "Make a skeleton for a bare mesh and bind the mesh to it");
  auto s = std::make_shared<RigCommandSettings>();
  add_rig_inputs(sub, s.get());
  add_picture_options(sub, &s->picture);
  section(sub, "Edits");
  auto edits = std::make_shared<EditOptions>(sub);
  add_transform_options(sub, &s->transform);
  add_shape_options(sub, s.get());
  add_style_options(sub, &s->style);
  add_models(sub, s.get());
  add_profile_options(sub, &s->profile);
  add_controls_option(sub, &s->profile);
  sub->footer(
      "Examples:\n  sinew rig hero.obj -o hero.glb --png hero.png\n  sinew rig hero.obj --skeleton template:mixamo -o "
      "hero.glb\n  sinew rig drawing.png -o drawing.glb\n  sinew rig meshes -o rigged\n\n  sinew rig hero.obj "
      "--no-bind -o hero.rig.txt && sinew bind hero.obj --skeleton hero.rig.txt\n  sinew rig hero.obj --move "
      "LeftHand=0.7,1.4,0 --add Tail=Hips:0,0.9,-0.2 --remove Spine2\n  sinew rig machine.obj --method shape -o "
      "machine.glb\n  sinew rig hero.obj --detail hands --for vrm --author \"Ann Artist\" -o hero.vrm\nEdits apply in "
      "order, before binding, and to both sides if the skeleton is symmetric (--no-mirror: to one).");
  sub->callback([s, edits, sub] {
    check_method(*sub, s->method);
    check_picture_options(*sub, s->mesh);
    s->edits = edits->in_order();
    run_rig(*s);
  });
}

}  // namespace sinew::cli
