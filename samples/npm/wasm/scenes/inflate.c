/* SPDX-License-Identifier: MIT
 * The one copy of miniz, which Assimp's sources bring: arrays of a binary FBX are deflated. */
#define MINIZ_NO_STDIO
#define MINIZ_NO_TIME
#define MINIZ_NO_ARCHIVE_APIS
#include "miniz.h"
