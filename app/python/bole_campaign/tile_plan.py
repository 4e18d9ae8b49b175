"""What is to be done for one cloud in tiles: phases, each of which needs the results of the one before.

    cut      the cloud is cut into files of tiles that overlap
    ground   in each tile: terrain of its core, and what its stems say about the errors that all share
    pool     the priors of all stems
    stems    in each tile: stems, over the terrain of all tiles and with the priors of all
    label    in each tile: points of its core with the tree ids of the whole
"""

import collections
import csv
import pathlib

from . import folders, keys, planning, tile_edits, tile_states, tile_terrain
from .errors import bad_input
from .memory import GIB, declared_gib
from .tiled_document import NUMBERS, PRIORS, RESULTS, TERRAIN

PHASES = ("cut", "ground", "pool", "stems", "label")
OF_TILES = ("ground", "stems", "label")
# Peak of a tile, generous: measured in docs/dev/campaigns.md. By its points, buffers included; columns lie in memory up
# to a size, beyond it on file.
CUT_GIB, BASE_GIB = 1.2, 0.5
COLUMNS_PER_POINT, MOST_OF_COLUMNS_GIB, OTHERS_PER_POINT = 130.0, 1.5, 60.0
TERRAIN_MARGIN = 4  # cells read beyond the buffer: slopes and borders need neighbours
INFO = ("title", "tables", "retries", "cache", "accept_partial", "time_limit_s", "threads", "memory_gib", "files", "tile_m", "buffer_m", "shift_m", "cloud_files", "breast_height", "settings", "setting_files", "edits", "id_of")


def box_text(box, margin=0.0):
    return ",".join(repr(v) for v in (box[0] - margin, box[1] - margin, box[2] + margin, box[3] + margin))


