# SPDX-License-Identifier: BSD-2-Clause
"""Reads the pixels of a PNG: 8 bits per channel, RGB or RGBA, not interlaced, as the program writes it."""
import struct
import zlib


class Picture:
    def __init__(self, path):
        data = path.read_bytes()
        if data[:8] != b"\x89PNG\r\n\x1a\n":
            raise ValueError(f"{path} is not a PNG file")
        offset, packed = 8, b""
        while offset < len(data):
            length, kind = struct.unpack(">I4s", data[offset:offset + 8])
            body = data[offset + 8:offset + 8 + length]
            if kind == b"IHDR":
                self.width, self.height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", body)
                if depth != 8 or colour not in (2, 6) or interlace:
                    raise ValueError(f"{path}: depth {depth}, colour type {colour}, interlace {interlace}")
                self._channels = 3 if colour == 2 else 4
            elif kind == b"IDAT":
                packed += body
            offset += 12 + length
        self._rows = self._unfilter(zlib.decompress(packed))

    def _unfilter(self, raw):
        size, step = self.width * self._channels, self._channels
        rows, above = [], bytearray(size)
        for y in range(self.height):
            start = y * (size + 1)
            method, row = raw[start], bytearray(raw[start + 1:start + 1 + size])
            for i in range(size):
                left = row[i - step] if i >= step else 0
                up, corner = above[i], above[i - step] if i >= step else 0
                if method == 1:
                    row[i] = (row[i] + left) & 255
                elif method == 2:
                    row[i] = (row[i] + up) & 255
                elif method == 3:
                    row[i] = (row[i] + (left + up) // 2) & 255
                elif method == 4:
                    guess = left + up - corner
                    by = (abs(guess - left), abs(guess - up), abs(guess - corner))
                    row[i] = (row[i] + (left, up, corner)[by.index(min(by))]) & 255
            rows.append(row)
            above = row
        return rows

    def at(self, x, y):
        i = x * self._channels
        return tuple(self._rows[y][i:i + 3])

    def count(self, test, box=None, step=1):
        """The number of pixels in a box (left, top, right, bottom) that pass the test, of every `step`-th in both directions."""
        left, top, right, bottom = box or (0, 0, self.width, self.height)
        return sum(1 for y in range(top, bottom, step) for x in range(left, right, step) if test(*self.at(x, y)))
