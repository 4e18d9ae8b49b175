"""The campaign document of one cloud in tiles, and the pipelines of its parts.

    {"pipeline": "stem_map_from_cloud", "cloud": "forest.laz", "tile_m": 50, "buffer_m": 10}

The pipeline says how terrain and stems are measured: its stages that lead to stems.measure run in every tile, with the
options of the document. What comes after them in the pipeline is not run.
"""

import glob
import os
import pathlib

from . import tile_edits
from .document import Campaign, check_keys, number_of, truth_of
from .errors import bad_input
from .program import Pipeline, find_pipeline

TILED_KEYS = ("pipeline", "cloud", "tile_m", "buffer_m", "shift_m", "cloud_files", "set", "memory_gib", "time_limit_s", "threads", "retries", "cache", "accept_partial", "title")
# What leads from a cloud to its stems. Other stages look at a plot as a whole.
EDITS_OF_POINTS = "survey.edit_points"
IN_TILES = ("io.read_cloud", "io.read_trajectory", "survey.join_trajectory", EDITS_OF_POINTS, "ground.model", "stems.measure")
# Each run looks at its cloud as a whole; a tile must not decide for itself what the cloud is.
SETTLED = {"io.read_cloud": {"unit": "metre", "up": "z"}, "ground.model": {"method": "tin"}}
TERRAIN, PRIORS, NUMBERS, RESULTS = "tile_terrain", "tile_priors", "tile_numbers", "tile_results"


def upstream(stages, stage_id, without):
    """The stages that a stage takes from, itself included, in the order of the document."""
    found, open_ids = set(), [stage_id]
    while open_ids:
        one = open_ids.pop()
        if one in found or one not in stages or stages[one]["type"] in without:
            continue
        found.add(one)
        open_ids += [joint.split(".")[0] for joint in (stages[one].get("inputs") or {}).values()]
    return [one for one in stages if one in found]


