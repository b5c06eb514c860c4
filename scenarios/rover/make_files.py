#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Writes the models, the image and the sounds of this world, beside this file.

usage: make_files.py
"""
import json
import math
import pathlib
import struct
import zlib

HERE = pathlib.Path(__file__).parent


def png(width, height, pixel):
    """A PNG file; pixel(x, y) gives four bytes."""
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


class Model:
    """Flat triangles by material, as a .glb."""

    def __init__(self):
        self.parts = {}

    def face(self, material, *corners, places=None):
        """A convex face, counter-clockwise seen from outside."""
        for i in range(1, len(corners) - 1):
            for j in (0, i, i + 1):
                self.parts.setdefault(material, []).append((corners[j], places[j] if places else (0, 0)))

    def box(self, material, low, high, skew=0.0):
        """Between two corners; the top is narrower by `skew` at the front and at the back."""
        (x0, y0, z0), (x1, y1, z1) = low, high
        a, b, c, d = (x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)
        e, f, g, h = (x0, y1, z0 + skew), (x1, y1, z0 + skew), (x1, y1, z1 - skew), (x0, y1, z1 - skew)
        for face in ((e, h, g, f), (a, b, c, d), (d, c, g, h), (b, a, e, f), (c, b, f, g), (a, d, h, e)):
            self.face(material, *face)

    def wheel(self, material, hub, middle, radius, width, sides=14):
        x, y, z = middle
        ring = [(y + radius * math.cos(2 * math.pi * i / sides), z + radius * math.sin(2 * math.pi * i / sides))
                for i in range(sides)]
        for i in range(sides):
            (ya, za), (yb, zb) = ring[i], ring[(i + 1) % sides]
            left, right = x - width / 2, x + width / 2
            self.face(material, (left, ya, za), (left, yb, zb), (right, yb, zb), (right, ya, za))
            for side, first, second in ((right, (ya, za), (yb, zb)), (left, (yb, zb), (ya, za))):
                self.face(hub, (side, y, z), (side, *first), (side, *second))

    def write(self, name, materials, images=()):
        binary, views, accessors, primitives = b"", [], [], []

        def view(content):
            nonlocal binary
            views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(content)})
            binary += content + b"\0" * (-len(content) % 4)
            return len(views) - 1
        for material, corners in self.parts.items():
            attributes = {}
            for attribute, kind, values in (("POSITION", "VEC3", [c[0] for c in corners]), ("TEXCOORD_0", "VEC2", [c[1] for c in corners])):
                flat = [number for value in values for number in value]
                accessor = {"bufferView": view(struct.pack(f"<{len(flat)}f", *flat)), "componentType": 5126, "count": len(corners), "type": kind}
                if kind == "VEC3":
                    accessor["min"] = [min(v[i] for v in values) for i in range(3)]
                    accessor["max"] = [max(v[i] for v in values) for i in range(3)]
                accessors.append(accessor)
                attributes[attribute] = len(accessors) - 1
            primitives.append({"attributes": attributes, "material": list(materials).index(material)})
        gltf = {
            "asset": {"version": "2.0", "generator": "make_files.py"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": name}],
            "meshes": [{"primitives": primitives}],
            "materials": [{"name": key, "pbrMetallicRoughness": value} for key, value in materials.items()],
            "accessors": accessors, "bufferViews": views,
        }
        if images:
            gltf["images"] = [{"bufferView": view(image), "mimeType": "image/png"} for image in images]
            gltf["textures"] = [{"source": i} for i in range(len(images))]
        gltf["buffers"] = [{"byteLength": len(binary)}]
        text = json.dumps(gltf, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        body = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
        (HERE / f"{name}.glb").write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)


def color(red, green, blue):
    return {"baseColorFactor": [red ** 2.2, green ** 2.2, blue ** 2.2, 1], "metallicFactor": 0}


def rover():
    model = Model()
    model.box("body", (-0.6, 0.3, -0.9), (0.6, 0.62, 0.9), 0.12)
    model.box("cabin", (-0.42, 0.62, -0.45), (0.42, 0.98, 0.3), 0.16)
    model.box("panel", (-0.75, 1.02, -0.95), (0.75, 1.06, -0.3))
    model.box("mast", (-0.04, 0.6, -0.7), (0.04, 1.02, -0.62))
    model.box("mast", (0.28, 0.62, 0.5), (0.32, 1.5, 0.54))
    model.box("lamp", (0.18, 1.5, 0.42), (0.42, 1.66, 0.62))
    for x in (-0.66, 0.66):
        for z in (-0.62, 0.0, 0.62):
            model.wheel("tyre", "hub", (x, 0.26, z), 0.26, 0.2)
    # The solar panel has its colours from a texture: cells in rows.
    cells = png(8, 4, lambda x, y: (24, 52, 120 + 90 * ((x + y) % 2), 255))
    rows = [(-0.75 + 1.5 * i / 6, -0.75 + 1.5 * (i + 1) / 6) for i in range(6)]
    for i, (x0, x1) in enumerate(rows):
        place = ((i + 0.5) / 8, 0.1)
        model.face("cells", (x0, 1.061, -0.95), (x0, 1.061, -0.3), (x1, 1.061, -0.3), (x1, 1.061, -0.95), places=[place] * 4)
    model.write("rover", {
        "body": color(0.93, 0.93, 0.90), "cabin": color(0.16, 0.22, 0.30), "panel": color(0.35, 0.36, 0.40), "mast": color(0.6, 0.6, 0.62),
        "lamp": color(0.98, 0.72, 0.15), "tyre": color(0.12, 0.12, 0.13), "hub": color(0.75, 0.45, 0.15),
        "cells": {"baseColorTexture": {"index": 0}},
    }, [cells])


def crystal():
    model = Model()
    sides = 6
    for i in range(sides):
        at = [(0.28 * math.cos(2 * math.pi * k / sides), 0.28 * math.sin(2 * math.pi * k / sides)) for k in (i, i + 1)]
        (xa, za), (xb, zb) = at
        material = "light" if i % 2 else "dark"
        model.face(material, (xa, 0.35, za), (0, 0.95, 0), (xb, 0.35, zb))
        model.face(material, (xb, 0.35, zb), (0, 0.0, 0), (xa, 0.35, za))
    model.write("crystal", {"light": color(0.45, 0.95, 0.95), "dark": color(0.10, 0.60, 0.80)})


def badge():
    """A round badge with a crystal."""
    size = 96

    def pixel(x, y):
        u, v = (x + 0.5) / size * 2 - 1, (y + 0.5) / size * 2 - 1
        away = math.hypot(u, v)
        alpha = max(0, min(255, int((1 - away) * size / 2 * 255)))
        if abs(u) * 1.5 + abs(v) < 0.62:
            return (110, 240, 240, alpha) if (u > 0) == (v > 0) else (30, 160, 210, alpha)
        return (240, 180, 60, alpha) if away > 0.84 else (24, 34, 60, alpha)
    (HERE / "badge.png").write_bytes(png(size, size, pixel))


def sound(name, seconds, wave):
    rate = 22050
    samples = b"".join(struct.pack("<h", int(max(-1, min(1, wave(i / rate))) * 32000)) for i in range(int(seconds * rate)))
    head = struct.pack("<4sI4s4sIHHIIHH4sI", b"RIFF", 36 + len(samples), b"WAVE", b"fmt ", 16, 1, 1, rate, 2 * rate, 2, 16, b"data", len(samples))
    (HERE / f"{name}.wav").write_bytes(head + samples)


def sounds():
    def chime(t):
        return 0.5 * math.exp(-5 * t) * (math.sin(2 * math.pi * 880 * t) + 0.5 * math.sin(2 * math.pi * 1320 * t))

    def click(t):
        return 0.4 * math.exp(-60 * t) * math.sin(2 * math.pi * 420 * t)
    sound("chime", 0.7, chime)
    sound("click", 0.08, click)


if __name__ == "__main__":
    rover()
    crystal()
    badge()
    sounds()
