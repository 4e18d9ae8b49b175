"""What tiles say that belongs together: their terrain, as one raster without seams, and the evidence of their stems."""

import csv
from xml.sax.saxutils import escape

from . import folders
from .tiled_document import RESULTS


def in_core(tile, x, y):
    """Half open: what lies on the upper edges belongs to the next tile."""
    xmin, ymin, xmax, ymax = tile["core"]
    return xmin <= x < xmax and ymin <= y < ymax


def tiles_of_stems(table):
    """The tile of every row of the merged table; none where it is not written yet."""
    try:
        with open(table, encoding="utf-8", newline="") as file:
            return [row["input_id"] for row in csv.DictReader(file)]
    except FileNotFoundError:
        return []


def facts_of(folder):
    """What the stage that wrote the results of a tile says: {"dem": ..., "crs": ...}."""
    summary = folders.read_json(folder / "summary.json") or {}
    return next((stage.get("facts", {}) for stage in summary.get("stages", []) if stage["id"] == RESULTS), {})


def raster_of(folder):
    """(x, y of the lower left corner, cell, columns, rows) of the terrain in a folder; None where there is none."""
    parts = facts_of(folder).get("dem", "").split()
    return (*map(float, parts[:3]), *map(int, parts[3:])) if len(parts) == 5 else None


def cell_of(folder):
    raster = raster_of(folder)
    return raster[2] if raster else 1.0


def join_terrain(plan, tiles):
    """terrain.vrt: the cores side by side. Their cells are those of one grid (cloud/core/whole/whole_cloud.h)."""
    placed = [(t, raster) for t in tiles if (raster := raster_of(plan.done(f"{t['name']}.ground")))]
    cell = placed[0][1][2]
    left, top = min(r[0] for _, r in placed), max(r[1] + r[4] * cell for _, r in placed)
    sources, columns, rows = [], 0, 0
    for tile, (x, y, _, nx, ny) in placed:
        at_column, at_row = round((x - left) / cell), round((top - (y + ny * cell)) / cell)
        columns, rows = max(columns, at_column + nx), max(rows, at_row + ny)
        file = (plan.done(f"{tile['name']}.ground") / "dem.tif").relative_to(plan.out).as_posix()
        sources.append(f'    <SimpleSource>\n      <SourceFilename relativeToVRT="1">{escape(file)}</SourceFilename>\n      <SourceBand>1</SourceBand>\n'
                       f'      <SrcRect xOff="0" yOff="0" xSize="{nx}" ySize="{ny}"/>\n      <DstRect xOff="{at_column}" yOff="{at_row}" xSize="{nx}" ySize="{ny}"/>\n    </SimpleSource>\n')
    crs = next((c for t, _ in placed if (c := facts_of(plan.done(f"{t['name']}.ground")).get("crs"))), "")
    folders.write_text(plan.out / "terrain.vrt",
               f'<VRTDataset rasterXSize="{columns}" rasterYSize="{rows}">\n' + (f'  <SRS dataAxisToSRSAxisMapping="1,2">{escape(crs)}</SRS>\n' if crs else "")
               + f'  <GeoTransform>{left!r}, {cell!r}, 0, {top!r}, 0, {-cell!r}</GeoTransform>\n  <VRTRasterBand dataType="Float32" band="1">\n'
               f'    <Description>elevation_m</Description>\n    <NoDataValue>nan</NoDataValue>\n' + "".join(sources) + "  </VRTRasterBand>\n</VRTDataset>\n")


def join_evidence(plan, tiles):
    """joined/evidence.csv: rows of the stems that lie in the core of their tile, so that each counts once."""
    heading, lines = None, []
    for tile in tiles:
        with open(plan.done(f"{tile['name']}.ground") / "evidence.csv", encoding="utf-8", newline="") as file:
            rows = csv.reader(file)
            names = next(rows)
            heading = heading or names
            x, y = names.index("x_m"), names.index("y_m")
            lines += [row for row in rows if in_core(tile, float(row[x]), float(row[y]))]
    folders.write_text(plan.joined("evidence.csv"), "\n".join(",".join(row) for row in [heading, *lines]) + "\n")
