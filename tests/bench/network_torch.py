# SPDX-License-Identifier: MIT
"""The network of a bind in PyTorch, for sinew_bench_network: reads what it wrote, then runs once per line of standard
input, printing the seconds of processor time that the pass took. What depends on the graph alone is made before.

    network_torch.py FOLDER"""
import json
import sys
import time

import numpy
import torch

torch.set_num_threads(1)
folder = sys.argv[1]
with open(folder + "/network.json") as file:
    spec = json.load(file)
U, K, J = spec["vertices"], spec["candidates"], spec["joints"]
raw = open(folder + "/arrays.bin", "rb").read()
at = 0


def take(dtype, count):
    global at
    values = numpy.frombuffer(raw, dtype, count, at).copy()
    at += values.nbytes
    return values


buffers = []
for number, (pair, channels) in enumerate(spec["buffers"]):
    rows = U * K if pair else U
    values = take("<f4", rows * channels).reshape(rows, channels) if number < 2 else numpy.zeros((rows, channels), "f4")
    buffers.append(torch.from_numpy(values))
joints = take("<u2", U * K).astype("i8")
row_offsets, part_of = take("<u4", U + 1).astype("i8"), take("<u4", U).astype("i8")
columns = take("<u4", int(row_offsets[-1])).astype("i8")
linears = []
for inputs, outputs in spec["linears"]:
    weights = take("<f4", inputs * outputs).reshape(outputs, inputs)
    linears.append((torch.from_numpy(weights), torch.from_numpy(take("<f4", outputs))))
assert at == len(raw)

present = joints != 0xFFFF
all_present = bool(present.all())
mask = torch.from_numpy(present.astype("f4")).reshape(-1, 1)


class Mean:
    """Mean over groups of rows: rows source[i] go to group target[i]."""

    def __init__(self, groups, source, target, divisor=None):
        self.groups, self.source, self.target = groups, torch.from_numpy(source), torch.from_numpy(target)
        if divisor is None:
            divisor = numpy.bincount(target, minlength=groups)
        self.scale = torch.from_numpy((1 / numpy.maximum(divisor, 1)).astype("f4")).reshape(-1, 1)

    def __call__(self, rows):
        sums = torch.zeros(self.groups, rows.shape[1])
        sums.index_add_(0, self.target, rows.index_select(0, self.source))
        return sums.mul_(self.scale)


degree = numpy.diff(row_offsets)
edge_to = numpy.repeat(numpy.arange(U), degree)
slots = joints.reshape(U, K)
same = (slots[edge_to][:, :, None] == slots[columns][:, None, :]) & (slots[edge_to][:, :, None] != 0xFFFF)
edge, to_slot, from_slot = numpy.nonzero(same)
pair_to, pair_from = edge_to[edge] * K + to_slot, columns[edge] * K + from_slot
sizes = numpy.bincount(part_of)
ring = {0: Mean(U, columns, edge_to), 1: Mean(U * K, pair_from, pair_to)}
here = numpy.nonzero(present)[0]
keys, group = numpy.unique(part_of[here // K] * J + joints[here], return_inverse=True)
part = {0: Mean(len(sizes), numpy.arange(U), part_of, sizes), 1: Mean(len(keys), here, group, sizes[keys // J])}
group_of_row = numpy.zeros(U * K, "i8")
group_of_row[here] = group
group_of = {0: torch.from_numpy(part_of), 1: torch.from_numpy(group_of_row)}
edges = {0: (torch.from_numpy(columns), torch.from_numpy(edge_to)), 1: (torch.from_numpy(pair_from), torch.from_numpy(pair_to))}
live = torch.from_numpy(here)


def region(r):
    return buffers[r[0]][:, r[1] : r[1] + r[2]]


def run_layer(layer):
    kind, rows = layer["kind"], region(layer["in"])
    pair = spec["buffers"][layer["in"][0]][0]
    if kind == "linear":
        weights, bias = linears[layer["parameters"]]
        out = torch.nn.functional.linear(rows, weights, bias)
        if layer["residual"] is not None:
            out += region(layer["residual"])
        if layer["relu"]:
            out.relu_()
    elif kind == "ring mean":
        out = ring[pair](rows)
    elif kind == "ring max":
        source, target = edges[pair]
        out = torch.full(rows.shape, -1e30)
        out.scatter_reduce_(0, target.reshape(-1, 1).expand(-1, rows.shape[1]), rows.index_select(0, source), "amax")
        out[out == -1e30] = 0
    elif kind == "part mean":
        out = part[pair](rows).index_select(0, group_of[pair])
    elif kind == "global mean":
        out = (rows.index_select(0, live) if pair and not all_present else rows).mean(0)
    elif kind == "global max":
        out = (rows.index_select(0, live) if pair and not all_present else rows).amax(0)
    elif kind == "candidate max":
        valued = rows if all_present else rows.masked_fill(mask == 0, -1e30)
        out = valued.reshape(U, K, -1).amax(1, keepdim=True).expand(-1, K, -1).reshape(U * K, -1)
    elif kind == "vertex to pair":
        out = rows.unsqueeze(1).expand(-1, K, -1).reshape(U * K, -1)
    elif kind == "pair to vertex":
        out = rows.reshape(U, -1)
    elif kind == "vertex to slots":
        out = rows.reshape(U * K, -1)
    else:
        out = rows
    target = region(layer["out"])
    if spec["buffers"][layer["out"][0]][0] and not all_present:
        torch.mul(out, mask, out=target)
    else:
        target.copy_(out)


with torch.inference_mode():
    for line in sys.stdin:
        start = time.thread_time()
        for layer in spec["layers"]:
            run_layer(layer)
        seconds = time.thread_time() - start
        region(spec["layers"][-1]["out"]).numpy().tofile(folder + "/logits.bin")
        print(seconds, flush=True)
