// SPDX-License-Identifier: MIT
// Characters of pictures: sinew_character_open_picture(), and what was found in one.
#include <utility>

#include "handle.hpp"

namespace sinew {
namespace {

Outline outline_given(const sinew_character_picture_options& options) {
  Outline outline;
  if (options.line_count == 0) return outline;
  need(options.line_offsets != nullptr && options.outline != nullptr, "outline, line_offsets");
  if (options.line_offsets[0] != 0) throw Failure(SINEW_ERROR_INDEX, "line_offsets: expected 0 first");
  for (uint32_t l = 0; l < options.line_count; ++l) {
    const uint32_t from = options.line_offsets[l], to = options.line_offsets[l + 1];
    if (to < from) throw Failure(SINEW_ERROR_INDEX, "line_offsets: they fall at line " + std::to_string(l));
    outline.emplace_back();
    for (uint32_t i = from; i < to; ++i)
      outline.back().push_back({options.outline[2 * size_t{i}], options.outline[2 * size_t{i} + 1]});
  }
  return outline;
}

PictureJobOptions job_of(const sinew_character_picture_options& options) {
  static_assert(uint32_t{SINEW_BODY_CLASS_OTHER} == static_cast<uint32_t>(BodyClass::kOther) + 1);
  check_at_most("body_class", options.body_class, SINEW_BODY_CLASS_OTHER);
  PictureJobOptions job;
  if (options.mask != nullptr) job.mask = options.mask;
  job.outline = outline_given(options);
  job.figure.number = options.figure;
  job.figure.cut = options.cut != 0;
  job.mesh.flat = options.flat != 0;
  job.mesh.pixels = options.pixels != 0;
  if (options.body_class != 0) job.body = static_cast<BodyClass>(options.body_class - 1);
  return job;
}

OutlineViews views_of(const Outline& outline) {
  OutlineViews views;
  views.offsets = {0};
  for (const auto& line : outline) {
    for (const auto& point : line) views.points.insert(views.points.end(), point.begin(), point.end());
    views.offsets.push_back(count32(views.points.size() / 2));
  }
  return views;
}

}  // namespace

std::shared_ptr<const PictureCharacter> without_mesh(PictureCharacter picture) {
  picture.rigged.character = {};
  return std::make_shared<const PictureCharacter>(std::move(picture));
}

void open_picture_into(const PictureJobOptions& options, sinew_character* opened) {
  PictureCharacter picture = open_picture(opened->path, options);
  opened->character = std::move(picture.rigged.character);
  opened->picture = without_mesh(std::move(picture));
}

}  // namespace sinew

using namespace sinew;

extern "C" {

sinew_status sinew_character_open_picture(const char* path, const sinew_character_picture_options* options,
                                          sinew_character** character) {
  return guarded(nullptr, [&] {
    need(path != nullptr, "path");
    need(character != nullptr, "character");
    auto opened = std::make_unique<sinew_character>();
    opened->path = path;
    open_picture_into(job_of(options_of(options)), opened.get());
    *character = opened.release();
  });
}

sinew_status sinew_character_open_picture_files(const sinew_file* files, uint32_t file_count,
                                                const sinew_character_picture_options* options,
                                                sinew_character** character) {
  return guarded(nullptr, [&] {
    need(character != nullptr, "character");
    auto opened = std::make_unique<sinew_character>();
    opened->files = bytes_of(files, file_count);
    opened->path = files[0].name;
    const FilesOf scope(*opened);
    open_picture_into(job_of(options_of(options)), opened.get());
    *character = opened.release();
  });
}

sinew_status sinew_character_picture(sinew_character* character, sinew_character_picture_info* info) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(info != nullptr, "info");
    check_result(info);
    if (character->picture == nullptr)
      throw Error(character->character.name + ": is not of a picture; open a .png or .jpg");
    const PictureCharacter& picture = *character->picture;
    sinew_character_picture_info filled = SINEW_INIT(sinew_character_picture_info);
    filled.width = picture.picture->pixels.width;
    filled.height = picture.picture->pixels.height;
    filled.figure_count = picture.figure.count;
    filled.figure = picture.figure.number;
    if (!picture.rigged.skeleton.joints.empty()) {
      filled.body_class = static_cast<uint32_t>(picture.body) + 1;
      filled.view = static_cast<uint32_t>(picture.view);
      filled.certainty = picture.certainty;
    }
    OutlineViews& views = character->outline;
    if (views.offsets.empty()) views = views_of(outline_of(picture.figure));
    filled.line_count = count32(views.offsets.size() - 1);
    filled.line_offsets = views.offsets.data();
    filled.outline = views.points.data();
    give(filled, info);
  });
}

}  // extern "C"
