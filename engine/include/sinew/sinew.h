/* SPDX-License-Identifier: MIT
 * sinew: predicts skin weights of a mesh for a skeleton, in integers, inside one block of memory.
 * These C99 headers are the whole public interface of the engine. Every function is reentrant: there are no globals.
 *
 *   sinew/types.h  version, limits, status, kernels, callbacks, mesh, skeleton
 *   sinew/model.h  opens a model and packs its weights
 *   sinew/bind.h   predicts skin weights
 *   sinew/skin.h   poses a mesh with its weights
 *
 * Way of a call:
 *   1. sinew_model_open()           checks every byte of a model file in place (skip it for SINEW_METHOD_HEAT);
 *      sinew_model_pack()      on demand, makes its weights ready for this kind of processor once for many binds
 *   2. sinew_bind_workspace_size()  says how many bytes sinew_bind() needs
 *   3. sinew_bind()                 predicts; rows of weights sum exactly
 *   4. sinew_skin_linear() / sinew_skin_dual_quaternion() pose the mesh with the result
 */
#ifndef SINEW_SINEW_H
#define SINEW_SINEW_H

#include "sinew/bind.h"
#include "sinew/model.h"
#include "sinew/skin.h"
#include "sinew/types.h"

#endif
