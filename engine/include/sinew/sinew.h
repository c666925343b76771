/* SPDX-License-Identifier: MIT
 * sinew: predicts skin weights of a mesh for a skeleton, in integers, inside one block of memory.
 * These C99 headers are the whole public interface of the engine. Every function is reentrant: there are no globals.
 *
 *   sinew/types.h  version, limits, status, kernels, callbacks, mesh, skeleton
 *   sinew/model.h  opens a model and packs its weights
 *   sinew/bind.h   predicts skin weights
 *   sinew/motion.h plays motion of another skeleton
 *   sinew/motion_clips.h  whole clips of it: natural ranges, reference points, what is left to be mended
 *   sinew/rig.h    predicts a skeleton for a bare mesh
 *   sinew/map.h    maps the joints of one skeleton to those of another
 *   sinew/transfer.h  carries weights to another mesh
 *   sinew/skin.h   poses a mesh with its weights
 *   sinew/deform.h poses a mesh so that bends keep their volume
 *   sinew/abi.h    sizes of structs, for bindings
 *
 * Way of a call:
 *   1. sinew_model_open()           checks every byte of a model file in place; SINEW_METHOD_HEAT needs no model
 *      sinew_model_pack()           on demand: packs its weights once, instead of in every bind
 *   2. sinew_options_init()         asks for every default; set what is to differ
 *      sinew_bind_outputs_init()    takes the caller's arrays
 *   3. sinew_bind_workspace_size()  says how many bytes sinew_bind() needs
 *   4. sinew_bind()                 predicts; rows of weights sum exactly
 *   5. sinew_skin_linear() or sinew_skin_dual_quaternion() poses the mesh with the result
 */
#ifndef SINEW_SINEW_H
#define SINEW_SINEW_H

#include "sinew/abi.h"
#include "sinew/bind.h"
#include "sinew/deform.h"
#include "sinew/map.h"
#include "sinew/model.h"
#include "sinew/motion.h"
#include "sinew/motion_clips.h"
#include "sinew/rig.h"
#include "sinew/simplify.h"
#include "sinew/skin.h"
#include "sinew/transfer.h"
#include "sinew/types.h"

#endif
