"""The campaign document: which inputs, which pipeline, which options.

    {"pipeline": "forest_plot", "inputs": [{"id": "p1", "set": {"scan.file": "p1/walk.pcap"}}, ...], "set": {...}}

`inputs` is a list, or one of {"table": "plots.csv"}, {"folder": "scans"}, {"pattern": "scans/*.laz"}, or the path of a
table, a folder or a pattern alone. Relative paths are taken from the folder of the document, else from the working
directory.
"""

import csv
import glob
import json
import math
import os
import pathlib

from .errors import bad_input, did_you_mean
from .program import Pipeline, find_pipeline

# Every key with what it holds; README of the keys is docs/user/campaigns.md.
CAMPAIGN_KEYS = ("pipeline", "inputs", "set", "tables", "memory_gib", "time_limit_s", "threads", "retries", "cache", "accept_partial", "title")
# One of these makes it a document of one cloud in tiles (tiled_document.py).
TILE_KEYS = ("cloud", "tile_m", "buffer_m", "shift_m")
INPUT_KEYS = ("id", "set", "memory_gib", "x_m", "y_m")
SOURCE_KEYS = ("table", "folder", "pattern", "option")
PLACES = ("x_m", "y_m")


def check_keys(given, allowed, place):
    for key in given:
        if key not in allowed:
            raise bad_input(f"{place} has the key '{key}'", "one of " + ", ".join(allowed), did_you_mean(key, allowed))


