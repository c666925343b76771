#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Turns a GLB into a textual .gltf with its buffer inside, so that it can live in a git repository: glb_to_gltf.py IN.glb OUT.gltf"""
import base64
import json
import struct
import sys

data = open(sys.argv[1], "rb").read()
json_size, = struct.unpack_from("<I", data, 12)
document = json.loads(data[20:20 + json_size])
binary_at = 20 + json_size
binary_size, = struct.unpack_from("<I", data, binary_at)
binary = data[binary_at + 8:binary_at + 8 + binary_size][:document["buffers"][0]["byteLength"]]
document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
with open(sys.argv[2], "w") as out:
    json.dump(document, out, indent=1)
    out.write("\n")
