/* SPDX-License-Identifier: MIT
 * sinew: skeletons, skin weights and motion of characters, with the same bytes on every platform, each call inside one block
 * of the caller's memory. These C99 headers are the whole public interface of the engine. Every function is reentrant: there are no globals.
 *
 *   sinew/types.h         version, limits, status, kernels, callbacks, mesh
 *   sinew/skeleton.h      a skeleton, and which axis is up
 *   sinew/skin.h          weights; poses a mesh with them
 *   sinew/model.h         opens a model and packs its weights
 *   sinew/bind.h          predicts skin weights
 *   sinew/questions.h     what a bind asks the user, and the answers
 *   sinew/rig.h           predicts a skeleton for a bare mesh, with fingers, faces and props
 *   sinew/names.h         says what joints are by what they are called
 *   sinew/map.h           maps the joints of one skeleton to those of another
 *   sinew/simplify.h      a skeleton of fewer joints
 *   sinew/transfer.h      carries weights to another mesh
 *   sinew/deform.h        poses a mesh so that bends keep their volume
 *   sinew/motion.h        plays motion of another skeleton, and keeps contacts
 *   sinew/motion_clips.h  whole clips of it: natural ranges, what is left to be mended
 *   sinew/motion_stream.h frame by frame as it comes, in one block of memory
 *   sinew/joint_limits.h  holds joints within limits, as robots have them
 *   sinew/springs.h       chains that swing: hair, tails, ears, skirts
 *   sinew/abi.h           sizes of structs, for bindings
 *   sinew/published.h     methods as others published them, for comparison; this header does not include it
 *
 * Steps of a bind:
 *   1. sinew_model_open()           checks every byte of a model file in place; SINEW_METHOD_HEAT needs no model
 *      sinew_model_pack()           on demand: packs its weights once, instead of in every bind
 *   2. SINEW_INIT(sinew_bind_options)  asks for every default; set what is to differ
 *      SINEW_INIT(sinew_bind_outputs)  gets the caller's arrays
 *   3. sinew_bind_workspace_size()  says how many bytes sinew_bind() needs
 *   4. sinew_bind()                 predicts; rows of weights sum exactly
 *   5. sinew_skin_linear() or sinew_skin_dual_quaternion() poses the mesh with the result
 */
#ifndef SINEW_SINEW_H
#define SINEW_SINEW_H

#include "sinew/abi.h"
#include "sinew/bind.h"
#include "sinew/deform.h"
#include "sinew/joint_limits.h"
#include "sinew/map.h"
#include "sinew/model.h"
#include "sinew/motion.h"
#include "sinew/motion_clips.h"
#include "sinew/motion_stream.h"
#include "sinew/names.h"
#include "sinew/questions.h"
#include "sinew/rig.h"
#include "sinew/simplify.h"
#include "sinew/skeleton.h"
#include "sinew/skin.h"
#include "sinew/springs.h"
#include "sinew/transfer.h"
#include "sinew/types.h"

#endif
