"""LAS 1.4 files as arrays of records, with the extra bytes that Bole writes. Needs numpy."""

import struct

import numpy as np

TYPES = {1: "u1", 2: "i1", 3: "<u2", 4: "<i2", 5: "<u4", 6: "<i4", 7: "<u8", 8: "<i8", 9: "<f4", 10: "<f8"}
BASE_LENGTH = {6: 30, 7: 36}  # of point formats


class Las:
    def __init__(self, path):
        data = path.read_bytes()
        self.start = struct.unpack_from("<I", data, 96)[0]
        self.header = bytearray(data[: self.start])
        count, length = struct.unpack_from("<Q", data, 247)[0], struct.unpack_from("<H", data, 105)[0]
        self.scale, self.offset = struct.unpack_from("<3d", data, 131), struct.unpack_from("<3d", data, 155)
        fields, at = [("X", "<i4"), ("Y", "<i4"), ("Z", "<i4"), ("other", f"V{BASE_LENGTH[data[104]] - 12}")], BASE_LENGTH[data[104]]
        for name, kind in self._extra_fields(data):
            fields.append((name, kind))
            at += np.dtype(kind).itemsize
        assert at == length, (at, length)
        self.points = np.frombuffer(data, dtype=fields, count=count, offset=self.start).copy()

    @staticmethod
    def _extra_fields(data):
        at = struct.unpack_from("<H", data, 94)[0]
        for _ in range(struct.unpack_from("<I", data, 100)[0]):
            record, length = struct.unpack_from("<HH", data, at + 18)
            if record == 4:
                for k in range(at + 54, at + 54 + length, 192):
                    yield data[k + 4 : k + 36].split(b"\0")[0].decode(), TYPES[data[k + 2]]
            at += 54 + length

    def axis(self, k):
        return self.points["XYZ"[k]] * self.scale[k] + self.offset[k]

    def shift(self, k, by, where=slice(None)):
        """Moves points along an axis; `by` may be an array."""
        self.points["XYZ"[k]][where] += np.round(np.asarray(by) / self.scale[k]).astype("<i4")

    def write(self, path):
        header = self.header
        struct.pack_into("<I", header, 107, 0)
        struct.pack_into("<Q", header, 247, len(self.points))
        struct.pack_into("<15Q", header, 255, len(self.points), *[0] * 14)
        for k in range(3):
            values = self.axis(k)
            struct.pack_into("<2d", header, 179 + 16 * k, values.max(), values.min())
        path.write_bytes(bytes(header) + self.points.tobytes())
