/* SPDX-License-Identifier: MIT
 * Questions and answers: geometry does not always say how an artist binds a part of a mesh. Then the bind asks, and the user's
 * answer goes into the next bind.
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
  SINEW_ANSWER_PROPOSED = 0, /* as the bind proposes; no question any more */
  SINEW_ANSWER_RIGID = 1,    /* all with one joint */
  SINEW_ANSWER_SOFT = 2,     /* blended as widely as heat flows: the weights of SINEW_METHOD_HEAT */
  SINEW_ANSWER_HARD = 3,     /* each with the strongest of its joints alone */
  SINEW_ANSWER_SOFTER = 4,   /* as proposed, blended twice as softly */
  SINEW_ANSWER_HOST = 5      /* each as the vertex nearest to it on the parts with more vertices, which is its host: a
                              * badge on a coat. The part with most vertices has none and stays as proposed */
} sinew_answer_kind;

/* The user's say about a part. Locked vertices and hints have the last word. Of two answers about a part the later one
 * counts. */
typedef struct sinew_answer {
  uint32_t vertex; /* any vertex of the part */
  uint16_t kind;   /* sinew_answer_kind */
  uint16_t joint;  /* of SINEW_ANSWER_RIGID, else 0. A part alike gets the joint that lies relative to it as this joint
                    * lies relative to the answer's part: each wheel gets its own axle */
  uint32_t alone;  /* 1: for this part alone; 0: for all parts alike as well */
} sinew_answer;

typedef struct sinew_alternative {
  uint16_t kind;   /* sinew_answer_kind */
  uint16_t joint;  /* of SINEW_ANSWER_RIGID, else 0 */
  uint32_t change; /* how much it would change, 0 .. 131072 in steps of 2^-16: at each vertex the sum over joints of
                    * |weight then - weight now|; of that the mean over the question's vertices */
} sinew_alternative;

/* A part that an answer is worth asking for, with those alike. */
typedef struct sinew_question {
  uint32_t vertex;            /* the first vertex of the part; it names the part in an answer */
  uint32_t part_count;        /* parts alike, this one included */
  uint32_t vertex_count;      /* vertices of the mesh in all of them */
  uint16_t joint;             /* the joint with most of the part's weight as proposed */
  uint16_t share;             /* and how much of it, 65535 = all */
  uint32_t doubt;             /* mean over the vertices of what their strongest joint leaves to others, 65536 = all */
  uint32_t gain;              /* doubt times the share of the mesh's vertices, 65536 = all: what the order is by */
  uint32_t alternative_count; /* 0 .. SINEW_MAX_ALTERNATIVES */
  uint32_t reserved;          /* 0 */
  sinew_alternative alternatives[SINEW_MAX_ALTERNATIVES]; /* rigid ones first, those with the likelier joints before;
                                                           * none that changes nothing */
} sinew_question;

#ifdef __cplusplus
}
#endif
#endif
