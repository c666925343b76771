// SPDX-License-Identifier: MIT
// A picture becomes a character: outline, mesh, skeleton, weights.
#include "sinew_character/jobs/picture_job.hpp"

#include <memory>
#include <utility>

#include "sinew_character/models/models.hpp"
#include "sinew_character/picture/body_class.hpp"
#include "sinew_formats/file_kinds.hpp"

namespace sinew {

namespace {

// One class for what says which limbs there are and for what knows the bodies of pictures.
void settle_class(std::optional<BodyClass>* body, RigJobOptions* job) {
  const bool by_model = job->method != RigMethod::kShape && job->method != RigMethod::kRegions;
  if (job->category != SINEW_CATEGORY_ANY)
    *body = body_of_category(job->category);
  else if (*body && *body != BodyClass::kOther && by_model)
    job->category = category_of(**body);
}

PictureCharacter figure_in(const std::string& path, const PictureJobOptions& options) {
  PictureCharacter out;
  const auto picture = std::make_shared<const PictureFile>(read_picture(path));
  out.figure = !options.outline.empty() ? figure_of_outline(*picture, options.outline, options.figure)
               : !options.mask.empty()  ? figure_of_mask(*picture, read_picture(options.mask), options.figure)
                                        : find_figure(*picture, options.figure);
  out.picture = picture;
  out.options = options;
  out.body = options.body.value_or(BodyClass::kOther);
  return out;
}

}  // namespace

bool is_picture(const std::string& path) { return has_use(path, kReadsPicture); }

PictureCharacter open_picture(const std::string& path, const PictureJobOptions& options) {
  PictureCharacter out = figure_in(path, options);
  out.rigged.character = picture_mesh(*out.picture, out.figure, options.mesh);
  return out;
}

void rig_picture(const RigJobOptions& job, const RigModels& given, PictureCharacter* picture) {
  RigModels models = given, bodies = given;
  bodies.hands = nullptr;                                           // a figure is a body
  if (job.detail == SkeletonDetail::kBody) models.hands = nullptr;  // whose hands are blots mostly
  PictureMeshOptions round = picture->options.mesh;
  round.flat = false;  // skeletons are found in what is round
  Character mesh = picture_mesh(*picture->picture, picture->figure, round);
  RigJobOptions facing = job;
  facing.up = Axis::kY;
  facing.front = SINEW_FRONT_PLUS_Z;
  std::optional<BodyClass> body = picture->options.body;
  settle_class(&body, &facing);
  SeenBody seen = see_body(mesh, body, class_of_outline(picture->figure.mask), facing, bodies, &mesh.notes);
  picture->rigged = rig_character(std::move(mesh), std::move(seen.skeleton), false, facing, models);
  picture->view = seen.view;
  picture->body = seen.body;
  picture->certainty = seen.certainty;
  if (picture->options.mesh.flat) flatten(&picture->rigged.character);
}

PictureCharacter rig_picture(const std::string& path, const PictureJobOptions& options, const RigJobOptions& job,
                             const RigModels& models) {
  PictureCharacter out = figure_in(path, options);
  rig_picture(job, models, &out);
  return out;
}

PictureCharacter rig_picture(const std::string& path, const PictureJobOptions& options, const RigJobOptions& job) {
  const std::unique_ptr<LoadedModel> rig = load_model("", ModelUse::kRig), bind = load_model("");
  const RigModels models = {&rig->model, &bind->model, nullptr, nullptr};
  return rig_picture(path, options, job, models);
}

}  // namespace sinew
