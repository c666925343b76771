// SPDX-License-Identifier: MIT
// A picture becomes a character: outline, mesh, skeleton, weights. From there on it is one as any other.
#ifndef SINEW_CHARACTER_PICTURE_JOB_HPP
#define SINEW_CHARACTER_PICTURE_JOB_HPP

#include <optional>
#include <string>

#include "sinew_character/picture_view.hpp"
#include "sinew_picture/figure.hpp"
#include "sinew_picture/picture_mesh.hpp"

namespace sinew {

struct PictureJobOptions {
  std::string mask;  // a picture that is bright where the figure is; empty: found
  FigureOptions figure;
  PictureMeshOptions mesh;
  std::optional<BodyClass> body;  // nullopt: found
};

struct PictureCharacter {
  PictureFile picture;
  Figure figure;
  PictureView view = PictureView::kFront;
  BodyClass body = BodyClass::kOther;
  float certainty = 1;
  RiggedCharacter rigged;
};

// By the extension, .png, .jpg or .jpeg.
bool is_picture(const std::string& path);

// Throws Error.
PictureCharacter rig_picture(const std::string& path, const PictureJobOptions& options, const RigJobOptions& job,
                             const RigModels& models);
// By the bundled models and every default.
PictureCharacter rig_picture(const std::string& path, const PictureJobOptions& options = {});

}  // namespace sinew
#endif
