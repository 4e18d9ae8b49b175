"""The ledger campaign.gpkg: the layers `inputs` and `stems` in one SQLite file, written by one client at a time.

Rows of stems are taken over from the plot.gpkg of each input as they are, geometries too. The GeoPackage tables are
those of OGC 12-128r18, clause 1.1.
"""

import contextlib
import csv
import os
import pathlib
import sqlite3
import struct

CARTESIAN, GEOGRAPHIC = -1, 0
TABLES = """
CREATE TABLE IF NOT EXISTS gpkg_spatial_ref_sys (srs_name TEXT NOT NULL, srs_id INTEGER NOT NULL PRIMARY KEY, organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT);
CREATE TABLE IF NOT EXISTS gpkg_contents (table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE, description TEXT DEFAULT '',
  last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')), min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER,
  CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id));
CREATE TABLE IF NOT EXISTS gpkg_geometry_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL, CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name),
  CONSTRAINT uk_gc_table_name UNIQUE (table_name));
INSERT OR IGNORE INTO gpkg_spatial_ref_sys VALUES
  ('Undefined Cartesian SRS', -1, 'NONE', -1, 'undefined', 'undefined Cartesian coordinate reference system'),
  ('Undefined geographic SRS', 0, 'NONE', 0, 'undefined', 'undefined geographic coordinate reference system'),
  ('WGS 84 geodetic', 4326, 'EPSG', 4326,
   'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AXIS["Latitude",NORTH],AXIS["Longitude",EAST],AUTHORITY["EPSG","4326"]]',
   'longitude/latitude on the WGS 84 spheroid');
"""
APPLICATION_ID, USER_VERSION = 0x47504B47, 10300  # "GPKG", 1.3
TYPES = {"stems": "INTEGER", "attempts": "INTEGER", "killed": "INTEGER", "findings": "INTEGER", "warnings": "INTEGER", "points": "INTEGER", "tile_m": "REAL", "seconds": "REAL", "peak_mib": "REAL",
         "memory_gib": "REAL", "x_m": "REAL", "y_m": "REAL"}


def quoted(name):
    return '"' + name.replace('"', '""') + '"'


def point(x, y, srs_id):
    """A geometry of GeoPackage: its header without envelope, then well-known binary."""
    return struct.pack("<2sBBiBIdd", b"GP", 0, 1, srs_id, 1, 1, x, y)


def coordinates_of(geometry):
    """(x, y) of a point; None of anything else, or of an empty one."""
    if not geometry or len(geometry) < 8 or geometry[:2] != b"GP" or geometry[3] & 0x10:
        return None
    at = 8 + (0, 32, 48, 48, 64)[(geometry[3] >> 1) & 7 if (geometry[3] >> 1) & 7 < 5 else 0]
    order = "<" if geometry[at] == 1 else ">"
    kind, x, y = struct.unpack_from(order + "Idd", geometry, at + 1)
    return (x, y) if kind % 1000 == 1 else None


def with_srs_id(geometry, srs_id):
    return geometry[:4] + struct.pack("<i" if geometry[3] & 1 else ">i", srs_id) + geometry[8:] if geometry else None


class Layer:
    """Rows of one input: columns with types, values, geometries; `srs`: the row of gpkg_spatial_ref_sys, None: undefined."""

    def __init__(self, columns, rows, geometries, srs):
        self.columns, self.rows, self.geometries, self.srs = columns, rows, geometries, srs

    @property
    def srs_key(self):
        return None if self.srs is None else (self.srs[2].upper(), self.srs[3]) if self.srs[2].upper() != "NONE" else self.srs[4]


def stems_of(folder):
    """The stems that a run left: of its GeoPackage, else of its table; None where there are none."""
    package = pathlib.Path(folder) / "plot.gpkg"
    if package.exists():
        with contextlib.closing(sqlite3.connect(f"{package.resolve().as_uri()}?mode=ro", uri=True)) as db:
            found = db.execute("SELECT column_name, srs_id FROM gpkg_geometry_columns WHERE table_name = 'stems'").fetchone()
            if found:
                geometry, srs_id = found
                columns = [(name, kind) for _, name, kind, _, _, key in db.execute("PRAGMA table_info(stems)") if name != geometry and not key]
                names = ", ".join(quoted(name) for name, _ in columns)
                rows = db.execute(f"SELECT {quoted(geometry)}{', ' if names else ''}{names} FROM stems ORDER BY rowid").fetchall()
                srs = db.execute("SELECT * FROM gpkg_spatial_ref_sys WHERE srs_id = ?", (srs_id,)).fetchone() if srs_id > 0 else None
                return Layer(columns, [row[1:] for row in rows], [row[0] for row in rows], srs[:6] if srs else None)
    table = pathlib.Path(folder) / "stems.csv"
    if not table.exists():
        return None
    with open(table, encoding="utf-8-sig", newline="") as file:
        heading, *rows = list(csv.reader(file)) or [[]]
    numbers = [all(_is_number(row[i]) for row in rows if row[i] != "") and any(row[i] != "" for row in rows) for i in range(len(heading))]
    values = [[None if cell == "" else float(cell) if numbers[i] else cell for i, cell in enumerate(row)] for row in rows]
    places = [dict(zip(heading, row)) for row in values]
    geometries = [point(p["x_m"], p["y_m"], CARTESIAN) if isinstance(p.get("x_m"), float) and isinstance(p.get("y_m"), float) else None for p in places]
    return Layer([(name, "REAL" if numbers[i] else "TEXT") for i, name in enumerate(heading)], values, geometries, None)


def _is_number(text):
    try:
        float(text)
        return True
    except ValueError:
        return False


