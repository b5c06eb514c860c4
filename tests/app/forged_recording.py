# SPDX-License-Identifier: BSD-2-Clause
"""Creates recordings with other headers than the program writes (docs/dev/recording_format.md)."""
import struct

MAGIC = b"\x53\x4f\x41\x52\x42\x4f\x58\x1a"
FRAME = "<HHIIIQQQ"
MASK = (1 << 64) - 1
HEADER = 1


def hash_of(values):
    state = 0x51A7B0C5D3E9F126
    for value in values:
        state = ((state ^ value) * 0x9E3779B97F4A7C15) & MASK
        state ^= state >> 29
    return state


def payload_hash(payload):
    whole = len(payload) // 8 * 8
    values = [len(payload), *struct.unpack(f"<{whole // 8}Q", payload[:whole])]
    if whole < len(payload):
        values.append(int.from_bytes(payload[whole:], "little"))
    return hash_of(values)


def number(value):
    text = bytearray()
    while True:
        byte, value = value & 0x7F, value >> 7
        text.append(byte | (0x80 if value else 0))
        if not value:
            return bytes(text)


def text(words):
    raw = words if isinstance(words, bytes) else words.encode()
    return number(len(raw)) + raw


def zstd_frame(content):
    """One zstd frame with uncompressed blocks."""
    blocks = [content[at:at + 100_000] for at in range(0, len(content), 100_000)] or [b""]
    frame = struct.pack("<IBI", 0xFD2FB528, 0xA0, len(content))
    for i, block in enumerate(blocks):
        frame += (len(block) << 3 | (i == len(blocks) - 1)).to_bytes(3, "little") + block
    return frame


def block(kind, content, ticks=0, first=0, version=4):
    payload = zstd_frame(content)
    checksum = payload_hash(payload)
    frame = hash_of([version << 16 | kind, len(payload) << 32 | len(content), ticks, first, checksum])
    return struct.pack(FRAME, version, kind, len(payload), len(content), ticks, first, checksum, frame) + payload


def header(scenario, folder="/", further=(), files=(), seed=1, build="forged", memory_mb=2048, own_kernel=1):
    """The block of a header. `files`: (number of the folder, name, contents) of each."""
    content = text(build) + text(scenario) + text(folder) + number(len(further)) + b"".join(map(text, further))
    content += bytes(8) + number(seed) + number(1280) + number(720) + struct.pack("<d", 1 / 30) + bytes([1, own_kernel])
    content += text("") + number(0) + number(len(files))
    for place, name, what in files:
        content += number(place) + text(name) + text(what)
    return block(HEADER, content + number(memory_mb))


def with_header(recording, made):
    """The bytes of a recording, with its header replaced."""
    data, at, rest = recording.read_bytes(), len(MAGIC), b""
    while at < len(data):
        frame = struct.unpack_from(FRAME, data, at)
        end = at + struct.calcsize(FRAME) + frame[2]
        if frame[1] != HEADER:
            rest += data[at:end]
        at = end
    return MAGIC + made + rest
