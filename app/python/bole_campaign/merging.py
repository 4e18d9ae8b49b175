"""stems.csv, campaign.gpkg and campaign.html from the folders of the inputs. Only results that are current are taken."""

import csv
import os
import pathlib
import sqlite3

from . import geopackage, page


def done_folder(task):
    return pathlib.Path(task["folder"]) / "done"


def write_table(out, name, tasks):
    """One table of all inputs, cell by cell as their runs wrote it. Returns the number of rows and the inputs without it."""
    tables, heading, without = [], ["input_id"], []
    for task in tasks:
        try:
            with open(done_folder(task) / name, encoding="utf-8-sig", newline="") as file:
                names = next(csv.reader(file), [])
        except FileNotFoundError:
            without.append(task["id"])
            continue
        # A column input_id of the run would hide whose row it is.
        names = ["input_id_of_run" if n == "input_id" else n for n in names]
        heading += [n for n in names if n not in heading]
        tables.append((task, names))
    draft, count = out / f".{name}.{os.getpid()}", 0
    with open(draft, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(heading)
        for task, names in tables:
            at = {n: i for i, n in enumerate(names)}
            with open(done_folder(task) / name, encoding="utf-8-sig", newline="") as source:
                rows = csv.reader(source)
                next(rows, None)
                for row in rows:
                    writer.writerow([task["id"], *(row[at[n]] if n in at and at[n] < len(row) else "" for n in heading[1:])])
                    count += 1
    os.replace(draft, out / name)
    return count, without


def place_inputs(rows, layers):
    """Where inputs lie on a map: as the document says, else the middle of their stems where those have map coordinates.
    Returns the coordinate system of the places (None: undefined)."""
    if any(row["x_m"] is not None for row in rows):
        return None
    placed = {input_id: layer for input_id, layer in layers if layer.srs is not None}
    if len({layer.srs_key for layer in placed.values()}) != 1:
        return None
    for row in rows:
        places = [p for g in (placed[row["input_id"]].geometries if row["input_id"] in placed else []) if (p := geopackage.coordinates_of(g))]
        if places:
            row["x_m"], row["y_m"] = (sum(axis) / len(places) for axis in zip(*places))
    return next(iter(placed.values())).srs


def read_layers(tasks, notes):
    layers = []
    for task in tasks:
        try:
            layer = geopackage.stems_of(done_folder(task))
        except (sqlite3.Error, OSError, ValueError) as error:
            notes.append(f"the stems of {task['id']} cannot be read for campaign.gpkg: {error}")
            continue
        if layer is not None:
            layers.append((task["id"], layer))
    return layers


def merge(of_plan, ledger=None):
    """Writes everything. Returns the rows of the inputs and what a person should know (sentences). With the lock held."""
    out = of_plan.out
    rows = of_plan.rows()
    done = [task for task, row in zip(of_plan.tasks, rows) if row["state"] == "done"]
    notes = []
    for name in of_plan.tables:
        _, without = write_table(out, name, done)
        if without:
            notes.append(f"{len(without)} of {len(done)} inputs that are done wrote no {name} (first: {without[0]})")
    own = ledger or geopackage.Ledger(out / "campaign.gpkg")
    try:
        layers = read_layers(done, notes)
        srs = place_inputs(rows, layers)
        own.write_inputs(rows, srs)
        elsewhere = own.write_stems(layers)
    finally:
        if ledger is None:
            own.close()
    if elsewhere:
        notes.append(f"{len(elsewhere)} inputs are in other coordinates than most (first: {elsewhere[0]}): their stems have no geometry in campaign.gpkg")
    page.write(out / "campaign.html", of_plan.title, rows, notes)
    return rows, notes
