/* SPDX-License-Identifier: MIT
 * `sinew check` finds faults of a rig: include sinew/character.h, which describes what all calls share. */
#ifndef SINEW_CHARACTER_CHECK_H
#define SINEW_CHARACTER_CHECK_H

#include "sinew/character_file.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sinew_check_severity {
  SINEW_CHECK_NOTE = 0,
  SINEW_CHECK_WARNING = 1,
  SINEW_CHECK_ERROR = 2
} sinew_check_severity;

/* A fault of a rig. */
typedef struct sinew_character_finding {
  /* "left-right"; sinew_character_check_rules() lists them. */
  const char* rule;
  /* One line of English. */
  const char* what;
  /* One line: the remedy. */
  const char* cure;
  /* Test pose in which it shows; "": none. */
  const char* pose;
  /* Animation in which it shows; "": none. */
  const char* clip;
  /* Time in the clip. */
  double seconds;
  /* Measured value. */
  double value;
  /* The value above which it is a finding. */
  double bound;
  /* [vertex_count] Ascending; null for a finding about joints or clips. */
  const uint32_t* vertices;
  uint32_t vertex_count;
  /* sinew_check_severity */
  uint32_t severity;
  /* Joint of the finding; -1: none. */
  int32_t joint;
  /* Joint for comparison; -1: none. */
  int32_t other;
  /* Mesh of all its vertices; -1: none, or several. */
  int32_t mesh;
  /* Position of the finding, in the mesh's units. */
  float position[3];
  /* Radius of the finding around the position. */
  float radius;
  uint32_t reserved;
} sinew_character_finding;

typedef struct sinew_character_check_options {
  uint32_t struct_size;
  /* Bits of sinew_without.
   *   SINEW_WITHOUT_POSES  no test poses: no tears, lost volume, flips, crossings
   *   SINEW_WITHOUT_CLIPS  ignores animations */
  uint32_t without;
  /* 1: computes the score. */
  uint32_t score;
  uint32_t bound_count;
  /* [bound_count] Rules with other bounds; or null. */
  const char* const* bound_rules;
  /* [bound_count] */
  const double* bounds;
} sinew_character_check_options;

typedef struct sinew_character_check_result {
  uint32_t struct_size;
  uint32_t finding_count;
  /* Number of findings of each severity. */
  uint32_t errors;
  uint32_t warnings;
  uint32_t notes;
  uint32_t reserved;
  /* [finding_count] Errors first. */
  const sinew_character_finding* findings;
  /* "checked: 0 findings" */
  const char* line;
  /* 0..100, similarity of the weights to those of three methods; -1 if not requested. */
  double score;
} sinew_character_check_result;

/* Finds faults of the skeleton, the weights, the matrices and the animations; changes nothing. A character without
 * joints is SINEW_ERROR_INPUT. */
SINEW_API sinew_status sinew_character_check(sinew_character* character, const sinew_character_check_options* options,
                                             sinew_character_check_result* result);
/* Returns the names of the rules, separated by spaces. Static. */
SINEW_API const char* sinew_character_check_rules(void);

#ifdef __cplusplus
}
#endif
#endif