class Ledger:
    """One writer, under the lock of the folder. Readers see the state before a change, or after it."""

    def __init__(self, path):
        self.path = path
        try:
            self._open()
        except sqlite3.DatabaseError:
            # All that it holds is in the folders of the inputs too.
            if self.db:
                self.db.close()
            os.replace(path, f"{path}.damaged")
            for ending in ("-wal", "-shm", "-journal"):
                with contextlib.suppress(FileNotFoundError):
                    os.remove(f"{path}{ending}")
            self._open()

    def _open(self):
        self.db = None
        self.db = sqlite3.connect(self.path, timeout=30, isolation_level=None)
        self.db.execute(f"PRAGMA application_id = {APPLICATION_ID}")
        self.db.execute(f"PRAGMA user_version = {USER_VERSION}")
        self.db.execute("PRAGMA journal_mode = WAL")
        # No wait for the disk at every state of an input: a power cut may cost the last of them, and the folders have them all.
        self.db.execute("PRAGMA synchronous = NORMAL")
        self.db.executescript(TABLES)

    def close(self):
        """One file again, without a log beside it, unless somebody reads it now."""
        with contextlib.suppress(sqlite3.OperationalError):
            self.db.execute("PRAGMA journal_mode = DELETE")
        self.db.close()

    @contextlib.contextmanager
    def _change(self):
        self.db.execute("BEGIN IMMEDIATE")
        try:
            yield
            self.db.execute("COMMIT")
        except BaseException:
            self.db.execute("ROLLBACK")
            raise

    def _srs_id(self, srs):
        if srs is None:
            return CARTESIAN
        same = self.db.execute("SELECT srs_id FROM gpkg_spatial_ref_sys WHERE organization = ? COLLATE NOCASE AND organization_coordsys_id = ? AND definition = ?", srs[2:5]).fetchone()
        if same:
            return same[0]
        taken = self.db.execute("SELECT 1 FROM gpkg_spatial_ref_sys WHERE srs_id = ?", (srs[1],)).fetchone()
        srs_id = srs[1] if not taken else self.db.execute("SELECT max(srs_id, 99999) + 1 FROM (SELECT max(srs_id) AS srs_id FROM gpkg_spatial_ref_sys)").fetchone()[0]
        self.db.execute("INSERT INTO gpkg_spatial_ref_sys VALUES (?, ?, ?, ?, ?, ?)", (srs[0], srs_id, *srs[2:6]))
        return srs_id

    def _write_layer(self, name, columns, rows, srs_id):
        """`rows`: geometry first."""
        declared = "".join(f", {quoted(column)} {kind}" for column, kind in columns)
        self.db.execute(f"DROP TABLE IF EXISTS {quoted(name)}")
        self.db.execute(f"CREATE TABLE {quoted(name)} (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom POINT{declared})")
        marks = ", ".join("?" * (1 + len(columns)))
        self.db.executemany(f"INSERT INTO {quoted(name)} (geom{''.join(', ' + quoted(c) for c, _ in columns)}) VALUES ({marks})", rows)
        places = [p for row in rows if (p := coordinates_of(row[0]))]
        box = [f(p[axis] for p in places) for f in (min, max) for axis in (0, 1)] if places else [None] * 4
        self.db.execute("INSERT OR REPLACE INTO gpkg_contents (table_name, data_type, identifier, min_x, min_y, max_x, max_y, srs_id) VALUES (?, 'features', ?, ?, ?, ?, ?, ?)",
                        (name, name, *box, srs_id))
        self.db.execute("INSERT OR REPLACE INTO gpkg_geometry_columns VALUES (?, 'geom', 'POINT', ?, 2, 0)", (name, srs_id))

    def write_inputs(self, rows, srs=None):
        with self._change():
            srs_id = self._srs_id(srs)
            columns = [(name, TYPES.get(name, "TEXT")) for name in rows[0]]
            placed = [(point(r["x_m"], r["y_m"], srs_id) if r["x_m"] is not None and r["y_m"] is not None else None, *r.values()) for r in rows]
            self._write_layer("inputs", columns, placed, srs_id)

    def update_input(self, row):
        names = [name for name in row if name not in ("input_id", "x_m", "y_m")]
        with self._change():
            self.db.execute(f"UPDATE inputs SET {', '.join(quoted(n) + ' = ?' for n in names)} WHERE input_id = ?", [*(row[n] for n in names), row["input_id"]])

    def write_stems(self, layers):
        """`layers`: [(input id, Layer)]. Stems of inputs in other coordinates than most have no geometry; their ids come back."""
        keys = [layer.srs_key for _, layer in layers]
        main = max(set(keys), key=lambda key: (keys.count(key), key is not None, str(key)), default=None)
        columns = {"input_id": "TEXT"}
        for _, layer in layers:
            for name, kind in layer.columns:
                # A column that one input fills with numbers and another with words is text.
                columns[name] = kind if columns.get(name, kind) == kind else "REAL" if {columns[name], kind} <= {"INTEGER", "REAL"} else "TEXT"
        with self._change():
            srs_id = self._srs_id(next((layer.srs for _, layer in layers if layer.srs_key == main), None))
            rows = []
            for input_id, layer in layers:
                names = [name for name, _ in layer.columns]
                for values, geometry in zip(layer.rows, layer.geometries):
                    given = {**dict(zip(names, values)), "input_id": input_id}
                    rows.append((with_srs_id(geometry, srs_id) if layer.srs_key == main else None, *(given.get(name) for name in columns)))
            self._write_layer("stems", list(columns.items()), rows, srs_id)
        return [input_id for (input_id, _), key in zip(layers, keys) if key != main]
