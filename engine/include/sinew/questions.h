/* SPDX-License-Identifier: MIT
 * Questions and answers: geometry alone does not always decide how an artist binds a part of a mesh. Then the bind
 * asks, and the user's answer goes into the next bind.
 *
 * A part is a connected piece of the mesh, vertices at one position taken as one. Parts of the same shape, mirrored ones
 * too, are one question: buttons, wheels, eyes. A bind with sinew_bind_options::question_count lists those parts whose
 * answers are worth most; the next bind of the same mesh takes them in sinew_bind_options::answers. */
#ifndef SINEW_QUESTIONS_H
#define SINEW_QUESTIONS_H

#include "sinew/types.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SINEW_MAX_ALTERNATIVES 8u
#define SINEW_MAX_QUESTIONS 1024u
#define SINEW_NO_QUESTION 0xFFFFFFFFu

/* How the vertices of a part move. Numbers are never reused. */
typedef enum sinew_answer_kind {
  SINEW_ANSWER_PROPOSED = 0, /* as the bind proposes; not asked again */
  SINEW_ANSWER_RIGID = 1,    /* all vertices with one joint */
  SINEW_ANSWER_SOFT = 2,     /* blended by heat diffusion: the weights of SINEW_METHOD_HEAT */
  SINEW_ANSWER_HARD = 3,     /* each vertex with its strongest joint */
  SINEW_ANSWER_SOFTER = 4,   /* as proposed, but blended twice as softly */
  SINEW_ANSWER_HOST = 5      /* each vertex like its host, the nearest vertex on the parts with more vertices: a badge
                              * on a coat. The largest part has no host and stays as proposed */
} sinew_answer_kind;

/* The user's answer about a part. Locked vertices and hints take precedence. Of two answers about a part the later
 * one counts. */
typedef struct sinew_answer {
  uint32_t vertex; /* any vertex of the part */
  uint16_t kind;   /* sinew_answer_kind */
  uint16_t joint;  /* of SINEW_ANSWER_RIGID, else 0. An equal part gets the joint at the same relative position: each
                    * wheel gets its own axle */
  uint32_t alone;  /* 1: for this part only; 0: also for equal parts */
} sinew_answer;

typedef struct sinew_alternative {
  uint16_t kind;   /* sinew_answer_kind */
  uint16_t joint;  /* of SINEW_ANSWER_RIGID, else 0 */
  uint32_t change; /* size of the change, 0 .. 131072 in steps of 2^-16: mean over the question's vertices of the sum
                    * over joints of |weight after - weight before| */
} sinew_alternative;

/* A question about a part and the parts equal to it. */
typedef struct sinew_question {
  uint32_t vertex;       /* the first vertex of the part, which identifies it in an answer */
  uint32_t part_count;   /* number of equal parts, including this one */
  uint32_t vertex_count; /* number of mesh vertices in all of them */
  uint16_t joint;        /* joint with most of the proposed weight of the part */
  uint16_t share;        /* its share of that weight, 65535 = all */
  uint32_t doubt;        /* mean over the vertices of the weight on other than the strongest joint, 65536 = all */
  uint32_t gain;         /* doubt times the share of the mesh's vertices, 65536 = all; questions are sorted by it */
  uint32_t alternative_count;                             /* 0 .. SINEW_MAX_ALTERNATIVES */
  uint32_t reserved;                                      /* 0 */
  sinew_alternative alternatives[SINEW_MAX_ALTERNATIVES]; /* rigid ones first, by descending likelihood of the joint;
                                                           * each changes something */
} sinew_question;

#ifdef __cplusplus
}
#endif
#endif
