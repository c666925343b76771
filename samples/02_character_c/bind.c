/* SPDX-License-Identifier: MIT
 * A program in C99 that knows sinew/character.h and libsinew_character alone: opens, binds, saves.
 *   bind IN OUT */
#include <sinew/character.h>
#include <stdio.h>

static int fail(const sinew_character* character) {
  fprintf(stderr, "bind: %s\n", sinew_character_error(character));
  return 1;
}

int main(int count, char** arguments) {
  sinew_character* character = NULL;
  sinew_character_bind_options options = SINEW_INIT(sinew_character_bind_options);
  sinew_character_arrays arrays = SINEW_INIT(sinew_character_arrays);
  if (count != 3) return 2;
  if (sinew_character_open(arguments[1], &character) != SINEW_OK) return fail(NULL);
  if (sinew_character_bind(character, &options, NULL) != SINEW_OK ||
      sinew_character_view(character, &arrays) != SINEW_OK ||
      sinew_character_save(character, arguments[2]) != SINEW_OK) {
    (void)fail(character);
    sinew_character_close(character);
    return 1;
  }
  printf("%s: %u vertices, %u joints, sinew %s\n", arrays.name, (unsigned)arrays.vertex_count,
         (unsigned)arrays.joint_count, sinew_version());
  sinew_character_close(character);
  return 0;
}
