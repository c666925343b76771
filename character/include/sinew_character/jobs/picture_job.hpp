// SPDX-License-Identifier: MIT
// Makes a character from a picture: outline, mesh, skeleton, weights. The result is an ordinary character.
#ifndef SINEW_CHARACTER_PICTURE_JOB_HPP
#define SINEW_CHARACTER_PICTURE_JOB_HPP

#include <memory>
#include <optional>
#include <string>

#include "sinew_character/jobs/picture_view.hpp"
#include "sinew_character/picture/figure.hpp"
#include "sinew_character/picture/picture_mesh.hpp"

namespace sinew {

struct PictureJobOptions {
  std::string mask;  // mask of the figure, bright inside; empty: found
  Outline outline;   // closed lines around the figure; empty: found
  FigureOptions figure;
  PictureMeshOptions mesh;
  std::optional<BodyClass> body;  // nullopt: found
  bool whole = false;             // limbs drawn against the body stay in one outline with it
};

struct PictureCharacter {
  std::shared_ptr<const PictureFile> picture;
  Figure figure;
  PictureJobOptions options;
  // From rig_picture(): the body class with its certainty, 0..1; 0: not rigged.
  PictureView view = PictureView::kFront;
  BodyClass body = BodyClass::kOther;
  float certainty = 0;
  RiggedCharacter rigged;  // a bare mesh before rig_picture()
};

// Returns whether the extension is that of a picture.
bool is_picture(const std::string& path);

// Finds the figure and makes its mesh. Throws Error.
PictureCharacter open_picture(const std::string& path, const PictureJobOptions& options);
// Makes a skeleton and weights. The class is RigJobOptions::category if given, else that in PictureJobOptions. Throws
// Error and then leaves `picture` unchanged.
void rig_picture(const RigJobOptions& job, const RigModels& models, PictureCharacter* picture);
// Reads and rigs a picture.
PictureCharacter rig_picture(const std::string& path, const PictureJobOptions& options, const RigJobOptions& job,
                             const RigModels& models);
// By the bundled models.
PictureCharacter rig_picture(const std::string& path, const PictureJobOptions& options = {},
                             const RigJobOptions& job = {});

}  // namespace sinew
#endif
