// SPDX-License-Identifier: MIT
// A picture becomes a character: outline, mesh, skeleton, weights.
#include "sinew_character/jobs/picture_job.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "sinew_character/models/models.hpp"
#include "sinew_character/picture/body_class.hpp"
#include "sinew_character/picture/free_limbs.hpp"
#include "sinew_formats/file_kinds.hpp"

namespace sinew {

namespace {

bool by_model(const RigJobOptions& job) { return job.method != RigMethod::kShape && job.method != RigMethod::kRegions; }

// Converts between the category of limbs and the body class of pictures.
void settle_class(std::optional<BodyClass>* body, RigJobOptions* job) {
  if (job->category != SINEW_CATEGORY_ANY)
    *body = body_of_category(job->category);
  else if (*body && *body != BodyClass::kOther && by_model(*job))
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

// Arms of a body that is seen from the front, in pixels of the figure's mask: upper arm, forearm, hand and its end, as far as they are there.
std::vector<DrawnLimb> arms_in(const PredictedSkeleton& skeleton, const PicturePlane& plane) {
  const auto is_arm = [&](size_t j) {
    const uint8_t c = skeleton.classes[j];
    return c == SINEW_CLASS_UPPER_ARM || c == SINEW_CLASS_FOREARM || c == SINEW_CLASS_HAND;
  };
  std::vector<DrawnLimb> arms;
  std::array<float, 2> trunk = {};
  float count = 0, head = std::numeric_limits<float>::max();
  for (size_t j = 0; j < skeleton.joints.size(); ++j) {
    const uint8_t c = skeleton.classes[j];
    if (c == SINEW_CLASS_HEAD) head = std::min(head, skeleton.joints[j].position.y);
    if (skeleton.ends[j] != 0 || (c != SINEW_CLASS_PELVIS && c != SINEW_CLASS_SPINE)) continue;
    const auto at = plane.to_mask(skeleton.joints[j].position);
    trunk = {trunk[0] + at[0], trunk[1] + at[1]};
    ++count;
  }
  if (count == 0) return arms;
  for (size_t j = 0; j < skeleton.joints.size(); ++j) {
    if (skeleton.classes[j] != SINEW_CLASS_UPPER_ARM || skeleton.ends[j] != 0) continue;
    if (skeleton.joints[j].parent >= 0 && is_arm(static_cast<size_t>(skeleton.joints[j].parent))) continue;
    DrawnLimb arm = {skeleton.joints[j].name, {}, {trunk[0] / count, trunk[1] / count}};
    for (size_t at = j, before = skeleton.joints.size(); at != before;) {
      arm.points.push_back(plane.to_mask(skeleton.joints[at].position));
      before = at;
      for (size_t next = at + 1; next < skeleton.joints.size() && at == before; ++next)
        if (skeleton.joints[next].parent == static_cast<int>(at) && (is_arm(next) || skeleton.ends[next] != 0))
          at = next;
    }
    // A limb that begins over the head is hair or an ear, no arm.
    if (arm.points.size() > 2 && skeleton.joints[j].position.y < head) arms.push_back(std::move(arm));
  }
  return arms;
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
  Figure figure = picture->figure;
  const bool frontal = seen.body == BodyClass::kBiped && seen.view == PictureView::kFront && by_model(job);
  PicturePlane plane = picture_plane(figure, mesh);
  if (frontal && !picture->options.whole && free_limbs(arms_in(seen.skeleton, plane), &figure) > 0) {
    std::vector<std::string> notes = std::move(mesh.notes);
    notes.push_back(figure.notes.back());
    mesh = picture_mesh(*picture->picture, figure, round);
    mesh.notes = std::move(notes);
    plane = picture_plane(figure, mesh);
  }
  picture->rigged = rig_character(std::move(mesh), std::move(seen.skeleton), false, facing, models);
  picture->figure = std::move(figure);
  if (job.to_pose.empty()) close_slits(picture->figure, plane, &picture->rigged.character);
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
