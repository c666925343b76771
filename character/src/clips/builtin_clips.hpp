// SPDX-License-Identifier: MIT
// All clips of one kind of body, made when they are asked for.
#ifndef SINEW_CHARACTER_CLIPS_BUILTIN_CLIPS_HPP
#define SINEW_CHARACTER_CLIPS_BUILTIN_CLIPS_HPP

#include "sinew_formats/motion.hpp"

namespace sinew::clips {

Motion person_clips();     // walk, run, idle, wave, jump, sit, squat, reach
Motion quadruped_clips();  // walk, trot, idle
Motion bird_clips();       // flap
Motion fish_clips();       // swim
Motion spider_clips();     // crawl

}  // namespace sinew::clips
#endif