def text_of(value, place):
    """A value of an option as the command line takes it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return value
    if isinstance(value, (list, dict)):
        return json.dumps(value)
    raise bad_input(f"{place} is {value!r}", "a number, a text, true or false")


def number_of(value, place, at_least=None):
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if isinstance(value, bool) or not math.isfinite(number) or (at_least is not None and number < at_least):
        raise bad_input(f"{place} is {value!r}", "a number" + (f" >= {at_least:g}" if at_least is not None else ""))
    return number


def whole_number_of(value, place, at_least):
    number = number_of(value, place, at_least)
    if number != int(number):
        raise bad_input(f"{place} is {value!r}", "a whole number")
    return int(number)


def truth_of(value, place):
    if not isinstance(value, bool):
        raise bad_input(f"{place} is {value!r}", "true or false")
    return value


def raw_document(path):
    """The JSON object of a file, checked no further."""

    def pairs_once(pairs):
        found = {}
        for key, value in pairs:
            if key in found:
                raise bad_input(f"'{path}' gives '{key}' twice in one object", "each key once")
            found[key] = value
        return found

    try:
        text = pathlib.Path(path).read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise bad_input(f"'{path}' cannot be read ({getattr(error, 'strerror', None) or error})", "a campaign document (JSON)") from None
    try:
        raw = json.loads(text, object_pairs_hook=pairs_once)
    except json.JSONDecodeError as error:
        raise bad_input(f"'{path}' line {error.lineno}: {error.msg}", "a campaign document (JSON)") from None
    if not isinstance(raw, dict):
        raise bad_input(f"'{path}' holds no JSON object", '{"pipeline": ..., "inputs": [...]}')
    return raw


class Campaign:
    """A checked document: `inputs` is a list of {id, set, files, memory_gib or None, x_m, y_m or None}."""

    def __init__(self, path, program, raw=None):
        self.path = pathlib.Path(path)
        self.base = self.path.resolve().parent
        self._read(raw_document(path) if raw is None else raw, program)

    def _read(self, raw, program):
        place = f"'{self.path}'"
        check_keys(raw, CAMPAIGN_KEYS, place)
        for key in ("pipeline", "inputs"):
            if key not in raw:
                raise bad_input(f"{place} has no '{key}'", '{"pipeline": "forest_plot", "inputs": [...]}')
        if not isinstance(raw["pipeline"], str):
            raise bad_input(f"{place}: pipeline is {raw['pipeline']!r}", "the name or the path of a pipeline document")
        self.pipeline = Pipeline(find_pipeline(raw["pipeline"], self.base), program)
        self._read_engine_keys(raw, place)
        self.tables = raw.get("tables", ["stems.csv"])
        if not isinstance(self.tables, list) or not all(isinstance(t, str) and t.endswith(".csv") and "/" not in t for t in self.tables):
            raise bad_input(f"{place}: tables is {self.tables!r}", 'names of tables that the pipeline writes: ["stems.csv"]')
        common = self._settings(raw.get("set", {}), f"{place}: set")
        self.inputs = [self._input(entry, common, f"{place}: {where}") for entry, where in self._entries(raw["inputs"], place)]
        self._check_ids(place)

    def _read_engine_keys(self, raw, place):
        """What says how an attempt runs, whatever it works on."""
        self.title = text_of(raw.get("title", self.path.stem), f"{place}: title")
        self.memory_gib = number_of(raw["memory_gib"], f"{place}: memory_gib", 0.1) if "memory_gib" in raw else None
        self.time_limit_s = number_of(raw["time_limit_s"], f"{place}: time_limit_s", 1) if "time_limit_s" in raw else None
        self.threads = whole_number_of(raw["threads"], f"{place}: threads", 1) if "threads" in raw else None
        self.retries = whole_number_of(raw.get("retries", 2), f"{place}: retries", 0)
        self.cache, self.accept_partial = (truth_of(raw.get(key, False), f"{place}: {key}") for key in ("cache", "accept_partial"))

    def _settings(self, given, place):
        if not isinstance(given, dict):
            raise bad_input(f"{place} is {given!r}", '{"STAGE.OPTION": value}')
        for name in given:
            self.pipeline.check_name(name, place)
        return {name: text_of(value, f"{place}: {name}") for name, value in given.items()}

    def resolved(self, value):
        """An absolute path: from the folder of the document where it is there, else from the working directory."""
        value = os.path.expanduser(value)
        here, there = self.base / value, pathlib.Path.cwd() / value
        return str(there if not here.exists() and there.exists() else here)

    def _input(self, entry, common, place):
        if not isinstance(entry, dict):
            raise bad_input(f"{place} is {entry!r}", '{"id": "p1", "set": {"scan.file": "..."}}')
        check_keys(entry, INPUT_KEYS, place)
        if not isinstance(entry.get("id"), (str, int)) or isinstance(entry.get("id"), bool) or str(entry["id"]).strip() == "":
            raise bad_input(f"{place} has no id", "a text that no other input has")
        settings = {**common, **self._settings(entry.get("set", {}), place)}
        files = {}
        for name, value in settings.items():
            if self.pipeline.is_path(name, value):
                paths = [os.path.normpath(self.resolved(path)) for path in self.pipeline.paths_in(name, value)]
                if self.pipeline.options[name]["type"] == "path" or os.path.exists(paths[0]):
                    files[name] = paths
                    settings[name] = ",".join(paths)
        documents = {n: p for n, p in self.pipeline.files_in_document().items() if n not in settings}
        memory = entry.get("memory_gib", self.memory_gib)
        return {
            "id": str(entry["id"]),
            "set": settings,
            "files": {**documents, **files},
            "memory_gib": None if memory is None else number_of(memory, f"{place}: memory_gib", 0.1),
            **{axis: number_of(entry[axis], f"{place}: {axis}") if axis in entry else None for axis in PLACES},
        }

    def _entries(self, inputs, place):
        """(entry, where it is written) of every input."""
        if isinstance(inputs, list):
            return [(entry, f"input {i}" + (f" ('{entry['id']}')" if isinstance(entry, dict) and "id" in entry else "")) for i, entry in enumerate(inputs, 1)]
        if isinstance(inputs, str):
            kind = "folder" if os.path.isdir(self.resolved(inputs)) else "table" if inputs.endswith(".csv") and "*" not in inputs else "pattern"
            inputs = {kind: inputs}
        if not isinstance(inputs, dict):
            raise bad_input(f"{place}: inputs is {inputs!r}", "a list, or the path of a table, a folder or a pattern")
        check_keys(inputs, SOURCE_KEYS, f"{place}: inputs")
        kinds = [kind for kind in ("table", "folder", "pattern") if kind in inputs]
        if len(kinds) != 1 or not isinstance(inputs[kinds[0]], str):
            raise bad_input(f"{place}: inputs has {', '.join(kinds) or 'no source'}", "one of table, folder and pattern, a text")
        if kinds == ["table"]:
            return self._entries_of_table(self.resolved(inputs["table"]))
        option = inputs.get("option") or self.pipeline.reader()
        self.pipeline.check_name(option, f"{place}: inputs: option")
        path = self.resolved(inputs[kinds[0]])
        files = self._files_in(path) if kinds == ["folder"] else self._files_like(inputs["pattern"])
        if not files:
            raise bad_input(f"{place}: {kinds[0]} '{inputs[kinds[0]]}' gives no input", "files or folders that Bole reads", f"Looked at {path}")
        return [({"id": self._name_of(file, files), "set": {option: str(file)}}, f"'{file}'") for file in files]

    @staticmethod
    def _files_in(path):
        if not os.path.isdir(path):
            raise bad_input(f"there is no folder '{path}'", "a folder of inputs")
        return sorted(p for p in pathlib.Path(path).iterdir() if not p.name.startswith(".") and p.suffix.lower() not in (".json", ".csv", ".txt", ".md"))

    def _files_like(self, pattern):
        pattern = os.path.expanduser(pattern)
        found = glob.glob(str(self.base / pattern), recursive=True) or glob.glob(str(pathlib.Path.cwd() / pattern), recursive=True)
        return sorted(map(pathlib.Path, found))

    @staticmethod
    def _name_of(file, files):
        """The name without ending; with the folder, or in full, where that is needed to tell them apart."""
        names = (lambda f: f.stem, lambda f: f"{f.parent.name}/{f.stem}", lambda f: f"{f.parent.name}/{f.name}", str)
        return next((name(file) for name in names if len({name(f) for f in files}) == len(files)), str(file))

    def _entries_of_table(self, path):
        try:
            with open(path, encoding="utf-8-sig", newline="") as file:
                sample = file.readline()
                file.seek(0)
                rows = list(csv.reader(file, delimiter=max(",;\t", key=sample.count)))
        except (OSError, UnicodeDecodeError, csv.Error) as error:
            raise bad_input(f"the table '{path}' cannot be read ({getattr(error, 'strerror', None) or error})", "a CSV table with a heading: id, STAGE.OPTION, ...") from None
        heading = [name.strip() for name in rows[0]] if rows else []
        if "id" not in heading or len(set(heading)) != len(heading):
            raise bad_input(f"the heading of '{path}' is {', '.join(heading) or 'missing'}", "a column 'id' and one for each STAGE.OPTION, each once")
        own = [name for name in INPUT_KEYS if name != "set"]
        for name in heading:
            if name not in own and "." not in name:
                raise bad_input(f"'{path}' has the column '{name}'", f"one of {', '.join(own)}, or STAGE.OPTION", did_you_mean(name, [*own, *self.pipeline.options]))
        entries = []
        for line, row in enumerate(rows[1:], 2):
            if not any(cell.strip() for cell in row):
                continue
            if len(row) != len(heading):
                raise bad_input(f"'{path}' line {line} has {len(row)} cells", f"{len(heading)}, as the heading has")
            cells = {name: cell.strip() for name, cell in zip(heading, row) if cell.strip() != ""}
            entry = {name: cell for name, cell in cells.items() if name in own}
            entry["set"] = {name: cell for name, cell in cells.items() if name not in own}
            entries.append((entry, f"'{path}' line {line}"))
        return entries

    def _check_ids(self, place):
        if not self.inputs:
            raise bad_input(f"{place} has no inputs", "at least one")
        seen = set()
        for entry in self.inputs:
            if entry["id"] in seen:
                raise bad_input(f"{place}: two inputs have the id '{entry['id']}'", "an id of its own for each")
            seen.add(entry["id"])
