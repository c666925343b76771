#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""One table of sinew, Blender's automatic weights and geodesic voxel binding on a folder of characters.

    python3 tests/bench/peers.py BUILD_DIR CHARACTERS_DIR [repeats]

Needs BUILD_DIR/tests/bench/sinew_bench_peers and the command `blender` (Debian package blender). Writes BUILD_DIR/peers.csv and prints the
medians over the characters. Processor seconds of one thread.
"""
import csv
import os
import shutil
import statistics
import subprocess
import sys


def rows(command, header):
    run = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    lines = run.stdout.splitlines()  # Blender talks before and after the table
    starts = [i for i, line in enumerate(lines) if line.startswith(header)]
    if run.returncode != 0 or not starts:
        sys.exit(f"{command[0]}: failed with exit code {run.returncode}")
    columns = lines[starts[0]].count(",")
    return list(csv.DictReader(line for line in lines[starts[0] :] if line.count(",") == columns))


def main():
    if len(sys.argv) < 3:
        sys.exit("usage: peers.py BUILD_DIR CHARACTERS_DIR [repeats]")
    build, folder = sys.argv[1:3]
    repeats = sys.argv[3] if len(sys.argv) > 3 else "3"
    here = os.path.dirname(os.path.abspath(__file__))
    model = os.path.join(here, "..", "..", "samples", "data", "sinew_default.sinew")
    bench = os.path.join(build, "tests", "bench", "sinew_bench_peers")
    if not os.path.isfile(bench):
        sys.exit(f"peers.py: {bench} is missing: configure with -DSINEW_BUILD_BENCH=ON and build sinew_bench_peers")
    if not os.path.isdir(folder):
        sys.exit(f"peers.py: {folder} is no folder: expected one of NAME.obj + NAME.rig.txt")
    if shutil.which("blender") is None:
        sys.exit("peers.py: the command blender is missing: apt-get install blender")
    script = os.path.join(here, "blender_heat.py")
    ours = rows([bench, model, folder, repeats], "machine,")
    blender = {
        row["character"]: row
        for row in rows(
            ["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python", script, "--", folder, repeats],
            "character,")
    }
    for row in ours:
        other = blender[row["character"]]
        row["blender_s"], row["blender_bound"] = other["blender_s"], other["bound"]
        row["blender_over_sinew"] = f"{float(row['blender_s']) / float(row['sinew_s']):.2f}"
        row["geodesic_voxel_over_sinew"] = f"{float(row['geodesic_voxel_s']) / float(row['sinew_s']):.2f}"
    path = os.path.join(build, "peers.csv")
    with open(path + ".tmp", "w", newline="") as out:
        writer = csv.DictWriter(out, fieldnames=ours[0].keys())
        writer.writeheader()
        writer.writerows(ours)
    os.replace(path + ".tmp", path)
    for column in ("sinew_s", "blender_s", "geodesic_voxel_s", "blender_over_sinew", "geodesic_voxel_over_sinew"):
        values = sorted(float(row[column]) for row in ours)
        print(f"{column}: median {statistics.median(values):.4f}, {values[0]:.4f} to {values[-1]:.4f}, {len(values)} characters")
    print(path)


main()
