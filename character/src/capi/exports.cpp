// SPDX-License-Identifier: MIT
// libsinew_character is the archive of the same name and the engine's objects; a library needs a source of its own.
#include "sinew/character.h"
