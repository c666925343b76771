// SPDX-License-Identifier: MIT
// A human body of 65 joints, Mixamo's: what a rig without names is laid over to tell its arms from its legs.
#ifndef SINEW_MAPPING_HUMAN_BODY_HPP
#define SINEW_MAPPING_HUMAN_BODY_HPP

#include <stdint.h>

#include "sinew/rig.h"

namespace sinew::mapping {

struct BodyJoint {
  uint8_t joint_class;
  int8_t side;
  uint8_t index;  // in its chain, as sinew_joint_standard_name() has it
  uint8_t end;
  int16_t parent;
  float position[3];  // meters, y up
};

constexpr BodyJoint kHumanBody[] = {{SINEW_CLASS_PELVIS, 0, 0, 0, -1, {0, 0.98f, 0}},
                                    {SINEW_CLASS_SPINE, 0, 0, 0, 0, {0, 1.08f, -0.01f}},
                                    {SINEW_CLASS_SPINE, 0, 1, 0, 1, {0, 1.19f, -0.015f}},
                                    {SINEW_CLASS_SPINE, 0, 2, 0, 2, {0, 1.31f, -0.02f}},
                                    {SINEW_CLASS_NECK, 0, 0, 0, 3, {0, 1.48f, -0.015f}},
                                    {SINEW_CLASS_HEAD, 0, 0, 0, 4, {0, 1.57f, 0.01f}},
                                    {SINEW_CLASS_HEAD, 0, 0, 1, 5, {0, 1.8f, 0.01f}},
                                    {SINEW_CLASS_CLAVICLE, 1, 0, 0, 3, {0.04f, 1.43f, -0.02f}},
                                    {SINEW_CLASS_UPPER_ARM, 1, 0, 0, 7, {0.17f, 1.42f, -0.03f}},
                                    {SINEW_CLASS_FOREARM, 1, 0, 0, 8, {0.45f, 1.42f, -0.035f}},
                                    {SINEW_CLASS_HAND, 1, 0, 0, 9, {0.71f, 1.42f, -0.03f}},
                                    {SINEW_CLASS_THUMB, 1, 0, 0, 10, {0.735f, 1.405f, 0.005f}},
                                    {SINEW_CLASS_THUMB, 1, 1, 0, 11, {0.765f, 1.395f, 0.03f}},
                                    {SINEW_CLASS_THUMB, 1, 2, 0, 12, {0.79f, 1.39f, 0.05f}},
                                    {SINEW_CLASS_THUMB, 1, 3, 1, 13, {0.81f, 1.387f, 0.068f}},
                                    {SINEW_CLASS_INDEX, 1, 0, 0, 10, {0.8f, 1.42f, 0.005f}},
                                    {SINEW_CLASS_INDEX, 1, 1, 0, 15, {0.84f, 1.42f, 0.01f}},
                                    {SINEW_CLASS_INDEX, 1, 2, 0, 16, {0.865f, 1.42f, 0.012f}},
                                    {SINEW_CLASS_INDEX, 1, 3, 1, 17, {0.885f, 1.42f, 0.013f}},
                                    {SINEW_CLASS_MIDDLE, 1, 0, 0, 10, {0.805f, 1.422f, -0.02f}},
                                    {SINEW_CLASS_MIDDLE, 1, 1, 0, 19, {0.848f, 1.422f, -0.02f}},
                                    {SINEW_CLASS_MIDDLE, 1, 2, 0, 20, {0.877f, 1.422f, -0.02f}},
                                    {SINEW_CLASS_MIDDLE, 1, 3, 1, 21, {0.9f, 1.422f, -0.02f}},
                                    {SINEW_CLASS_RING, 1, 0, 0, 10, {0.8f, 1.42f, -0.043f}},
                                    {SINEW_CLASS_RING, 1, 1, 0, 23, {0.84f, 1.42f, -0.045f}},
                                    {SINEW_CLASS_RING, 1, 2, 0, 24, {0.866f, 1.42f, -0.046f}},
                                    {SINEW_CLASS_RING, 1, 3, 1, 25, {0.887f, 1.42f, -0.047f}},
                                    {SINEW_CLASS_PINKY, 1, 0, 0, 10, {0.79f, 1.415f, -0.064f}},
                                    {SINEW_CLASS_PINKY, 1, 1, 0, 27, {0.822f, 1.415f, -0.068f}},
                                    {SINEW_CLASS_PINKY, 1, 2, 0, 28, {0.843f, 1.415f, -0.07f}},
                                    {SINEW_CLASS_PINKY, 1, 3, 1, 29, {0.86f, 1.415f, -0.072f}},
                                    {SINEW_CLASS_CLAVICLE, -1, 0, 0, 3, {-0.04f, 1.43f, -0.02f}},
                                    {SINEW_CLASS_UPPER_ARM, -1, 0, 0, 31, {-0.17f, 1.42f, -0.03f}},
                                    {SINEW_CLASS_FOREARM, -1, 0, 0, 32, {-0.45f, 1.42f, -0.035f}},
                                    {SINEW_CLASS_HAND, -1, 0, 0, 33, {-0.71f, 1.42f, -0.03f}},
                                    {SINEW_CLASS_THUMB, -1, 0, 0, 34, {-0.735f, 1.405f, 0.005f}},
                                    {SINEW_CLASS_THUMB, -1, 1, 0, 35, {-0.765f, 1.395f, 0.03f}},
                                    {SINEW_CLASS_THUMB, -1, 2, 0, 36, {-0.79f, 1.39f, 0.05f}},
                                    {SINEW_CLASS_THUMB, -1, 3, 1, 37, {-0.81f, 1.387f, 0.068f}},
                                    {SINEW_CLASS_INDEX, -1, 0, 0, 34, {-0.8f, 1.42f, 0.005f}},
                                    {SINEW_CLASS_INDEX, -1, 1, 0, 39, {-0.84f, 1.42f, 0.01f}},
                                    {SINEW_CLASS_INDEX, -1, 2, 0, 40, {-0.865f, 1.42f, 0.012f}},
                                    {SINEW_CLASS_INDEX, -1, 3, 1, 41, {-0.885f, 1.42f, 0.013f}},
                                    {SINEW_CLASS_MIDDLE, -1, 0, 0, 34, {-0.805f, 1.422f, -0.02f}},
                                    {SINEW_CLASS_MIDDLE, -1, 1, 0, 43, {-0.848f, 1.422f, -0.02f}},
                                    {SINEW_CLASS_MIDDLE, -1, 2, 0, 44, {-0.877f, 1.422f, -0.02f}},
                                    {SINEW_CLASS_MIDDLE, -1, 3, 1, 45, {-0.9f, 1.422f, -0.02f}},
                                    {SINEW_CLASS_RING, -1, 0, 0, 34, {-0.8f, 1.42f, -0.043f}},
                                    {SINEW_CLASS_RING, -1, 1, 0, 47, {-0.84f, 1.42f, -0.045f}},
                                    {SINEW_CLASS_RING, -1, 2, 0, 48, {-0.866f, 1.42f, -0.046f}},
                                    {SINEW_CLASS_RING, -1, 3, 1, 49, {-0.887f, 1.42f, -0.047f}},
                                    {SINEW_CLASS_PINKY, -1, 0, 0, 34, {-0.79f, 1.415f, -0.064f}},
                                    {SINEW_CLASS_PINKY, -1, 1, 0, 51, {-0.822f, 1.415f, -0.068f}},
                                    {SINEW_CLASS_PINKY, -1, 2, 0, 52, {-0.843f, 1.415f, -0.07f}},
                                    {SINEW_CLASS_PINKY, -1, 3, 1, 53, {-0.86f, 1.415f, -0.072f}},
                                    {SINEW_CLASS_THIGH, 1, 0, 0, 0, {0.095f, 0.93f, 0}},
                                    {SINEW_CLASS_CALF, 1, 0, 0, 55, {0.1f, 0.51f, 0.01f}},
                                    {SINEW_CLASS_FOOT, 1, 0, 0, 56, {0.105f, 0.09f, -0.03f}},
                                    {SINEW_CLASS_TOE, 1, 0, 0, 57, {0.11f, 0.02f, 0.1f}},
                                    {SINEW_CLASS_TOE, 1, 0, 1, 58, {0.115f, 0.01f, 0.18f}},
                                    {SINEW_CLASS_THIGH, -1, 0, 0, 0, {-0.095f, 0.93f, 0}},
                                    {SINEW_CLASS_CALF, -1, 0, 0, 60, {-0.1f, 0.51f, 0.01f}},
                                    {SINEW_CLASS_FOOT, -1, 0, 0, 61, {-0.105f, 0.09f, -0.03f}},
                                    {SINEW_CLASS_TOE, -1, 0, 0, 62, {-0.11f, 0.02f, 0.1f}},
                                    {SINEW_CLASS_TOE, -1, 0, 1, 63, {-0.115f, 0.01f, 0.18f}}};
constexpr uint32_t kHumanJoints = sizeof kHumanBody / sizeof *kHumanBody;

}  // namespace sinew::mapping
#endif
