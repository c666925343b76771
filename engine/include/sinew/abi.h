/* SPDX-License-Identifier: MIT
 * What a binding in another language compares when it loads the library: whether the structs that it was made with are those of the
 * library. Bindings of this repository are made by scripts/declarations.py. */
#ifndef SINEW_ABI_H
#define SINEW_ABI_H

#include <stddef.h>

#include "sinew/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* sizeof of a struct of the engine's headers, as this library has it.
 *   name  "sinew_mesh"; null is allowed
 * Returns 0 for a name that no struct has. A struct that begins with struct_size may be larger than the caller's, see types.h; any
 * other has to be equal. */
SINEW_API size_t sinew_struct_size(const char* name);

#ifdef __cplusplus
}
#endif
#endif
