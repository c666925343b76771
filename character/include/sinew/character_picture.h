/* SPDX-License-Identifier: MIT
 * Characters from drawings and photographs: include sinew/character.h, which describes what all calls share. */
#ifndef SINEW_CHARACTER_PICTURE_H
#define SINEW_CHARACTER_PICTURE_H

#include "sinew/character_file.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The values of sinew_category, and OTHER. */
typedef enum sinew_body_class {
  SINEW_BODY_CLASS_FOUND = 0, /* predicted by the model */
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
  /* Number of the figure, from left to right, starting at 1; 0: the largest. */
  uint32_t figure;
  /* 1: a flat card instead of a body as thick as it is wide. */
  uint32_t flat;
  /* 1: positions in pixels, x right, y up from the bottom edge; 0: the longest side is 1. */
  uint32_t pixels;
  uint32_t line_count;
  /* Mask of the figure, bright inside: a file, or the name of one in memory; null: found. */
  const char* mask;
  /* [line_count + 1] CSR offsets of the outline's closed lines, rising from 0. */
  const uint32_t* line_offsets;
  /* [line_offsets[line_count] x 2] Outline of the figure as in sinew_character_picture_info; null: found. */
  const float* outline;
  /* 1: cuts the figure along lines drawn into it from its outline. */
  uint32_t cut;
  uint32_t reserved;
} sinew_character_picture_options;

/* Opens a drawing or a photograph of a character (PNG, JPEG): its figure becomes a mesh in the plane z = 0, seen from +z,
 * with the picture as its texture. sinew_character_rig() gives it a skeleton in that plane (its category also sets
 * the class). sinew_character_animate() rigs it if it has no skeleton, and plays a bundled clip of its class if no
 * motion is given.
 *   character  out; untouched on failure */
SINEW_API sinew_status sinew_character_open_picture(const char* path, const sinew_character_picture_options* options,
                                                    sinew_character** character);
/* Opens a picture in memory, as sinew_character_open_files() does.
 *   files  the picture, then the mask if options name one */
SINEW_API sinew_status sinew_character_open_picture_files(const sinew_file* files, uint32_t file_count,
                                                          const sinew_character_picture_options* options,
                                                          sinew_character** character);

/* Result of reading a picture. */
typedef struct sinew_character_picture_info {
  uint32_t struct_size;
  /* Pixels of the picture as displayed. */
  uint32_t width;
  uint32_t height;
  /* Number of figures in the picture. */
  uint32_t figure_count;
  /* The figure that was taken, starting at 1. */
  uint32_t figure;
  /* sinew_body_class; 0 before it is rigged. */
  uint32_t body_class;
  /* sinew_picture_view; 0 before it is rigged. */
  uint32_t view;
  /* 0..1, certainty of class and view together; 0 before it is rigged. */
  float certainty;
  /* Number of closed lines of the outline: the border, then those of holes and smaller parts. */
  uint32_t line_count;
  uint32_t reserved;
  /* [line_count + 1] */
  const uint32_t* line_offsets;
  /* [line_offsets[line_count] x 2] Pixels, x right, y down from the top left corner. */
  const float* outline;
} sinew_character_picture_info;

/* Gives the result of reading the picture. A character that is not from a picture is SINEW_ERROR_INPUT.  info  out */
SINEW_API sinew_status sinew_character_picture(sinew_character* character, sinew_character_picture_info* info);

#ifdef __cplusplus
}
#endif
#endif
