#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Poses of contact (an arm along the body and pressed into it, across the chest, thighs together, a thigh on the belly), and how many pairs of
triangles cross in them that did not at rest: linear skinning, `sinew pose --deform volume`, and that with --body-contact.

    body_contact.py SINEW YARDSTICK CHARACTERS OUT NAME [NAME ...]

YARDSTICK is the folder of deform_eval.py (needs numpy); CHARACTERS holds NAME.obj + NAME.rig.txt; OUT gets the poses."""
import os
import subprocess
import sys

if len(sys.argv) < 6:
    sys.exit(__doc__)
sys.path.insert(0, sys.argv[2])
import deform_eval as yardstick  # noqa: E402
import numpy as np  # noqa: E402

WAYS = {'volume': ['--deform', 'volume'], 'with contact': ['--deform', 'volume', '--body-contact']}


def between(bone, to):
    """The shortest rotation of a bone to a direction."""
    return yardstick.rotation(np.cross(bone, to), yardstick.angle_between(bone, to))


def about(axis, degrees):
    return yardstick.rotation(np.array(axis, float), np.radians(degrees))


def poses(rig):
    """{pose: {joint: rotation in rest axes}} of the left side; thighs of both."""
    shoulder, elbow, wrist, hip, knee = (yardstick.find(rig, k) for k in ('shoulder', 'elbow', 'wrist', 'hip', 'knee'))
    side = np.sign(rig.pos[shoulder][0])
    arm = yardstick.tip(rig, shoulder, elbow) - rig.pos[shoulder]
    down = between(arm, np.array([0, -1.0, 0]))
    forward = between(arm, yardstick.unit(np.array([-0.35 * side, -0.75, 0.6])))
    forearm = forward @ (rig.pos[wrist] - rig.pos[elbow])
    across = between(forearm, yardstick.unit(np.array([-side, 0.05, -0.15])))
    thigh = yardstick.tip(rig, hip, knee) - rig.pos[hip]
    other = int(np.linalg.norm(rig.pos - rig.pos[hip] * [-1, 1, 1], axis=1).argmin())
    legs = np.sign(rig.pos[hip][0])
    raised = np.cross(thigh, [0, 0, 1.0])
    return {
        'arm down': {shoulder: down},
        'arm 20 degrees in': {shoulder: about([0, 0, 1], -20 * side) @ down},
        'arm across': {shoulder: forward, elbow: forward.T @ across @ forward},
        'thighs 10 degrees in': {hip: about([0, 0, 1], -10 * legs), other: about([0, 0, 1], 10 * legs)},
        'thighs 20 degrees in': {hip: about([0, 0, 1], -20 * legs), other: about([0, 0, 1], 20 * legs)},
        'thigh up by 115': {hip: about(raised, 115)},
        'thigh up by 130': {hip: about(raised, 130)},
    }


def main():
    sinew, _, folder, out, names = sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4], sys.argv[5:]
    os.makedirs(out, exist_ok=True)
    found = {}
    for name in names:
        rest = yardstick.load(folder, name)
        for pose, local in poses(rest.rig).items():
            matrices = yardstick.forward(rest.rig, local)
            file = os.path.join(out, f'{name}.{pose.replace(" ", "_")}')
            yardstick.write_pose(file + '.pose', rest.rig.names, matrices)
            results = {'linear': yardstick.lbs(rest.rig.w, matrices, rest.pts)}
            for way, options in WAYS.items():
                subprocess.run([sinew, 'pose', os.path.join(folder, name + '.obj'), '--matrices', file + '.pose', *options, '-o', file + '.obj'],
                               check=True, stdout=subprocess.DEVNULL)
                results[way] = yardstick.read_obj(file + '.obj')[0]
            for way, posed in results.items():
                figures = yardstick.measure(rest, posed, matrices, None)
                found.setdefault((pose, way), []).append((figures['hits'], figures['layer_hits'], 100 * figures['flips']))
    print('| pose, crossings in a part / between parts, flips % | linear | ' + ' | '.join(WAYS) + ' |\n|---|---|---|---|')
    for pose in dict.fromkeys(pose for pose, _ in found):
        cells = ['%.0f / %.0f, %.2f' % tuple(np.mean(found[pose, way], axis=0)) for way in ('linear', *WAYS)]
        print(f'| {pose} | ' + ' | '.join(cells) + ' |')


main()
