"""The shipped pipeline of a stem map, built of proxies, gives the stems.csv that `bole run` gives."""

import csv
import pathlib

import bole_paraview
import paraview_test as t


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


def test(cloud, reference, folder):
    if not pathlib.Path(cloud).is_file():
        raise t.Skipped(f"there is no {cloud}")
    expected = pathlib.Path(reference) / "stems.csv"
    if not expected.is_file():
        raise t.Skipped(f"there is no {expected}: the command line program was not run")
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)

    stages = bole_paraview.open_document("stem_map_from_cloud", {"scan.file": cloud})
    for stage_id in ("scan", "ground", "stems", "edit", "georeference", "inventory", "check", "evaluate"):
        t.check(stage_id in stages, f"the stage {stage_id} is missing")
    stages["georeference"].UpdatePipeline()
    written = folder / "stems.csv"
    written.unlink(missing_ok=True)
    bole_paraview.write(stages["georeference"], "stems", written)
    found, wanted = rows_of(written), rows_of(expected)
    differ = [number for number, (a, b) in enumerate(zip(found, wanted)) if a != b]
    t.check(len(found) == len(wanted) and not differ, f"{written} and {expected} differ in the rows {differ}")
    print(f"{len(found) - 1} stems with {len(found[0])} columns, as of bole run; {t.processes()} processes")

    # Tables, points and the terrain show in ParaView with the names of their arrays.
    information = stages["stems"].SMProxy.GetDataInformation(bole_paraview.output_index(stages["stems"], "points"))
    arrays = information.GetPointDataInformation()
    t.check(arrays.GetArrayInformation("tree_id") is not None, "the points of the stems have no tree_id")
    stages["ground"].UpdatePipeline()
    terrain = stages["ground"].SMProxy.GetDataInformation(bole_paraview.output_index(stages["ground"], "dem"))
    extent = terrain.GetExtent()
    t.check(extent[1] > extent[0] and extent[3] > extent[2], f"the terrain has the extent {extent}")
    report = bole_paraview.report(stages["stems"])
    t.check(report.get("counts", {}).get("stems", 0) > 10, f"the report of stems.measure is {str(report)[:200]}")


t.run(test)
