/* SPDX-License-Identifier: MIT
 * A model file's bytes where sinew_model_open() wants them: in read-only memory, at an address divisible by 8. */
    .section .rodata.model, "a"
    .balign 64
    .global model_start, model_end
model_start:
    .incbin MODEL
model_end:
    .byte 0
#if defined(__linux__)
    .section .note.GNU-stack, "", %progbits
#endif
