// SPDX-License-Identifier: MIT
// A picture becomes a character: outline, mesh, skeleton, weights. From there on it is one as any other.
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
  std::string mask;  // a picture that is bright where the figure is; empty: found
  Outline outline;   // closed lines round the figure, in place of what is found; empty: found
  FigureOptions figure;
  PictureMeshOptions mesh;
  std::optional<BodyClass> body;  // nullopt: found
  bool whole = false;             // limbs that are drawn against the body stay in one outline with it
};

struct PictureCharacter {
  std::shared_ptr<const PictureFile> picture;
  Figure figure;
  PictureJobOptions options;
  // Of rig_picture(), the body with its certainty, 0..1; 0: not rigged.
  PictureView view = PictureView::kFront;
  BodyClass body = BodyClass::kOther;
  float certainty = 0;
  RiggedCharacter rigged;  // a bare mesh before rig_picture()
};

// By the extension: the table's.
bool is_picture(const std::string& path);

// The figure and its mesh. Throws Error.
PictureCharacter open_picture(const std::string& path, const PictureJobOptions& options);
// A skeleton and weights. Of the class in PictureJobOptions and RigJobOptions::category one says what the other leaves open; where both
// are given, the job's counts. On failure `picture` is as it was. Throws Error.
void rig_picture(const RigJobOptions& job, const RigModels& models, PictureCharacter* picture);
// Both.
PictureCharacter rig_picture(const std::string& path, const PictureJobOptions& options, const RigJobOptions& job,
                             const RigModels& models);
// By the bundled models.
PictureCharacter rig_picture(const std::string& path, const PictureJobOptions& options = {},
                             const RigJobOptions& job = {});

}  // namespace sinew
#endif
