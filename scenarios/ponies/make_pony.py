#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Writes pony.gltf beside this file: a model with a skin of 19 joints and five animations.

usage: make_pony.py
"""
import base64
import json
import math
import pathlib
import struct

HERE = pathlib.Path(__file__).parent

# Name, parent, position in m (x left, y up, z forwards).
JOINTS = [
    ("body", None, (0, 0.98, -0.28)), ("chest", "body", (0, 0.98, 0.26)), ("neck", "chest", (0, 1.10, 0.44)),
    ("nape", "neck", (0, 1.34, 0.60)), ("head", "nape", (0, 1.52, 0.70)), ("tail", "body", (0, 1.08, -0.58)),
    ("tail_end", "tail", (0, 0.84, -0.72)),
]
for side, x in (("left", 0.15), ("right", -0.15)):
    JOINTS += [(f"{side}_thigh", "body", (x, 0.92, -0.42)), (f"{side}_hock", f"{side}_thigh", (x, 0.52, -0.47)), (f"{side}_hind_foot", f"{side}_hock", (x, 0.14, -0.43)),
               (f"{side}_shoulder", "chest", (x, 0.88, 0.32)), (f"{side}_knee", f"{side}_shoulder", (x, 0.50, 0.34)), (f"{side}_fore_foot", f"{side}_knee", (x, 0.14, 0.34))]
# The lids are meshes of their own that the head carries.
JOINTS += [("lids", "head", (0, 1.57, 0.76))]
PLACE = {name: place for name, _, place in JOINTS}
NUMBER = {name: number for number, (name, _, _) in enumerate(JOINTS)}


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a)) or 1
    return tuple(x / length for x in a)


class Skin:
    """Corners with joints, by material."""

    def __init__(self):
        self.corners = []  # position, normal, joints, weights
        self.faces = {}

    def loft(self, material, rings, around=12):
        """Rings of (centre, half width, half height, {joint: weight}); their planes are upright to the way through their centres."""
        first = len(self.corners)
        middles = [ring[0] for ring in rings]
        for i, (centre, wide, high, by) in enumerate(rings):
            way = unit(minus(middles[min(i + 1, len(rings) - 1)], middles[max(i - 1, 0)]))
            across = unit(cross((0, 1, 0) if abs(way[1]) < 0.9 else (0, 0, 1), way))
            up = cross(way, across)
            names = sorted(by, key=by.get, reverse=True)[:4]
            total = sum(by[name] for name in names)
            joints = [NUMBER[name] for name in names] + [0] * (4 - len(names))
            weights = [by[name] / total for name in names] + [0] * (4 - len(names))
            for k in range(around):
                angle = 2 * math.pi * k / around
                c, s = math.cos(angle), math.sin(angle)
                place = tuple(centre[a] + across[a] * wide * c + up[a] * high * s for a in range(3))
                normal = unit(tuple(across[a] * c / wide + up[a] * s / high for a in range(3)))
                # The ends are round.
                lean = (-0.8 if i == 0 else 0.8 if i == len(rings) - 1 else 0)
                normal = unit(tuple(normal[a] + way[a] * lean for a in range(3)))
                self.corners.append((place, normal, joints, weights))
        faces = self.faces.setdefault(material, [])
        for i in range(len(rings) - 1):
            for k in range(around):
                a, b = first + i * around + k, first + i * around + (k + 1) % around
                faces += [a, b, b + around, a, b + around, a + around]
        for i, order in ((0, 1), (len(rings) - 1, -1)):
            ring = [first + i * around + k for k in range(around)][::-order]
            for k in range(1, around - 1):
                faces += [ring[0], ring[k], ring[k + 1]]


def between(a, b, share):
    return tuple(x + (y - x) * share for x, y in zip(a, b))


def limb(skin, coat, names, radii, foot):
    """A leg from the trunk to the ground through its joints."""
    trunk, rings = ("body" if "thigh" in names[0] else "chest"), []
    top = PLACE[names[0]]
    rings.append(((top[0] * 0.8, top[1] + 0.10, top[2]), radii[0] * 0.9, radii[0] * 1.2, {trunk: 0.7, names[0]: 0.3}))
    rings.append((top, radii[0], radii[0] * 1.25, {trunk: 0.35, names[0]: 0.65}))
    for i in range(2):
        a, b = PLACE[names[i]], PLACE[names[i + 1]]
        for share in (0.35, 0.7):
            wide = radii[i] + (radii[i + 1] - radii[i]) * share
            rings.append((between(a, b, share), wide, wide * 1.05, {names[i]: 1}))
        rings.append((b, radii[i + 1] * 1.1, radii[i + 1] * 1.15, {names[i]: 0.5, names[i + 1]: 0.5}))
    end = PLACE[names[2]]
    skin.loft(coat, rings + [((end[0], 0.11, end[2] + 0.01), 0.042, 0.046, {names[2]: 1})], 10)
    skin.loft(foot, [((end[0], y, end[2] + z), r, r * 1.2, {names[2]: 1}) for y, z, r in ((0.12, 0.01, 0.045), (0.05, 0.02, 0.06), (0.0, 0.03, 0.072))], 10)


def trunk(skin):
    rows = [(-0.66, 1.02, 0.08, 0.09, {"body": 1}), (-0.60, 1.01, 0.17, 0.18, {"body": 1}), (-0.46, 0.99, 0.235, 0.235, {"body": 1}), (-0.26, 0.97, 0.245, 0.235, {"body": 1}),
            (-0.08, 0.95, 0.25, 0.235, {"body": 0.7, "chest": 0.3}), (0.08, 0.95, 0.245, 0.24, {"body": 0.3, "chest": 0.7}), (0.24, 0.97, 0.225, 0.245, {"chest": 1}),
            (0.40, 1.00, 0.19, 0.225, {"chest": 1}), (0.49, 1.02, 0.13, 0.16, {"chest": 0.8, "neck": 0.2}), (0.53, 1.03, 0.07, 0.09, {"chest": 0.7, "neck": 0.3})]
    skin.loft("coat", [((0, y, z), wide, high, by) for z, y, wide, high, by in rows], 16)


def neck_and_head(skin):
    skin.loft("coat", [((0, 1.00, 0.34), 0.13, 0.19, {"chest": 1}), ((0, 1.12, 0.45), 0.115, 0.165, {"chest": 0.4, "neck": 0.6}), ((0, 1.24, 0.53), 0.095, 0.135, {"neck": 1}),
                       ((0, 1.35, 0.60), 0.088, 0.125, {"neck": 0.5, "nape": 0.5}), ((0, 1.44, 0.65), 0.084, 0.115, {"nape": 1}), ((0, 1.52, 0.695), 0.082, 0.105, {"nape": 0.4, "head": 0.6}),
                       ((0, 1.57, 0.74), 0.06, 0.07, {"head": 1})])
    skin.loft("coat", [((0, 1.60, 0.66), 0.05, 0.06, {"head": 1}), ((0, 1.58, 0.71), 0.088, 0.10, {"head": 1}), ((0, 1.535, 0.80), 0.09, 0.098, {"head": 1}),
                       ((0, 1.47, 0.90), 0.068, 0.075, {"head": 1}), ((0, 1.425, 0.965), 0.058, 0.062, {"head": 1})])
    skin.loft("muzzle", [((0, 1.43, 0.955), 0.06, 0.064, {"head": 1}), ((0, 1.40, 0.995), 0.062, 0.06, {"head": 1}), ((0, 1.385, 1.025), 0.035, 0.035, {"head": 1})])
    for side in (1, -1):
        skin.loft("coat", [((side * 0.05, 1.64, 0.68), 0.034, 0.02, {"head": 1}), ((side * 0.062, 1.70, 0.685), 0.028, 0.015, {"head": 1}), ((side * 0.066, 1.765, 0.70), 0.006, 0.005, {"head": 1})], 8)
        skin.loft("eye", [((side * (0.07 + d), 1.57, 0.765), r, r, {"head": 1}) for d, r in ((0.0, 0.025), (0.018, 0.024), (0.026, 0.012))], 8)
    # The mane follows the neck; its tufts overlap.
    line = [((0, 1.67, 0.735), "head"), ((0, 1.665, 0.66), "head"), ((0, 1.575, 0.575), "nape"), ((0, 1.47, 0.505), "nape"), ((0, 1.36, 0.435), "neck"), ((0, 1.26, 0.35), "neck"), ((0, 1.21, 0.26), "chest")]
    skin.loft("mane", [(place, 0.03, 0.055 if i not in (0, len(line) - 1) else 0.02, {by: 1}) for i, (place, by) in enumerate(line)], 8)
    skin.loft("mane", [((0, 1.67, 0.70), 0.03, 0.02, {"head": 1}), ((0, 1.655, 0.77), 0.035, 0.02, {"head": 1}), ((0.01, 1.60, 0.83), 0.02, 0.012, {"head": 1})], 8)


def tail(skin):
    skin.loft("mane", [((0, 1.10, -0.60), 0.03, 0.03, {"body": 0.4, "tail": 0.6}), ((0, 1.04, -0.69), 0.05, 0.05, {"tail": 1}), ((0, 0.84, -0.75), 0.065, 0.07, {"tail": 0.4, "tail_end": 0.6}),
                       ((0, 0.62, -0.77), 0.055, 0.06, {"tail_end": 1}), ((0, 0.42, -0.75), 0.012, 0.015, {"tail_end": 1})], 10)


def turn(x=0.0, y=0.0, z=0.0):
    """A rotation by angles in degrees: first about z, then x, then y."""
    def one(axis, degrees):
        half = math.radians(degrees) / 2
        return tuple(math.sin(half) if i == axis else 0.0 for i in range(3)) + (math.cos(half),)

    def times(a, b):
        ax, ay, az, aw = a
        bx, by, bz, bw = b
        return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx, aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz)
    return times(one(1, y), times(one(0, x), one(2, z)))


def wave(t, phase=0.0):
    return math.sin(2 * math.pi * (t + phase))


def legs(pose, t, phases, swing, lift, hind=1.0):
    """Four legs: each swings forwards while it is lifted."""
    for (name, phase) in phases.items():
        is_hind = name.endswith("hind")
        side = name.split("_")[0]
        forwards, raised = wave(t, phase), max(0.0, wave(t, phase + 0.25)) ** 0.7
        # Positive angles about x move the end of a hanging limb backwards.
        if is_hind:
            pose[f"{side}_thigh"] = turn(-swing * hind * forwards - 0.35 * lift * raised)
            pose[f"{side}_hock"] = turn(lift * 1.1 * raised)
            pose[f"{side}_hind_foot"] = turn(lift * 0.7 * raised)
        else:
            pose[f"{side}_shoulder"] = turn(-swing * forwards - 0.45 * lift * raised)
            pose[f"{side}_knee"] = turn(lift * 1.3 * raised)
            pose[f"{side}_fore_foot"] = turn(lift * 0.8 * raised)


WALK = {"left_hind": 0.0, "left_fore": 0.25, "right_hind": 0.5, "right_fore": 0.75}
TROT = {"left_hind": 0.0, "right_fore": 0.02, "right_hind": 0.5, "left_fore": 0.52}


def idle(t):
    pose = {"neck": turn(2 * wave(t), 7 * wave(t, 0.1)), "nape": turn(2 * wave(t, 0.2), 10 * wave(t, 0.15)), "head": turn(3 * wave(2 * t)),
            "tail": turn(6, 0, 14 * wave(2 * t)), "tail_end": turn(0, 0, 18 * wave(2 * t, -0.15)), "chest": turn(0.8 * wave(2 * t))}
    return pose, (0, 0.006 * wave(2 * t), 0)


def graze(t):
    bite = wave(3 * t)
    pose = {"chest": turn(15), "neck": turn(97 + 2 * wave(t), 8 * wave(t)), "nape": turn(15 + 3 * bite, 8 * wave(t, 0.1)), "head": turn(-48 + 5 * bite),
            "tail": turn(4, 0, 22 * wave(3 * t)), "tail_end": turn(0, 0, 26 * wave(3 * t, -0.15)),
            "left_shoulder": turn(-34), "left_knee": turn(6), "right_shoulder": turn(-4), "right_knee": turn(-8)}
    return pose, (0, -0.01, 0.02)


def walk(t):
    pose = {"neck": turn(10 + 5 * wave(2 * t, 0.1)), "nape": turn(4 * wave(2 * t, 0.2)), "head": turn(4 - 3 * wave(2 * t)), "body": turn(0, 2 * wave(t), 1.5 * wave(t)),
            "chest": turn(0, -4 * wave(t), -1.5 * wave(t)), "tail": turn(8, 0, 12 * wave(t)), "tail_end": turn(4, 0, 16 * wave(t, -0.15))}
    legs(pose, t, WALK, 20, 38)
    return pose, (0, 0.012 * wave(2 * t), 0)


def trot(t):
    pose = {"neck": turn(-4 + 3 * wave(2 * t, 0.1)), "nape": turn(6), "head": turn(6 - 3 * wave(2 * t)), "body": turn(1.5 * wave(2 * t)), "chest": turn(-2 * wave(2 * t)),
            "tail": turn(34 + 6 * wave(2 * t)), "tail_end": turn(22 * wave(2 * t, -0.2))}
    legs(pose, t, TROT, 31, 62)
    return pose, (0, 0.045 * abs(wave(t, 0.12)), 0)


def rear(t):
    """Up on the hind legs, and down again."""
    def ease(a, b):
        share = min(1.0, max(0.0, (t - a) / (b - a)))
        return share * share * (3 - 2 * share)
    up = ease(0.06, 0.36) - ease(0.70, 0.96)
    paddle = wave(4 * t) * up
    pose = {"body": turn(-46 * up), "chest": turn(-14 * up), "neck": turn(16 * up), "nape": turn(18 * up), "head": turn(16 * up + 6 * paddle), "tail": turn(40 * up), "tail_end": turn(-20 * up)}
    for side, sign in (("left", 1), ("right", -1)):
        pose[f"{side}_thigh"] = turn(34 * up)
        pose[f"{side}_hock"] = turn(14 * up)
        pose[f"{side}_hind_foot"] = turn(-4 * up)
        pose[f"{side}_shoulder"] = turn(-38 * up + 22 * sign * paddle)
        pose[f"{side}_knee"] = turn(78 * up - 22 * sign * paddle)
        pose[f"{side}_fore_foot"] = turn(40 * up)
    return pose, (0, 0.10 * up, -0.12 * up)


# Name, function, length in s, number of poses, moments at which the eyes close.
ANIMATIONS = [("idle", idle, 4.0, 25, (0.9, 3.1)), ("graze", graze, 3.0, 25, (1.7,)), ("walk", walk, 1.1, 17, ()), ("trot", trot, 0.62, 17, ()), ("rear", rear, 2.0, 25, (0.1,))]


class File:
    def __init__(self):
        self.binary, self.views, self.accessors = b"", [], []

    def accessor(self, values, kind, component="f", extremes=False, normalised=False):
        flat = [number for value in values for number in (value if isinstance(value, (tuple, list)) else (value,))]
        content = struct.pack(f"<{len(flat)}{component}", *flat)
        self.views.append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(content)})
        self.binary += content + b"\0" * (-len(content) % 4)
        made = {"bufferView": len(self.views) - 1, "componentType": {"f": 5126, "B": 5121, "H": 5123}[component], "count": len(values), "type": kind}
        if normalised:
            made["normalized"] = True
        if extremes:
            rows = [value if isinstance(value, (tuple, list)) else (value,) for value in values]
            made["min"], made["max"] = [min(column) for column in zip(*rows)], [max(column) for column in zip(*rows)]
        self.accessors.append(made)
        return len(self.accessors) - 1


def in_bytes(weights):
    """Weights as bytes that add up to 255."""
    rounded = [round(255 * weight) for weight in weights]
    rounded[0] += 255 - sum(rounded)
    return rounded


def color(red, green, blue):
    return {"baseColorFactor": [round(part ** 2.2, 4) for part in (red, green, blue)] + [1], "metallicFactor": 0}


MATERIALS = {"coat": color(0.72, 0.47, 0.27), "mane": color(0.93, 0.86, 0.70), "muzzle": color(0.36, 0.24, 0.20), "hoof": color(0.20, 0.16, 0.15), "eye": color(0.06, 0.05, 0.06)}


def write():
    skin = Skin()
    trunk(skin)
    neck_and_head(skin)
    tail(skin)
    for side in ("left", "right"):
        limb(skin, "coat", [f"{side}_thigh", f"{side}_hock", f"{side}_hind_foot"], (0.13, 0.065, 0.04), "hoof")
        limb(skin, "coat", [f"{side}_shoulder", f"{side}_knee", f"{side}_fore_foot"], (0.105, 0.055, 0.038), "hoof")

    file = File()
    corners = skin.corners
    attributes = {"POSITION": file.accessor([c[0] for c in corners], "VEC3", extremes=True), "NORMAL": file.accessor([c[1] for c in corners], "VEC3"),
                  "JOINTS_0": file.accessor([c[2] for c in corners], "VEC4", "B"), "WEIGHTS_0": file.accessor([in_bytes(c[3]) for c in corners], "VEC4", "B", normalised=True)}
    names = list(MATERIALS)
    meshes = [{"name": "pony", "primitives": [{"attributes": attributes, "indices": file.accessor(faces, "SCALAR", "H"), "material": names.index(material)} for material, faces in skin.faces.items()]}]

    # Lids: a small cap over each eye, relative to their node. At scale 0.01 they are open.
    lids = Skin()
    for side in (1, -1):
        lids.loft("coat", [((side * (0.066 + d), 0, 0.004), r, r, {"lids": 1}) for d, r in ((0.0, 0.034), (0.022, 0.033), (0.034, 0.018))], 8)
    meshes.append({"name": "lids", "primitives": [{"attributes": {"POSITION": file.accessor([c[0] for c in lids.corners], "VEC3", extremes=True), "NORMAL": file.accessor([c[1] for c in lids.corners], "VEC3")},
                                                   "indices": file.accessor(lids.faces["coat"], "SCALAR", "H"), "material": 0}]})

    nodes = []
    for name, parent, place in JOINTS:
        node = {"name": name, "translation": [round(x, 4) for x in (minus(place, PLACE[parent]) if parent else place)]}
        children = [NUMBER[child] for child, above, _ in JOINTS if above == name]
        if children:
            node["children"] = children
        nodes.append(node)
    nodes[NUMBER["lids"]].update({"mesh": 1, "scale": [0.01, 0.01, 0.01]})
    nodes.append({"name": "pony", "mesh": 0, "skin": 0})
    joints = [number for name, number in NUMBER.items() if name != "lids"]
    inverse = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, *(-x for x in PLACE[name]), 1) for name in NUMBER if name != "lids"]
    skins = [{"joints": joints, "inverseBindMatrices": file.accessor(inverse, "MAT4")}]

    animations = []
    for name, pose_at, length, count, blinks in ANIMATIONS:
        times = [length * i / (count - 1) for i in range(count)]
        poses = [pose_at(i / (count - 1)) for i in range(count)]
        samplers, channels = [], []

        def add(node, path, of_times, values, kind, interpolation="LINEAR"):
            samplers.append({"input": of_times, "output": file.accessor(values, kind), "interpolation": interpolation})
            channels.append({"sampler": len(samplers) - 1, "target": {"node": NUMBER[node], "path": path}})
        shared = file.accessor(times, "SCALAR", extremes=True)
        for joint in sorted({joint for pose, _ in poses for joint in pose}, key=NUMBER.get):
            add(joint, "rotation", shared, [pose.get(joint, (0, 0, 0, 1)) for pose, _ in poses], "VEC4")
        add("body", "translation", shared, [tuple(a + b for a, b in zip(PLACE["body"], moved)) for _, moved in poses], "VEC3")
        if blinks:
            moments, sizes = [0.0], [(0.01,) * 3]
            for blink in blinks:
                moments += [blink, blink + 0.14]
                sizes += [(1.0,) * 3, (0.01,) * 3]
            add("lids", "scale", file.accessor(moments, "SCALAR", extremes=True), sizes, "VEC3", "STEP")
        animations.append({"name": name, "samplers": samplers, "channels": channels})

    gltf = {
        "asset": {"version": "2.0", "generator": "make_pony.py"}, "scene": 0, "scenes": [{"nodes": [NUMBER["body"], len(JOINTS)]}], "nodes": nodes, "meshes": meshes, "skins": skins,
        "animations": animations, "materials": [{"name": name, "pbrMetallicRoughness": value} for name, value in MATERIALS.items()], "accessors": file.accessors, "bufferViews": file.views,
        "buffers": [{"byteLength": len(file.binary), "uri": "data:application/octet-stream;base64," + base64.b64encode(file.binary).decode()}],
    }
    (HERE / "pony.gltf").write_text(json.dumps(gltf, separators=(",", ":")) + "\n")
    print(len(corners), "corners,", sum(map(len, skin.faces.values())) // 3, "triangles,", len(file.binary), "bytes")


if __name__ == "__main__":
    write()
