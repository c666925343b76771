/* SPDX-License-Identifier: MIT
 * sinew: auto-rigging, skin weights and retargeting, with the same bytes on every platform, each call inside one
 * block of the caller's memory. These C99 headers are the public interface of the engine. Every function is
 * reentrant: there are no globals.
 *
 *   sinew/types.h         version, limits, status, kernels, callbacks, mesh
 *   sinew/skeleton.h      a skeleton and its up axis
 *   sinew/skin.h          weights, and skinning with them
 *   sinew/model.h         opens a model and packs its weights
 *   sinew/bind.h          predicts skin weights
 *   sinew/questions.h     questions of a bind to the user, and the answers
 *   sinew/rig.h           predicts a skeleton for a bare mesh, with fingers, faces and props
 *   sinew/names.h         classifies joints by name
 *   sinew/map.h           matches the joints of one skeleton to those of another
 *   sinew/simplify.h      a skeleton of fewer joints
 *   sinew/transfer.h      transfers weights to another mesh
 *   sinew/deform.h        poses a mesh so that bends keep their volume
 *   sinew/motion.h        retargets motion of another skeleton, and keeps contacts
 *   sinew/motion_clips.h  natural ranges and measures of retargeted clips
 *   sinew/motion_stream.h streaming retargeting, frame by frame in one block of memory
 *   sinew/joint_limits.h  clamps joints to rotation limits, as of robots
 *   sinew/springs.h       chains that swing: hair, tails, ears, skirts
 *   sinew/abi.h           sizes of structs, for bindings
 *   sinew/published.h     methods as others published them, for comparison; this header does not include it
 *
 * Steps of a bind:
 *   1. sinew_model_open()           checks every byte of a model file in place; SINEW_METHOD_HEAT needs no model
 *      sinew_model_pack()           optional: packs its weights once, instead of in every bind
 *   2. SINEW_INIT(sinew_bind_options)  sets every default; change what differs
 *      SINEW_INIT(sinew_bind_outputs)  then set the caller's arrays
 *   3. sinew_bind_workspace_size()  returns the bytes that sinew_bind() needs
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
