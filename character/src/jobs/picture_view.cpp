// SPDX-License-Identifier: MIT
// From where a picture shows its character, by the skeletons that votes find.
#include "sinew_character/jobs/picture_view.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "picture/joints_inside.hpp"
#include "sinew_character/picture/body_class.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

// Near limbs lie before the body and far ones behind it, by this share of the longest side.
constexpr float kLayer = 0.006f;
// Below this ratio a class is hardly more probable than the next one, and the note has both.
constexpr float kUnsureClass = 0.5f;

std::vector<PictureView> views_of(BodyClass body, bool given) {
  using enum PictureView;
  if (given && body == BodyClass::kBiped) return {kFront};
  if (body == BodyClass::kQuadruped || body == BodyClass::kFish || body == BodyClass::kSnake)
    return {kFacesRight, kFacesLeft};
  return {kFront, kFacesRight, kFacesLeft};
}

Character turned_mesh(const Character& mesh, PictureView view) {
  Character out;
  out.name = mesh.name;
  out.face_offsets = mesh.face_offsets;
  out.face_vertices = mesh.face_vertices;
  for (const Vec3& v : mesh.vertices) out.vertices.push_back(from_picture(view, v));
  return out;
}

// Which joints are of a near limb (1), of a far one (-1) or of neither: by their side of the mirror plane, else by their names.
float layer_of(PictureView view, const PredictedSkeleton& skeleton, size_t joint) {
  if (view == PictureView::kFront) {
    const uint8_t c = skeleton.classes[joint];
    const bool arm = c == SINEW_CLASS_UPPER_ARM || c == SINEW_CLASS_FOREARM || c == SINEW_CLASS_HAND;
    return arm ? 1.0f : 0.0f;
  }
  const std::string& name = skeleton.joints[joint].name;
  const bool left = name.rfind("Left", 0) == 0, right = name.rfind("Right", 0) == 0;
  if (!left && !right) return 0;
  return left == (view == PictureView::kFacesLeft) ? 1.0f : -1.0f;
}

void lay_into_plane(const Character& mesh, PictureView view, PredictedSkeleton* skeleton) {
  take_forks_off(skeleton);
  const float size = box_of(mesh.vertices).longest_side();
  for (size_t j = 0; j < skeleton->joints.size(); ++j) {
    Vec3& position = skeleton->joints[j].position;
    position = to_picture(view, position);
    position.z = kLayer * size * layer_of(view, *skeleton, j);
  }
  if (view != PictureView::kFront) part_side_limbs(mesh, skeleton);
  move_joints_inside(mesh, skeleton);
  if (view == PictureView::kFront) return;
  skeleton->mirrored = false;  // about the picture plane, in which both sides now lie
  skeleton->partners.assign(skeleton->joints.size(), -1);
}

}  // namespace

const char* picture_view_text(PictureView view) {
  return view == PictureView::kFront        ? "from the front"
         : view == PictureView::kFacesRight ? "facing right"
                                            : "facing left";
}

Vec3 from_picture(PictureView view, const Vec3& p) {
  if (view == PictureView::kFront) return p;
  return view == PictureView::kFacesRight ? Vec3{-p.z, p.y, p.x} : Vec3{p.z, p.y, -p.x};
}

Vec3 to_picture(PictureView view, const Vec3& p) {
  if (view == PictureView::kFront) return p;
  return view == PictureView::kFacesRight ? Vec3{p.z, p.y, -p.x} : Vec3{-p.z, p.y, p.x};
}

SeenBody see_body(const Character& mesh, const std::optional<BodyClass>& given, const BodyGuess& guess,
                  const RigJobOptions& job, const RigModels& models, std::vector<std::string>* notes) {
  const BodyClass body = given.value_or(guess.body);
  const bool by_votes = job.method == RigMethod::kAuto || job.method == RigMethod::kVotes;
  RigJobOptions facing = job;
  facing.up = Axis::kY;
  facing.front = SINEW_FRONT_PLUS_Z;
  if (!given && by_votes) {
    facing.category = category_of(body);
    facing.category_guessed = true;
  }
  std::vector<SeenBody> seen;
  std::vector<std::vector<std::string>> said;
  for (const PictureView view : views_of(body, given.has_value())) {
    if (!by_votes && !seen.empty()) break;  // methods that know no bodies see the same from everywhere
    Character turned = turned_mesh(mesh, by_votes ? view : PictureView::kFront);
    SeenBody one;
    one.view = view;
    one.skeleton = predict_for_job(facing, models, &turned);
    one.body = body;
    seen.push_back(std::move(one));
    said.push_back(std::move(turned.notes));
  }
  const size_t best = choose_view(seen);
  SeenBody out = std::move(seen[best]);
  float rival = 1e9f;
  for (size_t s = 0; s < seen.size(); ++s)
    if (s != best) rival = std::min(rival, seen[s].skeleton.spread);
  // A spread of one and a half times the best one's is as good as never the right view.
  const float ratio = std::pow(rival / std::max(out.skeleton.spread, 1e-4f), 6.0f);
  out.certainty = given ? 1.0f : guess.certainty;
  if (!given && seen.size() > 1 && std::isfinite(ratio)) out.certainty *= ratio / (1 + ratio);
  notes->insert(notes->end(), said[best].begin(), said[best].end());
  if (!given) {
    const bool toss = guess.certainty < kUnsureClass;
    const std::string other = toss ? print(", or else as a %s (%.0f %%)", body_class_word(guess.second).c_str(),
                                           100 * static_cast<double>(guess.second_certainty))
                                   : std::string();
    notes->push_back(print("%sseen as a %s%s%s, a guess (%.0f %%)%s; choose with --class", toss ? "warning: " : "",
                           body_class_word(out.body).c_str(), by_votes ? " " : "",
                           by_votes ? picture_view_text(out.view) : "", 100 * static_cast<double>(out.certainty),
                           other.c_str()));
  }
  lay_into_plane(mesh, by_votes ? out.view : PictureView::kFront, &out.skeleton);
  return out;
}

}  // namespace sinew
