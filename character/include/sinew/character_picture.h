/* SPDX-License-Identifier: MIT
 * Characters from drawings and photographs: include sinew/character.h, which says what all calls share. */
#ifndef SINEW_CHARACTER_PICTURE_H
#define SINEW_CHARACTER_PICTURE_H

#include "sinew/character_file.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The numbers of sinew_category, and what is none of them. */
typedef enum sinew_body_class {
  SINEW_BODY_CLASS_FOUND = 0, /* by the votes of the model */
  SINEW_BODY_CLASS_BIPED = 1,
  SINEW_BODY_CLASS_QUADRUPED = 2,
  SINEW_BODY_CLASS_BIRD = 3,
  SINEW_BODY_CLASS_FISH = 4,
  SINEW_BODY_CLASS_SNAKE = 5,
  SINEW_BODY_CLASS_MANY_LEGGED = 6,
  SINEW_BODY_CLASS_OTHER = 7
} sinew_body_class;

/* The side from which a picture shows its character. */
typedef enum sinew_picture_view {
  SINEW_PICTURE_VIEW_FRONT = 0,
  SINEW_PICTURE_VIEW_FACES_RIGHT = 1,
  SINEW_PICTURE_VIEW_FACES_LEFT = 2
} sinew_picture_view;

typedef struct sinew_character_picture_options {
  uint32_t struct_size;
  /* sinew_body_class */
  uint32_t body_class;
  /* Which of several figures, from left to right, from 1 on; 0: the largest. */
  uint32_t figure;
  /* 1: a flat card instead of a body as thick as it is wide. */
  uint32_t flat;
  /* 1: positions are the picture's pixels, x right, y up from the bottom edge; else the longest side is 1. */
  uint32_t pixels;
  uint32_t line_count;
  /* A picture that is bright where the figure is, as a file or the name of one in memory; null: found. */
  const char* mask;
  /* [line_count + 1] CSR offsets of the outline's closed lines, rising from 0. */
  const uint32_t* line_offsets;
  /* [line_offsets[line_count] x 2] The figure as sinew_character_picture_info has it, in place of what is found; or null. */
  const float* outline;
  /* 1: the figure is opened along lines that are drawn into it from its outline, as a guess. */
  uint32_t cut;
  uint32_t reserved;
} sinew_character_picture_options;

/* Opens a drawing or a photograph of a character (PNG, JPEG): its figure becomes a mesh in the plane z = 0, seen from +z,
 * with the picture as its texture. sinew_character_rig() gives it a skeleton in that plane (its category may say the class,
 * too); sinew_character_animate() rigs it where it has no skeleton, and plays a bundled clip of its class where no motion is
 * given.
 *   character  out; untouched on failure */
SINEW_API sinew_status sinew_character_open_picture(const char* path, const sinew_character_picture_options* options,
                                                    sinew_character** character);
/* Opens a picture in memory, as sinew_character_open_files() does.
 *   files  the picture, then the mask where options name one */
SINEW_API sinew_status sinew_character_open_picture_files(const sinew_file* files, uint32_t file_count,
                                                          const sinew_character_picture_options* options,
                                                          sinew_character** character);

/* What was found in a picture. */
typedef struct sinew_character_picture_info {
  uint32_t struct_size;
  /* Pixels, of the picture as it is seen. */
  uint32_t width;
  uint32_t height;
  /* Figures in the picture. */
  uint32_t figure_count;
  /* The one that was taken, from 1 on. */
  uint32_t figure;
  /* sinew_body_class; 0 before it is rigged. */
  uint32_t body_class;
  /* sinew_picture_view; 0 before it is rigged. */
  uint32_t view;
  /* 0..1, of class and view together; 0 before it is rigged. */
  float certainty;
  /* Closed lines of the outline: the border, then those of holes and smaller parts. */
  uint32_t line_count;
  uint32_t reserved;
  /* [line_count + 1] */
  const uint32_t* line_offsets;
  /* [line_offsets[line_count] x 2] Pixels, x right, y down from the top left corner. */
  const float* outline;
} sinew_character_picture_info;

/* Gives what was found. A character that is not of a picture is SINEW_ERROR_INPUT.  info  out */
SINEW_API sinew_status sinew_character_picture(sinew_character* character, sinew_character_picture_info* info);

#ifdef __cplusplus
}
#endif
#endif
