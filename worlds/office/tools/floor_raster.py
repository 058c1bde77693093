# SPDX-License-Identifier: BSD-3-Clause
"""A floor as a raster of cells: carving, clearance and PNG output. One big integer a row."""

import math
import struct
import zlib

CELL = 0.05


class Raster:
    """Cells of 0.05 m; bit set = occupied. Row 0 is the southernmost row."""

    def __init__(self, width, height):
        self.width = width
        self.height = height
        self.rows = [(1 << width) - 1 for _ in range(height)]

    def carve(self, rect):
        """Frees the cells x0 <= x < x1, y0 <= y < y1."""
        x0, y0, x1, y1 = rect
        mask = ((1 << (x1 - x0)) - 1) << x0
        for y in range(y0, y1):
            self.rows[y] &= ~mask

    def fill(self, rect):
        """Occupies the cells x0 <= x < x1, y0 <= y < y1."""
        x0, y0, x1, y1 = rect
        mask = ((1 << (x1 - x0)) - 1) << x0
        for y in range(y0, y1):
            self.rows[y] |= mask

    def disc_free(self, x, y, radius):
        """True if no occupied cell square comes nearer than radius (all in metres)."""
        x /= CELL
        y /= CELL
        radius = radius / CELL - 1e-9
        for row in range(math.floor(y - radius), math.floor(y + radius) + 1):
            dy = max(row - y, 0.0, y - (row + 1))
            if dy >= radius:
                continue
            half = math.sqrt(radius * radius - dy * dy)
            low = math.ceil(x - half) - 1
            high = math.floor(x + half)
            if row < 0 or row >= self.height or low < 0 or high >= self.width:
                return False
            if (self.rows[row] >> low) & ((1 << (high - low + 1)) - 1):
                return False
        return True

    def line_free(self, a, b, radius):
        """True if a disc of the radius can be drawn along the straight line from a to b."""
        steps = max(1, math.ceil(math.dist(a, b) / CELL))
        return all(
            self.disc_free(a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps, radius)
            for i in range(steps + 1)
        )

    def write_png(self, path):
        """8-bit grey, white free, black occupied; the northernmost row first."""
        raw = bytearray()
        for row in reversed(self.rows):
            raw.append(0)
            raw += bytes(0 if (row >> x) & 1 else 255 for x in range(self.width))
        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 0, 0, 0, 0)
        chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(bytes(raw), 9)), (b"IEND", b""))
        with open(path, "wb") as out:
            out.write(b"\x89PNG\r\n\x1a\n")
            for kind, data in chunks:
                crc = zlib.crc32(kind + data)
                out.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", crc))
