"""Stems of all tiles as one list: who owns a stem, which measures are of one stem, and the number it gets.

A stem belongs to the tile whose half-open core holds it at breast height. The same stem is measured in two tiles where
buffers overlap, a hair's breadth apart: measures of neighbouring tiles that are each other's nearest belong together, so
that a stem on a seam is neither lost nor counted twice.
"""

import collections
import csv
import io
import os
import shutil

from . import folders, geopackage, merging, page, tile_edits, tile_terrain
from .folders import task_folder

MATCH_M = 0.3  # or the diameter, whichever is more


class Measure:
    """A row of the stem table of a tile."""

    def __init__(self, tile, row):
        self.tile, self.row, self.tree_id = tile, row, int(row["tree_id"])
        self.x, self.y = float(row["x_m"]), float(row["y_m"])
        self.dbh_m = float(row["dbh_cm"]) / 100
        self.arc = float(row.get("arc_deg") or 0)
        self.claimed = tile_terrain.in_core(tile, self.x, self.y)


def measures_of(plan, tiles):
    """{tile name: [Measure]} of the tiles whose stems are measured."""
    found = {}
    for tile in tiles:
        with open(plan.done(f"{tile['name']}.stems") / "stems.csv", encoding="utf-8-sig", newline="") as file:
            found[tile["name"]] = [Measure(tile, row) for row in csv.DictReader(file)]
    return found


def is_near(a, b):
    return (a.x - b.x) ** 2 + (a.y - b.y) ** 2 <= max(MATCH_M, a.dbh_m, b.dbh_m) ** 2


