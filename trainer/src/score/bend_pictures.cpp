// SPDX-License-Identifier: MIT
// One rotated joint, seen from the side on which it bends, by linear skinning and by the engine's deformer; under
// cloth, skin that comes through shows in its own color.
#include "score/bends.hpp"
#include "sinew/deform.h"
#include "sinew_character/bind/transfer.hpp"
#include "sinew_character/check/surface_faults.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_character/page/html.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_trainer/report.hpp"

namespace sinew {
namespace {

constexpr float kRadius = 0.16f;     // of the longest side: what a picture shows
constexpr double kMostDegrees = 90;  // beyond, a limb comes through its own other half, whatever it wears
constexpr std::array<uint8_t, 3> kSkin = {235, 120, 80}, kCloth = {150, 175, 205};

// Both layers as one mesh: the vertices of the skin, then those of the cloth.
Character layered(const Character& skin, const Character& cloth) {
  Character both = skin;
  const uint32_t first = static_cast<uint32_t>(skin.vertices.size());
  both.vertices.insert(both.vertices.end(), cloth.vertices.begin(), cloth.vertices.end());
  both.influences.insert(both.influences.end(), cloth.influences.begin(), cloth.influences.end());
  for (size_t f = 0; f < cloth.face_count(); ++f) {
    for (uint32_t i = cloth.face_offsets[f]; i < cloth.face_offsets[f + 1]; ++i)
      both.face_vertices.push_back(first + cloth.face_vertices[i]);
    both.face_offsets.push_back(static_cast<uint32_t>(both.face_vertices.size()));
  }
  return both;
}

}  // namespace

ReportPicture bend_pictures(const Character& character, Axis up, int side) {
  ReportPicture picture;
  picture.heading = "bends";
  picture.character = character.name;
  picture.note = "left linear skinning, right with the volume kept (sinew pose --deform volume)";
  const LabeledSkeleton labels = label_skeleton(character.joints);
  CharacterDeformer deformer(character, SINEW_INIT(sinew_deform_options));
  const std::vector<std::array<uint8_t, 3>> gray(character.vertices.size(), {200, 190, 180});
  for (const Bend& bend : report_bends()) {
    const size_t joint = bent_joint(character, labels, bend);
    if (joint == SIZE_MAX) continue;
    const auto [palette, view] = bent_view(character, joint, bend, bend.degrees, up, kRadius, side);
    const Character linear = apply_pose(character, palette), kept = deformer.pose_character(character, palette);
    picture.panels.push_back(
        {bend_text(bend, bend.degrees), encode_png(beside({render(linear, gray, view), render(kept, gray, view)}))});
  }
  return picture;
}

Clothing measure_clothing(const Character& character) {
  const std::optional<Dressed> dressed = take_apart(character);
  if (!dressed) return {};
  return {dressed->bends.size(), crossing_pairs(dressed->body, dressed->garment).size()};
}

ReportPicture garment_pictures(const Character& character, const sinew_model* model, Axis up, int side) {
  ReportPicture picture;
  picture.heading = "cloth";
  picture.columns = 4;
  picture.character = character.name;
  picture.note = "the body with the artist's weights; crossings: triangles of cloth and skin that do not cross at rest";
  std::optional<Dressed> dressed = take_apart(character);
  if (!dressed) return picture;
  struct Binding {
    const char* what;
    uint32_t method;
    bool garment;
  };
  constexpr Binding kBindings[] = {{"bound alone", SINEW_TRANSFER_REBIND, false},
                                   {"nearest point of the body", SINEW_TRANSFER_NEAREST, true},
                                   {"sinew transfer --garment", SINEW_TRANSFER_AUTO, true}};
  JointMapping same(character.joints.size());
  for (size_t j = 0; j < same.size(); ++j) same[j] = static_cast<int32_t>(j);
  const Character &skin = dressed->body, &cloth = dressed->garment;
  std::vector<Character> wholes;
  for (const Binding& binding : kBindings) {
    TransferOptions options;
    options.method = binding.method;
    options.garment = binding.garment;
    options.model = model;
    options.up_axis = options.source_up_axis = up;
    Character bound = cloth;
    bound.influences = transfer(skin, cloth, same, options).influences;
    wholes.push_back(layered(skin, bound));
  }
  CharacterDeformer deformer(wholes.back(), SINEW_INIT(sinew_deform_options));
  const auto at_rest = crossing_pairs(skin, cloth);
  std::vector<std::array<uint8_t, 3>> colors(skin.vertices.size(), kSkin);
  colors.resize(wholes.back().vertices.size(), kCloth);
  for (const auto& [bend, joint] : dressed->bends) {
    const double degrees = std::min(bend->degrees, kMostDegrees);
    const BentView bent = bent_view(character, joint, *bend, degrees, up, kRadius, side);
    const auto show = [&](const Character& posed, const char* what) {
      Character posed_skin = skin, posed_cloth = cloth;
      const auto border = posed.vertices.begin() + static_cast<std::ptrdiff_t>(skin.vertices.size());
      posed_skin.vertices.assign(posed.vertices.begin(), border);
      posed_cloth.vertices.assign(border, posed.vertices.end());
      const size_t count = new_crossings(at_rest, crossing_pairs(posed_skin, posed_cloth));
      picture.panels.push_back({bend_text(*bend, degrees) + ": " + what + ", " + html::count(count) + " crossings",
                                encode_png(render(posed, colors, bent.view))});
    };
    for (size_t w = 0; w < wholes.size(); ++w) show(apply_pose(wholes[w], bent.palette), kBindings[w].what);
    show(deformer.pose_character(wholes.back(), bent.palette), "the same with the volume kept");
  }
  return picture;
}

}  // namespace sinew
