#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Arms and the own body in retargeted clips: copied, mended as whole clips, and as streams whose body has no triangles (hands know nothing of it) and has them.

    stream_hands.py CLIPS SOURCE.rig.txt TARGET.rig.txt... [--vertices N]

Needs the Python package (samples/python) and numpy. The middle 100 frames of every CLIPS/*.bvh are played on every target twice: as they are, and as the motion
of SOURCE, on which they were played first, whose hands are to touch the target as they touch it. For that the first N vertices must be the same body in all files
(mh_train: 1605). Reported are, of arms: frames deeper in the body than 0.6 % of the height, mean error of the hands' distance at contacts, in % of the height, mean
acceleration of wrists against the copy's, and milliseconds of the process a frame."""
import ctypes
import dataclasses
import glob
import os
import sys
import time

import numpy as np
import sinew
from sinew import binding, retargeting
from sinew.character import multiply, turn

FRAMES = 100


def middle(clip):
    first = max(0, (len(clip.rotations) - FRAMES) // 2)
    part = slice(first, first + FRAMES)
    return sinew.Clip(clip.rotations[part], clip.translations[part], clip.fps, clip.name)


def first_vertices(body, count):
    faces = body.faces[(body.faces < count).all(1)]
    skin = body.skin.rounded(body.skin.joints.shape[1])
    return sinew.Character(positions=body.positions[:count], faces=faces, skeleton=body.skeleton, skin=sinew.Skin(skin.joints[:count], skin.weights[:count]))


class Pair:
    """A plan between two skeletons, for what the package has no call for."""

    def __init__(self, clip, source, target, joint_map):
        self.clip, self.library, self.plan = clip, binding.library(), ctypes.c_void_p()
        sources, classes, views, options = retargeting._pair(source, target, joint_map, False, 0.0, "auto", "auto")
        self.memory = binding.block("sinew_retarget_create_workspace_size", "retarget", len(source), len(target))
        binding.check(self.library.sinew_retarget_create(ctypes.byref(views[0]), ctypes.byref(views[1]), binding.address(sources), binding.address(classes),
                                                         ctypes.byref(options), self.memory.address, self.memory.size_bytes, ctypes.byref(self.plan)), "retarget")
        value, heights = ctypes.c_float(), np.zeros(len(clip.rotations), np.float32)
        for f in range(len(heights)):
            binding.check(self.library.sinew_retarget_height(self.plan, binding.address(clip.rotations[f]), binding.address(clip.translations[f]),
                                                             ctypes.byref(value)), "retarget")
            heights[f] = value.value
        binding.check(self.library.sinew_retarget_ground(self.plan, binding.address(heights), len(heights), ctypes.byref(value)), "retarget")
        self.ground = value.value

    def measure(self, played, source_body, target_body):
        """sinew_limb_measure of the arms."""
        target = retargeting._body_view(target_body, "target")
        source = None if source_body is None else retargeting._body_view(source_body, "source")
        options = binding.init(binding.sinew_contact_options)
        options.fps = self.clip.fps
        whole = binding.sinew_motion_clip(binding.address(self.clip.rotations), binding.address(self.clip.translations), binding.address(played.rotations),
                                          binding.address(played.translations), len(played.rotations), self.ground)
        block = binding.block("sinew_retarget_contacts_workspace_size", "retarget", self.plan, ctypes.byref(target), len(played.rotations))
        limbs, count = (binding.sinew_limb_measure * 16)(), ctypes.c_uint32()
        binding.check(self.library.sinew_retarget_measure(self.plan, None if source is None else ctypes.byref(source), ctypes.byref(target), ctypes.byref(whole),
                                                          ctypes.byref(options), block.address, block.size_bytes, limbs, ctypes.byref(count)), "retarget")
        return [limb for limb in limbs[:count.value] if not limb.leg]


def acceleration(skeleton, clip, joints):
    """Mean over frames and joints, in the skeleton's units a frame squared."""
    turns, places = clip.rotations.astype(float), clip.translations.astype(float)
    for joint in skeleton.order():
        up = skeleton.parents[joint]
        if up >= 0:
            places[:, joint] = places[:, up] + turn(turns[:, up], places[:, joint])
            turns[:, joint] = multiply(turns[:, up], turns[:, joint])
    places = places[:, joints]
    return np.linalg.norm(places[2:] - 2 * places[1:-1] + places[:-2], axis=2).mean()


def ways(pair, source, target, joint_map, source_body, target_body):
    """(name, clip, milliseconds a frame) of each way to play a clip."""
    clip = pair.clip
    copied = sinew.retarget(clip, source, target, joint_map=joint_map, method="copy")
    yield "copied", copied, 0
    yield "whole clips", sinew.retarget(clip, source, target, joint_map=joint_map, method="contacts", source_body=source_body, target_body=target_body), 0
    bare = dataclasses.replace(target_body, faces=np.zeros((0, 3), np.uint32))
    for name, body, moving in (("stream, no triangles", bare, None), ("stream", target_body, source_body)):
        stream = sinew.RetargetStream(source, target, joint_map=joint_map, target_body=body, source_body=moving, fps=clip.fps, ground=pair.ground)
        start = time.process_time()
        frames = [stream.frame(*pose) for pose in zip(clip.rotations, clip.translations)]
        spent = 1e3 * (time.process_time() - start) / len(frames)
        yield name, sinew.Clip(np.array([f[0] for f in frames]), np.array([f[1] for f in frames]), clip.fps, name), spent


def main():
    argv, count = sys.argv[1:], None
    if "--vertices" in argv:
        at = argv.index("--vertices")
        count = int(argv[at + 1])
        argv = argv[:at] + argv[at + 2:]
    if len(argv) < 3:
        sys.exit(__doc__)
    base, targets, sums = sinew.load(argv[1]), [sinew.load(path) for path in argv[2:]], {}

    def add(kind, clip, source, target, joint_map, source_body, target_body):
        pair = Pair(clip, source, target, joint_map)
        calm = 0
        for name, played, spent in ways(pair, source, target, joint_map, source_body, target_body):
            arms = pair.measure(played, source_body, target_body)
            own = acceleration(target, played, [arm.joint for arm in arms])
            calm = calm or own
            sums.setdefault((kind, name), []).append(
                [sum(arm.deep_frames for arm in arms), sum(arm.frames for arm in arms), sum(arm.error * arm.contact_frames for arm in arms),
                 sum(arm.contact_frames for arm in arms), own / calm, spent])

    for path in sorted(glob.glob(os.path.join(argv[0], "*.bvh"))):
        bvh = sinew.load(path)
        clip = middle(bvh.clips[0])
        moved = sinew.retarget(clip, bvh.skeleton, base.skeleton, target_body=base)
        for target in targets:
            add("BVH", clip, bvh.skeleton, target.skeleton, sinew.map(target.skeleton, bvh.skeleton), None, target)
            if count:
                add("a body", moved, base.skeleton, target.skeleton, sinew.map(target.skeleton, base.skeleton), first_vertices(base, count),
                    first_vertices(target, count))
    for (kind, name), rows in sums.items():
        deep, frames, error, contacts, _, _ = np.sum(rows, 0)
        print(f"{kind:7s} {name:21s} in the body {100 * deep / frames:5.2f} %  contacts {100 * error / max(1, contacts):5.3f} % of {contacts:.0f}"
              f"  acceleration {np.mean(rows, 0)[4]:.3f}  {np.mean(rows, 0)[5]:.3f} ms")


main()