class Places:
    """Measures of a tile by squares of a metre."""

    def __init__(self, measures):
        self.squares = collections.defaultdict(list)
        self.reach = 1 + int(max([MATCH_M, *(m.dbh_m for m in measures)]))
        for m in measures:
            self.squares[int(m.x // 1), int(m.y // 1)].append(m)

    def nearest(self, m):
        """The nearest measure that may be of the same stem, or None."""
        column, row, r = int(m.x // 1), int(m.y // 1), max(self.reach, 1 + int(m.dbh_m))
        near = (o for i in range(column - r, column + r + 1) for j in range(row - r, row + r + 1) for o in self.squares.get((i, j), ()) if is_near(m, o))
        return min(near, key=lambda o: ((o.x - m.x) ** 2 + (o.y - m.y) ** 2, o.tree_id), default=None)


def groups_of(measures, neighbours):
    """Measures of one stem as lists, of each tile one at most. `neighbours`: pairs of tile names whose buffers may overlap."""
    group = {m: [m] for rows in measures.values() for m in rows}
    places = {name: Places(rows) for name, rows in measures.items()}
    for a, b in neighbours:
        for m in measures[a]:
            other = places[b].nearest(m)
            if other is None or places[a].nearest(other) is not m or group[m] is group[other]:
                continue
            if {x.tile["name"] for x in group[m]} & {x.tile["name"] for x in group[other]}:
                continue
            group[m] += group[other]
            for x in group[other]:
                group[x] = group[m]
    return list({id(g): g for g in group.values()}.values())


def chosen(group, owner_of):
    """The measure that counts for a stem. None where it lies in the core of another tile, which sees all around it and
    found no stem there, or was not measured."""
    claims = [m for m in group if m.claimed]
    owners = {owner_of(m) for m in group}
    if not claims and len(owners) == 1 and owners != {None}:
        return None
    return max(claims or group, key=lambda m: (m.arc, m.tile["name"]))


def owned_stems(plan):
    """[Measure] that count, by number from 1: north to south, west to east; and {tile: {tree_id: number}} of all."""
    tiles = plan.tiles()
    stems = plan.phase_tasks("stems")
    measured = [t for t in tiles if t["name"] in stems and plan.is_current(stems[t["name"]])]
    by_place = {(t["column"], t["row"]): t for t in tiles}
    names = {t["name"] for t in measured}
    reach = 1 + int(2 * plan.info["buffer_m"] // plan.info["tile_m"])
    pairs = [(a["name"], b["name"]) for a in measured for dc in range(-reach, reach + 1) for dr in range(-reach, reach + 1)
             if (dr, dc) > (0, 0) and (b := by_place.get((a["column"] + dc, a["row"] + dr))) and b["name"] in names]
    size, shift = plan.info["tile_m"], plan.info["shift_m"]

    def owner_of(m):
        owner = by_place.get((int((m.x - shift[0]) // size), int((m.y - shift[1]) // size)))
        return owner and owner["name"]

    measures = measures_of(plan, measured)
    kept = [(best, group) for group in groups_of(measures, pairs) if (best := chosen(group, owner_of)) is not None]
    kept.sort(key=lambda entry: (-entry[0].y, entry[0].x))
    numbers = {name: {} for name in measures}
    for number, (_, group) in enumerate(kept, 1):
        for m in group:
            numbers[m.tile["name"]][m.tree_id] = number
    return [best for best, _ in kept], numbers


def number_trees(plan):
    """joined/numbers_TILE.csv for every tile that is measured; returns the measures that count."""
    best, plan.numbered = owned_stems(plan)
    for name, numbers in plan.numbered.items():
        lines = "".join(f"{tree_id},{number}\n" for tree_id, number in sorted(numbers.items()))
        folders.write_text(plan.joined(f"numbers_{name}.csv"), "tree_id,number\n" + lines)
    return best


def write_stems(plan, best):
    """stems.csv: cell by cell as the tiles wrote it, with the number of the whole as tree_id."""
    heading = ["input_id", "tree_id", "tree_id_in_tile"]
    for m in best:
        heading += [name for name in m.row if name not in heading]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(heading)
    for number, m in enumerate(best, 1):
        cells = {**m.row, "input_id": m.tile["name"], "tree_id": number, "tree_id_in_tile": m.tree_id}
        writer.writerow([cells.get(name, "") for name in heading])
    folders.write_text(plan.out / "stems.csv", text.getvalue())


def stem_layers(plan, best, notes):
    """[(tile, Layer)] with the rows that count, in the numbers of the whole."""
    own = collections.defaultdict(dict)
    for number, m in enumerate(best, 1):
        own[m.tile["name"]][m.tree_id] = number
    tasks = [{**task, "id": task["row"]} for name, task in plan.phase_tasks("stems").items() if name in own]
    layers = merging.read_layers(tasks, notes)
    for name, layer in layers:
        at = next(i for i, (column, _) in enumerate(layer.columns) if column == "tree_id")
        rows = [(own[name].get(int(row[at])), row, geometry) for row, geometry in zip(layer.rows, layer.geometries)]
        kept = [(number, row, geometry) for number, row, geometry in rows if number is not None]
        layer.rows = [(*row[:at], number, *row[at + 1:]) for number, row, _ in kept]
        layer.geometries = [geometry for _, _, geometry in kept]
    return layers


def place_clouds(plan):
    """tiles/NAME.laz: the points of each core with the tree ids of the whole."""
    folder = plan.out / "tiles"
    labels = plan.phase_tasks("label")
    wanted = {f"{name}.laz" for name, task in labels.items() if plan.is_current(task)}
    folder.mkdir(exist_ok=True)
    for name in sorted(wanted):
        source = task_folder(plan.out, name.removesuffix(".laz") + ".label") / "done" / "cloud.laz"
        draft = folder / f".{name}.{os.getpid()}"
        draft.unlink(missing_ok=True)
        try:
            os.link(source, draft)
        except OSError:  # a file system without links
            shutil.copy2(source, draft)
        os.replace(draft, folder / name)
    for left in folder.glob("*.laz"):
        if left.name not in wanted:
            left.unlink()


def merge(plan, ledger=None):
    """Writes everything that is known so far. Returns the rows of the tiles and what a person should know."""
    rows, notes = plan.rows(), []
    best = number_trees(plan)
    write_stems(plan, best)
    notes += tile_edits.merge(plan)
    counts = collections.Counter(m.tile["name"] for m in best)
    for row in rows:
        row["stems"] = counts.get(row["input_id"], 0) if row["input_id"] in plan.numbered else None
    if plan.info["cloud_files"]:
        place_clouds(plan)
    own = ledger or geopackage.Ledger(plan.out / "campaign.gpkg")
    try:
        layers = stem_layers(plan, best, notes)
        own.write_inputs(rows, layers[0][1].srs if layers else None)
        elsewhere = own.write_stems(layers)
    finally:
        if ledger is None:
            own.close()
    if elsewhere:
        notes.append(f"{len(elsewhere)} tiles are in other coordinates than most (first: {elsewhere[0]}): their stems have no geometry in campaign.gpkg")
    page.write(plan.out / "campaign.html", plan.title, rows, notes)
    return rows, notes
