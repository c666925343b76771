// SPDX-License-Identifier: MIT
#include "sinew_character/picture_job.hpp"

#include <memory>
#include <utility>

#include "sinew_character/models.hpp"
#include "sinew_formats/file_names.hpp"

namespace sinew {

bool is_picture(const std::string& path) {
  return has_extension(path, ".png") || has_extension(path, ".jpg") || has_extension(path, ".jpeg");
}

PictureCharacter rig_picture(const std::string& path, const PictureJobOptions& options, const RigJobOptions& job,
                             const RigModels& models) {
  PictureCharacter out;
  out.picture = read_picture(path);
  out.figure = options.mask.empty() ? find_figure(out.picture, options.figure)
                                    : figure_of_mask(out.picture, read_picture(options.mask), options.figure);
  PictureMeshOptions round = options.mesh;
  round.flat = false;  // skeletons are found in what is round
  Character mesh = picture_mesh(out.picture, out.figure, round);
  SeenBody seen = see_body(mesh, options.body, job, models, &mesh.notes);
  out.view = seen.view;
  out.body = seen.body;
  out.certainty = seen.certainty;
  RigJobOptions facing = job;
  facing.up = UpChoice::kY;
  facing.front = SINEW_FRONT_PLUS_Z;
  out.rigged = rig_character(std::move(mesh), std::move(seen.skeleton), false, facing, models);
  if (options.mesh.flat) flatten(&out.rigged.character);
  return out;
}

PictureCharacter rig_picture(const std::string& path, const PictureJobOptions& options) {
  const std::unique_ptr<LoadedModel> rig = load_model("", ModelUse::kRig), bind = load_model("");
  const RigModels models = {&rig->model, &bind->model, nullptr, nullptr};
  return rig_picture(path, options, {}, models);
}

}  // namespace sinew