class TiledCampaign(Campaign):
    """A checked document: files of the cloud, the grid of tiles, the pipelines that run in a tile."""

    def _read(self, raw, program):
        place = f"'{self.path}'"
        check_keys(raw, TILED_KEYS, place)
        for key in ("pipeline", "cloud"):
            if not isinstance(raw.get(key), str):
                raise bad_input(f"{place} has no '{key}'" if key not in raw else f"{place}: {key} is {raw[key]!r}",
                                '{"pipeline": "stem_map_from_cloud", "cloud": "forest.laz", "tile_m": 50, "buffer_m": 10}')
        self.pipeline = Pipeline(find_pipeline(raw["pipeline"], self.base), program)
        self._read_engine_keys(raw, place)
        self.tables, self.inputs = ["stems.csv"], []
        self.tile_m = number_of(raw.get("tile_m", 50), f"{place}: tile_m", 1)
        self.buffer_m = number_of(raw.get("buffer_m", 10), f"{place}: buffer_m", 0)
        shift = raw.get("shift_m", [0, 0])
        if not isinstance(shift, list) or len(shift) != 2:
            raise bad_input(f"{place}: shift_m is {shift!r}", "two numbers: [east, north]")
        self.shift_m = [number_of(value, f"{place}: shift_m") for value in shift]
        self.cloud_files = truth_of(raw.get("cloud_files", True), f"{place}: cloud_files")
        self.files = self._files_of_cloud(raw["cloud"], place)
        self._take_stages(place)
        self.settings, self.setting_files = self._tile_settings(raw.get("set", {}), f"{place}: set")

    def _files_of_cloud(self, cloud, place):
        found = self._files_like(cloud) if glob.has_magic(cloud) else [pathlib.Path(self.resolved(cloud))]
        files = [os.path.normpath(path) for path in found]
        absent = next((path for path in files if not os.path.isfile(path)), None)
        if not files or absent:
            raise bad_input(f"{place}: cloud '{cloud}' gives no file" if not files else f"there is no file '{absent}'", "LAS, LAZ or COPC files of one cloud")
        if any("," in path for path in files):
            raise bad_input(f"{place}: a file of the cloud has a comma in its name", "names without commas", "Rename it")
        return files

    def _take_stages(self, place):
        stages = self.pipeline.stages
        name = pathlib.Path(self.pipeline.path).stem
        if sum(stage["type"] == EDITS_OF_POINTS for stage in stages.values()) > 1:
            raise bad_input(f"{place}: the pipeline '{name}' has more than one stage {EDITS_OF_POINTS}", "one at most", "Put their edits into one")
        for kind in ("io.read_cloud", "ground.model", "stems.measure"):
            if sum(stage["type"] == kind for stage in stages.values()) != 1:
                raise bad_input(f"{place}: the pipeline '{name}' has no single stage {kind}", "a pipeline from a cloud to its stems", "Use stem_map_from_cloud")
        self.id_of = {stage["type"]: one for one, stage in stages.items()}
        self.ids = upstream(stages, self.id_of["stems.measure"], without=("stems.slice",))
        strange = next((stages[one]["type"] for one in self.ids if stages[one]["type"] not in IN_TILES), None)
        if strange:
            raise bad_input(f"{place}: the pipeline '{name}' measures stems after a stage {strange}, which is not run in tiles", "stages of " + ", ".join(IN_TILES))

    def _tile_settings(self, given, place):
        """Options of the stages that run in tiles, and the files among them."""
        settings = self._settings(given, place)
        self.edits = self._edits_of_points(settings, place)
        slice_id, scan = self.id_of.get("stems.slice"), self.id_of["io.read_cloud"]
        self.breast_height = settings.pop(f"{slice_id}.height", None)
        for name in settings:
            if name in (f"{scan}.file", f"{scan}.bounds"):
                raise bad_input(f"{place}: '{name}' is set", "the files of the cloud in 'cloud'", "The tiles decide what is read")
            if name.split(".")[0] not in self.ids:
                raise bad_input(f"{place}: '{name}' is of a stage that is not run in tiles", "options of " + ", ".join(self.ids))
        for kind, options in SETTLED.items():
            node = self.pipeline.stages[self.id_of[kind]].get("options") or {}
            for option, value in options.items():
                if option not in node:
                    settings.setdefault(f"{self.id_of[kind]}.{option}", value)
        files = {}
        for name, value in settings.items():
            if self.pipeline.is_path(name, value):
                files[name] = [os.path.normpath(self.resolved(path)) for path in self.pipeline.paths_in(name, value)]
                settings[name] = ",".join(files[name])
        edited = self.id_of.get(EDITS_OF_POINTS)
        in_document = {n: p for n, p in self.pipeline.files_in_document().items() if n not in settings and n.split(".")[0] in self.ids and n.split(".")[0] != edited}
        return settings, {**in_document, **files}

    def _edits_of_points(self, settings, place):
        """Those of the pipeline, which settings replace option by option. Each tile is given its own of them."""
        stage = self.id_of.get(EDITS_OF_POINTS)
        if stage is None or stage not in self.ids:
            return []
        own = {**(self.pipeline.stages[stage].get("options") or {})}
        own.update({"file": path[0] for name, path in self.pipeline.files_in_document().items() if name == f"{stage}.file"})
        for name in ("file", "edits"):
            if f"{stage}.{name}" in settings:
                own[name] = settings.pop(f"{stage}.{name}")
        return tile_edits.edits_in(self.resolved(own["file"]) if own.get("file") else "", own.get("edits", "[]"), place)

    def _nodes(self):
        """Copies of the stages that run in tiles, with absolute paths."""
        in_document, nodes = self.pipeline.files_in_document(), {}
        for one in self.ids:
            node = dict(self.pipeline.stages[one])
            node["options"] = {} if node["type"] == EDITS_OF_POINTS else dict(node.get("options") or {})
            node["inputs"] = {port: joint for port, joint in (node.get("inputs") or {}).items() if joint.split(".")[0] in self.ids}
            for option in node["options"]:
                if f"{one}.{option}" in in_document:
                    node["options"][option] = ",".join(in_document[f"{one}.{option}"])
            nodes[one] = node
        return nodes

    def documents(self):
        """{phase: pipeline document}; ids of stages are those of the pipeline, so that options fit both."""
        ground, stems = self.id_of["ground.model"], self.id_of["stems.measure"]
        first, second = self._nodes(), self._nodes()
        first[stems]["type"] = "stems.evidence"
        second[ground]["inputs"]["terrain"] = f"{TERRAIN}.raster"
        second[stems]["inputs"]["priors"] = f"{PRIORS}.table"
        results = {"id": RESULTS, "type": "report.tile"}
        of_stems = {port: f"{stems}.{port}" for port in ("stems", "sections", "rejected", "points")}
        if (edited := self.id_of.get(EDITS_OF_POINTS)) in self.ids:
            of_stems.update({"given": f"{stems}.given", "point_edits": f"{edited}.point_edits"})
        return {
            "cut": {"title": "Cut a cloud into tiles", "stages": [{"id": "cut", "type": "io.cut_cloud"}]},
            "ground": {"title": "Terrain of a tile", "stages": [
                *first.values(), {**results, "options": {"cloud": False}, "inputs": {"dem": f"{ground}.dem", "evidence": f"{stems}.evidence"}}]},
            "pool": {"title": "Priors of all stems", "stages": [
                {"id": "evidence", "type": "io.read_table"}, {"id": "pool", "type": "stems.pool_priors", "inputs": {"evidence": "evidence.table"}},
                {**results, "inputs": {"priors": "pool.priors"}}]},
            "stems": {"title": "Stems of a tile", "stages": [
                {"id": TERRAIN, "type": "io.read_raster"}, {"id": PRIORS, "type": "io.read_table"}, *second.values(),
                {**results, "options": {"cloud": self.cloud_files}, "inputs": of_stems}]},
            "label": {"title": "Tree ids of a tile", "stages": [
                {"id": "points", "type": "io.read_cloud"}, {"id": NUMBERS, "type": "io.read_table"},
                {"id": "renumber", "type": "stems.renumber", "inputs": {"points": "points.points", "numbers": f"{NUMBERS}.table"}},
                {**results, "inputs": {"points": "renumber.points"}}]},
        }
