"""Reads what a run leaves in its folder as tables, with the standard library alone.

reader_of(path)(path) -> {layer: {column: values}}; values are a list of text, an array of numbers or a PointField, one entry per row,
and values_of() makes the list or array of each. A file without layers has the one layer "". Tables keep the text of the file, so that
two of them can be compared digit for digit.
"""

import array
import csv
import hashlib
import json
import math
import mmap
import sqlite3
import struct
import sys
import zlib

assert sys.byteorder == "little", "LAS, TIFF and GeoPackage are read on little-endian machines only"

TUM_COLUMNS = ("time_s", "x_m", "y_m", "z_m", "qx", "qy", "qz", "qw")


def columns_of(header, rows):
    columns = {}
    for i, name in enumerate(header):
        unique = name
        while unique in columns:
            unique += "'"
        columns[unique] = [row[i] if i < len(row) else "" for row in rows]
    return columns


def read_csv(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return {"": columns_of(rows[0], rows[1:]) if rows else {}}


def read_tum(path):
    lines = [line.split() for line in path.read_text().splitlines() if line.strip() and not line.startswith("#")]
    return {"": columns_of(TUM_COLUMNS, lines)}


# summary.json: what changes from run to run, and text that may be reworded, is left out.
VARYING = {"seconds", "peak_mib", "finished_at", "bole", "versions", "files", "document", "options", "defaults", "from_cache",
           "stages_seconds"}
STATES = {"state", "status", "exit_code", "unit", "axes"}  # words that are results


def flattened(value, name=""):
    """The numbers of a document by their path. A list of objects with an id is addressed by it, so that order is free."""
    if isinstance(value, dict):
        if value.get("unit") == "ms":
            return  # how long the program took for a frame
        for key, inner in value.items():
            if key not in VARYING and not key.endswith("_per_frame"):  # milliseconds
                yield from flattened(inner, f"{name}.{key}" if name else key)
    elif isinstance(value, list):
        for i, inner in enumerate(value):
            key = inner.get("id", i) if isinstance(inner, dict) else i
            yield from flattened(inner, f"{name}.{key}")
    elif not isinstance(value, str) or name.rpartition(".")[2] in STATES or is_number(value):
        yield name, value if isinstance(value, str) else json.dumps(value)


def is_number(text):
    try:
        float(text)
    except (TypeError, ValueError):
        return False
    return True


def read_summary(path):
    return {"": {name: [text] for name, text in flattened(json.loads(path.read_text(encoding="utf-8")))}}


def read_json(path):
    """Every number and text, by its path."""

    def leaves(value, name):
        if isinstance(value, (dict, list)):
            for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
                yield from leaves(inner, f"{name}.{key}" if name else str(key))
        else:
            yield name, [value if isinstance(value, str) else json.dumps(value)]

    return {"": dict(leaves(json.loads(path.read_text(encoding="utf-8")), ""))}


def vertices(coordinates):
    """The positions of a GeoJSON geometry of any depth, in order."""
    if coordinates and isinstance(coordinates[0], list):
        for inner in coordinates:
            yield from vertices(inner)
    else:
        yield coordinates


def read_geojson(path):
    """One row per feature with its properties, and one per vertex."""
    features = json.loads(path.read_text(encoding="utf-8"))["features"]
    names = list(dict.fromkeys(name for f in features for name in f["properties"]))
    rows = [[json.dumps(f["properties"].get(n)) for n in names] + [f["geometry"]["type"]] for f in features]
    points = [[str(i), *map(repr, v)] for i, f in enumerate(features) for v in vertices(f["geometry"]["coordinates"])]
    return {"features": columns_of([*names, "geometry"], rows), "vertices": columns_of(["feature", "x", "y", "z"], points)}


def read_geopackage(path):
    """The layers; spatial indices and the catalogue (it holds the time of writing) are left out."""
    base = sqlite3.connect(f"file:{path}?mode=ro&immutable=1", uri=True)
    try:
        layers = {}
        for (name,) in base.execute("SELECT table_name FROM gpkg_contents ORDER BY table_name").fetchall():
            answer = base.execute(f'SELECT * FROM "{name}"')
            header = [column[0] for column in answer.description]
            rows = [[v.hex() if isinstance(v, bytes) else "" if v is None else repr(v) if isinstance(v, float) else str(v) for v in row]
                    for row in answer]
            layers[name] = columns_of(header, rows)
        return layers
    finally:
        base.close()


# LAS: fields of the point records by format (ASPRS LAS 1.4 R15, tables 6 to 16): name, type of `array`.
LAS_CORE = [("X", "i"), ("Y", "i"), ("Z", "i"), ("intensity", "H")]
LAS_OLD = LAS_CORE + [("return_bits", "B"), ("classification", "B"), ("scan_angle", "b"), ("user_data", "B"), ("point_source", "H")]
LAS_NEW = LAS_CORE + [("return_bits", "B"), ("flag_bits", "B"), ("classification", "B"), ("user_data", "B"), ("scan_angle", "h"),
                      ("point_source", "H"), ("gps_time", "d")]
GPS_TIME = [("gps_time", "d")]
COLOUR = [("red", "H"), ("green", "H"), ("blue", "H")]
LAS_FIELDS = {0: LAS_OLD, 1: LAS_OLD + GPS_TIME, 2: LAS_OLD + COLOUR, 3: LAS_OLD + GPS_TIME + COLOUR, 6: LAS_NEW, 7: LAS_NEW + COLOUR,
              8: LAS_NEW + COLOUR + [("near_infrared", "H")]}
LAS_EXTRA_TYPES = {1: "B", 2: "b", 3: "H", 4: "h", 5: "I", 6: "i", 7: "Q", 8: "q", 9: "f", 10: "d"}


def las_extra_fields(data, header_size, record_count):
    fields = []
    at = header_size
    for _ in range(record_count):
        user, record, length = struct.unpack_from("<2x16sHH", data, at)
        at += 54
        if user.rstrip(b"\0") == b"LASF_Spec" and record == 4:
            for begin in range(at, at + length, 192):
                kind, name = data[begin + 2], data[begin + 4:begin + 36].split(b"\0")[0].decode("utf-8")
                if kind not in LAS_EXTRA_TYPES:
                    raise ValueError(f"extra bytes '{name}' have type {kind}, which is not read")
                fields.append((name, LAS_EXTRA_TYPES[kind]))
        at += length
    return fields


class PointField:
    """One field of all points; it is decoded when it is asked for, so that no more than a field is in memory."""

    def __init__(self, points, size, offset, kind):
        self.points, self.size, self.offset, self.kind = points, size, offset, kind

    def __len__(self):
        return len(self.points) // self.size

    def values(self):
        column = array.array(self.kind)
        raw = bytearray(len(self) * column.itemsize)
        for k in range(column.itemsize):
            raw[k::column.itemsize] = self.points[self.offset + k::self.size]
        column.frombytes(raw)
        return column


def values_of(column):
    return column.values() if isinstance(column, PointField) else column


def read_las(path):
    """The point records, field by field; the header only as far as it places the points."""
    with open(path, "rb") as file:
        data = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
    if data[:4] != b"LASF":
        raise ValueError(f"{path} is no LAS file")
    header_size, begin, variable_records, point_format, size, count = struct.unpack_from("<HIIBHI", data, 94)
    if data[25] >= 4:
        count = struct.unpack_from("<Q", data, 247)[0] or count
    if point_format not in LAS_FIELDS:
        raise ValueError(f"{path} has point format {point_format}, which is not read")
    fields = LAS_FIELDS[point_format] + las_extra_fields(data, header_size, variable_records)
    points = memoryview(data)[begin:begin + count * size]
    if len(points) != count * size:
        raise ValueError(f"{path} ends before its last point")
    columns = {}
    offset = 0
    for name, kind in fields:
        columns[name] = PointField(points, size, offset, kind)
        offset += array.array(kind).itemsize
    if offset != size:
        raise ValueError(f"{path} has records of {size} bytes, of which {offset} are described")
    placing = struct.unpack_from("<6d", data, 131)
    names = ("scale_x", "scale_y", "scale_z", "offset_x", "offset_y", "offset_z")
    return {"points": columns, "header": {name: [repr(value)] for name, value in zip(names, placing)}}


TIFF_TYPES = {1: "B", 3: "H", 4: "I", 12: "d", 16: "Q"}


def tiff_tags(data):
    if data[:4] != b"II*\0":
        raise ValueError("not a little-endian classic TIFF")
    (at,) = struct.unpack_from("<I", data, 4)
    (count,) = struct.unpack_from("<H", data, at)
    tags = {}
    for i in range(count):
        entry = at + 2 + 12 * i
        tag, kind, n = struct.unpack_from("<HHI", data, entry)
        if kind == 2 or kind not in TIFF_TYPES:
            continue
        layout = f"<{n}{TIFF_TYPES[kind]}"
        where = entry + 8 if struct.calcsize(layout) <= 4 else struct.unpack_from("<I", data, entry + 8)[0]
        tags[tag] = struct.unpack_from(layout, data, where)
    return tags


def undo_float_predictor(block, row_values, value_size):
    """Predictor 3 (Adobe Photoshop TIFF technical note 3): bytes are differenced along the row, most significant byte plane first."""
    row_size = row_values * value_size
    out = bytearray(len(block))
    for begin in range(0, len(block), row_size):
        total = 0
        row = bytearray(row_size)
        for i in range(row_size):
            total = (total + block[begin + i]) & 255
            row[i] = total
        for plane in range(value_size):
            out[begin + value_size - 1 - plane:begin + row_size:value_size] = row[plane * row_values:(plane + 1) * row_values]
    return bytes(out)


def read_geotiff(path):
    """One band of floating-point pixels in strips, row by row, and where they lie."""
    data = path.read_bytes()
    tags = tiff_tags(data)
    width, height = tags[256][0], tags[257][0]
    kind = {32: "f", 64: "d"}.get(tags[258][0])
    compression = tags.get(259, (1,))[0]
    predictor = tags.get(317, (1,))[0]
    plain = tags.get(339, (1,))[0] == 3 and tags.get(277, (1,))[0] == 1
    if kind is None or not plain or 273 not in tags or compression not in (1, 8, 32946) or predictor not in (1, 3):
        raise ValueError(f"{path} is no GeoTIFF as Bole writes it: floating point, one band, strips, DEFLATE or none")
    pixels = array.array(kind)
    for offset, length in zip(tags[273], tags[279]):
        block = data[offset:offset + length]
        if compression != 1:
            block = zlib.decompress(block)
        pixels.frombytes(undo_float_predictor(block, width, pixels.itemsize) if predictor == 3 else block)
    if len(pixels) != width * height:
        raise ValueError(f"{path} has {len(pixels)} pixels for {width} x {height}")
    place = {"width": [str(width)], "height": [str(height)]}
    for tag, name in ((33550, "pixel_scale"), (33922, "tie_point"), (34264, "transformation")):
        for i, value in enumerate(tags.get(tag, ())):
            place[f"{name}_{i}"] = [repr(value)]
    return {"pixels": {"value": pixels}, "place": place}


def read_fingerprint(path):
    return {"": {"sha256": [hashlib.sha256(path.read_bytes()).hexdigest()]}}


def read_laz(path):
    """Bole compresses the same points to the same bytes; only the date of the header may differ."""
    data = bytearray(path.read_bytes())
    data[90:94] = bytes(4)
    return {"": {"sha256": [hashlib.sha256(data).hexdigest()]}}


READERS = {".csv": read_csv, ".tum": read_tum, ".json": read_json, ".geojson": read_geojson, ".gpkg": read_geopackage, ".las": read_las, ".laz": read_laz,
           ".tif": read_geotiff, ".obj": read_fingerprint, ".ply": read_fingerprint, ".vtp": read_fingerprint}


def reader_of(path):
    """The function that reads this file, or None for a file that holds no table."""
    return read_summary if path.name == "summary.json" else READERS.get(path.suffix)


def number(value):
    """A cell as a number; None where it is text or empty."""
    if isinstance(value, str):
        try:
            return float(value)
        except ValueError:
            return None
    return value


def same_number(a, b):
    return a == b or (math.isnan(a) and math.isnan(b))
