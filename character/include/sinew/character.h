/* SPDX-License-Identifier: MIT
 * Characters: the jobs of the command `sinew` as calls of the shared library libsinew_character. Defaults and saved
 * bytes are the command's. The engine's own calls (sinew/sinew.h) are in this library too.
 *
 *   #include <sinew/character.h>
 *   #include <stdio.h>
 *   int main(void) {
 *     sinew_character* hero = NULL;
 *     sinew_character_rig_options options = SINEW_INIT(sinew_character_rig_options);
 *     options.detail = SINEW_CHARACTER_DETAIL_HANDS;
 *     if (sinew_character_open("hero.obj", &hero) != SINEW_OK || sinew_character_rig(hero, &options, NULL) != SINEW_OK ||
 *         sinew_character_save(hero, "hero.glb") != SINEW_OK)
 *       puts(sinew_character_error(hero));
 *     sinew_character_close(hero);
 *     return 0;
 *   }
 *
 *   sinew/character_file.h     open, save, arrays, weights, clips; transform, profiles, controls
 *   sinew/character_jobs.h     bind, rig, map, animate, pose, transfer, simplify, lod, bake: one call for each command
 *   sinew/character_picture.h  a character from a drawing or a photograph
 *   sinew/character_check.h    faults of a rig
 *
 * A call that can fail returns a sinew_status: 0 is success, and sinew_character_error() has one line of English for a
 * failure. A failed call leaves the character and all files unchanged. Beside what its comment lists, each call may return
 * SINEW_ERROR_ARGUMENT, SINEW_ERROR_INPUT and SINEW_ERROR_MEMORY; one with options SINEW_ERROR_VERSION; one with a progress
 * callback SINEW_ERROR_CANCELLED.
 * Structs with struct_size start from SINEW_INIT() and grow at the end (sinew/types.h). Null options and members that
 * are 0 mean defaults. Options inside options are pointers with the same rule. A result may be null if the call has
 * another output. These members mean the same in every options struct:
 *   thread_count  number of threads; 0 = 1. The result is the same for any number
 *   progress      called on the calling thread with progress_user; a value that is not 0 cancels. Null = none
 *   models        models instead of the bundled ones; null = bundled
 * Strings are UTF-8. Pointers in results belong to the character. They are valid until the next call that may change it
 * (whose character is not const) or sinew_character_close().
 * Any number of characters may be used at the same time; one character is used by one thread at a time. */
#ifndef SINEW_CHARACTER_H
#define SINEW_CHARACTER_H

#include "sinew/character_check.h"
#include "sinew/character_file.h"
#include "sinew/character_jobs.h"
#include "sinew/character_picture.h"

#endif
