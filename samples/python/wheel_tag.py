#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The platform tag that a wheel's libraries earn: manylinux_2_N where they need nothing but a C library of at least that version
(PEP 600), else linux_ARCH, which is for machines like this one.

    wheel_tag.py FILE.so ...
"""
import platform
import re
import subprocess
import sys

# What every Linux of PEP 600 has; the version of libstdc++ is not promised with it.
SYSTEM = ("libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "librt.so.1", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1")


def tag(files, machine=platform.machine()):
    newest = (2, 17)  # older ones are not made any more
    own = {f.rsplit("/", 1)[-1] for f in files}
    for file in files:
        said = subprocess.run(["readelf", "-dVW", file], capture_output=True, text=True, check=True).stdout
        needed = set(re.findall(r"\(NEEDED\).*\[([^]]+)\]", said))
        if needed - own - set(SYSTEM):
            return f"linux_{machine}"
        newest = max([newest, *((int(a), int(b)) for a, b in re.findall(r"\bGLIBC_(\d+)\.(\d+)", said))])
    return f"manylinux_{newest[0]}_{newest[1]}_{machine}"


if __name__ == "__main__":
    print(tag(sys.argv[1:]))