class TilePlan(planning.Plan):
    """`info`: what the document says, as plan.json keeps it. The tiles are known once the cloud is cut."""

    def __init__(self, out, info):
        super().__init__(out, info["title"], info["tables"], info["retries"], [])
        self.info = info
        self.tasks = [self._cut()]
        self._read = (None, [])  # tiles.csv, by its stamp
        if self.edits():
            self.results = (*self.results, "point_edits.csv")
        self.numbered = None  # of the last merge: {tile: {tree_id in it: number}}

    rows_are, results = "tiles and steps", ("stems.csv", "campaign.gpkg", "campaign.html", "terrain.vrt", "tiles")

    def named(self, task, count):
        return task["phase"] + (f": {count} tiles" if task["phase"] in OF_TILES else "")

    @staticmethod
    def of_campaign(campaign, out, program, version):
        info = {name: getattr(campaign, name) for name in INFO}
        return TilePlan(out, {**info, "program": program, "version": version, "documents": campaign.documents()})

    def keep(self):
        for phase, document in self.info["documents"].items():
            folder = self.out / "phases"
            folder.mkdir(parents=True, exist_ok=True)
            folders.write_json(folder / f"{phase}.json", document)
        folders.write_json(self.out / "plan.json", {"format": 1, "tiles": self.info})

    # Tasks

    def _task(self, phase, tile, settings, files, gib):
        info = self.info
        name = f"{tile['name']}.{phase}" if tile else phase
        return {
            "program": info["program"], "version": info["version"], "cache": info["cache"], "accept_partial": info["accept_partial"], "time_limit_s": info["time_limit_s"], "threads": info["threads"],
            "document": str(self.out / "phases" / f"{phase}.json"), "content": info["documents"][phase], "phase": phase, "row": tile["name"] if tile else phase,
            "id": name, "folder": str(folders.task_folder(self.out, name)), "set": settings, "files": files,
            "memory_gib": info["memory_gib"] or round(gib, 2), "memory_given": info["memory_gib"] is not None, "x_m": None, "y_m": None,
        }

    def _cut(self):
        info = self.info
        settings = {"cut.files": ",".join(info["files"]), "cut.tile": repr(info["tile_m"]), "cut.buffer": repr(info["buffer_m"])}
        settings.update({f"cut.shift_{axis}": repr(value) for axis, value in zip("xy", info["shift_m"]) if value})
        if info["breast_height"] is not None:
            settings["cut.breast_height"] = info["breast_height"]
        return self._task("cut", None, settings, {"cut.files": info["files"]}, CUT_GIB)

    def _scan(self, tile):
        """The settings and files that a tile is read and measured with."""
        scan = f"{self.info['id_of']['io.read_cloud']}.file"
        file = str(self.done("cut") / "tiles" / tile["file"])
        core = {f"{RESULTS}.core": box_text(tile["core"])}
        edits, edit_files = tile_edits.settings_of(self, tile)
        return {**self.info["settings"], scan: file, **core, **edits}, {**self.info["setting_files"], scan: [file], **edit_files}

    def _gib(self, tile):
        given = sum(declared_gib({"memory_gib": None, "files": {name: paths}}, self.info["program"]) - BASE_GIB for name, paths in self.info["setting_files"].items())
        points_per_gib = tile["points"] / GIB
        return BASE_GIB + given + min(COLUMNS_PER_POINT * points_per_gib, MOST_OF_COLUMNS_GIB) + OTHERS_PER_POINT * points_per_gib

    def ground_task(self, tile):
        settings, files = self._scan(tile)
        return self._task("ground", tile, settings, files, self._gib(tile))

    def pool_task(self):
        evidence = str(self.joined("evidence.csv"))
        sd = self.info["settings"].get(f"{self.info['id_of']['stems.measure']}.range_offset_sd")
        settings = {"evidence.file": evidence, **({"pool.range_offset_sd": sd} if sd else {})}
        return self._task("pool", None, settings, {"evidence.file": [evidence]}, BASE_GIB)

    def stems_task(self, tile, with_terrain):
        """`with_terrain`: the tiles whose terrain is there. Only those beside this one decide whether it is current."""
        settings, files = self._scan(tile)
        margin = self.info["buffer_m"] + TERRAIN_MARGIN * tile_terrain.cell_of(self.done(f"{tile['name']}.ground"))
        settings[f"{TERRAIN}.file"] = str(self.out / "terrain.vrt")
        settings[f"{TERRAIN}.bounds"] = box_text(tile["core"], margin)
        reach = 1 + int(margin // self.info["tile_m"])
        beside = [t for t in with_terrain if abs(t["column"] - tile["column"]) <= reach and abs(t["row"] - tile["row"]) <= reach]
        files[f"{TERRAIN}.file"] = [str(self.done(f"{t['name']}.ground") / "dem.tif") for t in beside]
        priors = str(self.done("pool") / "priors.csv")
        settings[f"{PRIORS}.file"], files[f"{PRIORS}.file"] = priors, [priors]
        return self._task("stems", tile, settings, files, self._gib(tile))

    def label_task(self, tile):
        cloud, numbers = str(self.done(f"{tile['name']}.stems") / "cloud.laz"), str(self.joined(f"numbers_{tile['name']}.csv"))
        settings = {"points.file": cloud, f"{NUMBERS}.file": numbers, "points.unit": "metre", "points.up": "z"}
        return self._task("label", tile, settings, {"points.file": [cloud], f"{NUMBERS}.file": [numbers]}, self._gib(tile))

    # Folders

    def done(self, task_id):
        return pathlib.Path(folders.task_folder(self.out, task_id)) / "done"

    def joined(self, name):
        return self.out / "joined" / name

    def tiles(self):
        """[{name, file, column, row, core, points, core_points}]; none before the cloud is cut."""
        table = self.done("cut") / "tiles.csv"
        try:
            stamp = keys.stamp_of(table)
        except FileNotFoundError:
            return []
        if self._read[0] != stamp:
            self._read = (stamp, self._tiles_in(table))
        return self._read[1]

    def edits(self):
        """Of points, in the order of the document."""
        return self.info.get("edits", [])

    def tile(self, name):
        return next((t for t in self.tiles() if t["name"] == name), None)

    @staticmethod
    def _tiles_in(table):
        with open(table, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        return [{**row, **{k: int(row[k]) for k in ("column", "row", "points", "core_points")}, "core": [float(row[k]) for k in ("xmin_m", "ymin_m", "xmax_m", "ymax_m")]} for row in rows]

    # Phases

    def is_current(self, task):
        record, reason = planning.recorded(task)
        return record is not None and not reason and record["state"] == "done"

    def phases(self, looks=False):
        """The tasks of each phase, one after the other. The next ones are known once those before have run. `looks`:
        writes nothing."""
        yield self.tasks
        if not self.is_current(self.tasks[0]):
            return
        tiles = self.tiles()
        if not looks:
            tile_edits.write_files(self, tiles)
        grounds = self._know({t["name"]: self.ground_task(t) for t in tiles})
        yield list(grounds.values())
        grounded = [t for t in tiles if self.is_current(grounds[t["name"]])]
        with_terrain = [t for t in grounded if (self.done(f"{t['name']}.ground") / "dem.tif").exists()]
        if not with_terrain:
            return
        if not looks:
            tile_terrain.join_terrain(self, with_terrain)
            tile_terrain.join_evidence(self, grounded)
        pool = self._know({"pool": self.pool_task()})["pool"]
        yield [pool]
        if not self.is_current(pool):
            return
        stems = self._know({t["name"]: self.stems_task(t, with_terrain) for t in with_terrain})
        yield list(stems.values())
        if not self.info["cloud_files"]:
            return
        if not looks:
            from . import tile_merging  # which needs this module

            tile_merging.number_trees(self)
        labels = {t["name"]: self.label_task(t) for t in with_terrain if self.is_current(stems[t["name"]])}
        yield list(self._know(labels).values())

    def _know(self, tasks):
        known = {task["id"]: task for task in self.tasks}
        known.update({task["id"]: task for task in tasks.values()})
        self.tasks = list(known.values())
        return tasks

    def look_through(self):
        """Makes all tasks known that can be, and runs none."""
        for _ in self.phases(looks=True):
            pass
        return self

    def phase_tasks(self, phase):
        return {task["row"]: task for task in self.tasks if task["phase"] == phase}

    # A job array

    def task_of_array(self, number):
        """Of the tile with this number the first task that is to run; the array is given again for each phase."""
        for tasks in self.phases():
            if tasks and tasks[0]["row"] in ("cut", "pool"):
                if not self.is_current(tasks[0]):
                    return tasks[0], ""
                continue
            tiles = [t["name"] for t in self.tiles()]
            if number > len(tiles):
                raise bad_input(f"there is no task {number}", f"a number up to {len(tiles)}, that of the tiles", "bole campaign plan lists them")
            own = next((task for task in tasks if task["row"] == tiles[(number - 1) % len(tiles)]), None)
            if own is not None and not self.is_current(own):
                return own, ""
            if not all(self.was_run(task) for task in tasks):
                return None, "other tiles of this phase are not done yet: give the array again when they are"
        return None, "this tile is done"

    @staticmethod
    def was_run(task):
        return any((pathlib.Path(task["folder"]) / place).exists() for place in ("done", "failed"))

    def is_through(self):
        self.look_through()
        return all(row["state"] not in ("missing", "changed", "running") for row in self.rows())

    # Rows

    def row_id(self, task):
        return task["row"]

    def row_of(self, task, running=None):
        """Of the tile that the task works on. `running`: whether it runs, where the caller knows."""
        return tile_states.row_of(self, task["row"], {task["id"]: running} if running is not None else {})

    def rows(self):
        counted = collections.Counter(tile_terrain.tiles_of_stems(self.out / "stems.csv"))
        rows = [tile_states.row_of(self, name) for name in dict.fromkeys(task["row"] for task in self.tasks)]
        measured = {name for name, task in self.phase_tasks("stems").items() if self.is_current(task)}
        return [{**row, "stems": counted[row["input_id"]]} if row["input_id"] in measured else row for row in rows]

    def merge(self, ledger=None):
        from . import tile_merging

        return tile_merging.merge(self, ledger)
