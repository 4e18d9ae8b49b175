"""Points that a person gave by hand (survey.edit_points), in tiles: each tile takes the edits that may reach it.

Edits select by geometry and name trees by their places, so that they hold in any part of a cloud that has the tree. What
became of each over all tiles is told in point_edits.csv.
"""

import collections
import csv
import hashlib
import io
import json
import math

from . import folders
from .errors import bad_input

HEADING = ("edit", "tree_id", "x_m", "y_m", "action", "outcome", "message", "author", "time", "reason")


def listed(text, place):
    """The edits of a JSON list. What each of them says is checked by the tiles."""
    try:
        edits = json.loads(text)
    except json.JSONDecodeError as error:
        raise bad_input(f"{place} is no JSON (line {error.lineno}: {error.msg})", "a list of edits") from None
    if not isinstance(edits, list) or not all(isinstance(edit, dict) for edit in edits):
        raise bad_input(f"{place} is no list of edits", '[{"action": "to_noise", "centre": [x, y, z], "size_m": [x, y, z]}]')
    return edits


def edits_in(file, edits, place):
    """Those of a file and after them those of an option, as the stage joins them."""
    found = []
    if file:
        try:
            with open(file, encoding="utf-8-sig") as opened:
                found = listed(opened.read(), f"'{file}'")
        except OSError as error:
            raise bad_input(f"{place}: the edits of points in '{file}' cannot be read ({error.strerror})", "a file with a JSON list") from None
    return found + listed(edits if isinstance(edits, str) else json.dumps(edits), f"{place}: edits of points")


def box_of(corners, reach):
    xs, ys = [c[0] for c in corners], [c[1] for c in corners]
    return min(xs) - reach[0], min(ys) - reach[1], max(xs) + reach[0], max(ys) + reach[1]


def box_around(edit):
    """(xmin, ymin, xmax, ymax) that holds all points of an edit; None where it may be any."""
    boxes = []
    try:
        if "within" in edit:
            boxes.append(box_of(edit["within"], (0, 0)))
        if "centre" in edit:
            east, north, _ = edit["size_m"]
            turned = 0.5 * math.hypot(east, north)
            boxes.append(box_of([edit["centre"]], (turned, turned) if edit.get("turn_deg") else (0.5 * east, 0.5 * north)))
        if "path" in edit:
            boxes.append(box_of(edit["path"], (edit["radius_m"],) * 2))
    except (KeyError, IndexError, TypeError, ValueError):
        return None  # the stage says what is wrong with it
    return (*(max(b[i] for b in boxes) for i in (0, 1)), *(min(b[i] for b in boxes) for i in (2, 3))) if boxes else None


def meets(box, core, margin):
    return box is None or all(box[i] <= core[i + 2] + margin and box[i + 2] >= core[i] - margin for i in (0, 1))


def of_tile(edits, tile, margin):
    """[(number from 1, edit)] that may select points of a tile or its buffer."""
    return [(number, edit) for number, edit in enumerate(edits, 1) if meets(box_around(edit), tile["core"], margin)]


def text_of(numbered):
    return json.dumps([edit for _, edit in numbered], ensure_ascii=False)


def file_of(plan, numbered):
    """Named by what it holds, so that a tile is measured anew when its edits change, and only then."""
    return plan.joined(f"point_edits_{hashlib.blake2b(text_of(numbered).encode(), digest_size=8).hexdigest()}.json")


def settings_of(plan, tile):
    """The settings and files by which a tile takes its edits; none where there are none."""
    numbered = of_tile(plan.edits(), tile, plan.info["buffer_m"])
    if not numbered:
        return {}, {}
    option, path = f"{plan.info['id_of']['survey.edit_points']}.file", str(file_of(plan, numbered))
    return {option: path}, {option: [path]}


def write_files(plan, tiles):
    for tile in tiles:
        if numbered := of_tile(plan.edits(), tile, plan.info["buffer_m"]):
            folders.write_text(file_of(plan, numbered), text_of(numbered))


def told_by_tiles(plan, measured):
    """{number of the edit: [(tile, row)]}: of each measured tile what it selected in its core, and whether it found the tree."""
    told = collections.defaultdict(list)
    for tile in measured:
        path = plan.done(f"{tile['name']}.stems") / "point_edits.csv"
        if not path.exists():
            continue
        numbered = of_tile(plan.edits(), tile, plan.info["buffer_m"])
        with open(path, encoding="utf-8-sig", newline="") as file:
            for (number, _), row in zip(numbered, csv.DictReader(file)):
                told[number].append((tile, row))
    return told


def outcome(told, buffer_m):
    """(applied, message) of an edit."""
    held = [(tile, row) for tile, row in told if int(row["points"]) > 0]
    points = sum(int(row["points"]) for _, row in held)
    if points == 0:
        return False, "no point lies in its selection"
    without = [(tile, row) for tile, row in held if row["applied"] != "1"]
    if len(without) == len(held):
        return False, "its tree is not among the stems of the tiles that hold its points: a tile sees its neighbours as far as its buffer reaches"
    if without:
        lost = sum(int(row["points"]) for _, row in without)
        names = ", ".join(tile["name"] for tile, _ in without)
        return False, f"{lost} of {points} points lie in tiles that do not see its tree ({names}): buffer_m is {buffer_m:g}"
    return True, f"{points} points selected"


def merge(plan, measured):
    """Writes point_edits.csv. Returns what a person should know of edits that were not applied."""
    edits, notes, text = plan.edits(), [], io.StringIO()
    if not edits:
        (plan.out / "point_edits.csv").unlink(missing_ok=True)
        return []
    told = told_by_tiles(plan, measured)
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADING)
    for number, edit in enumerate(edits, 1):
        applied, message = outcome(told[number], plan.info["buffer_m"])
        own = next((plan.numbered[tile["name"]].get(int(row["tree_id"])) for tile, row in told[number] if int(row["tree_id"]) > 0), None)
        tree = edit.get("tree") or [None, None]
        writer.writerow([number, own or 0, *("" if v is None else v for v in tree[:2]), edit.get("action", ""), "applied" if applied else "conflict", message,
                         *(edit.get(name, "") for name in ("author", "time", "reason"))])
        if not applied:
            notes.append(f"edit {number} of points ({edit.get('action', '')}) is not applied as a whole: {message}")
    folders.write_text(plan.out / "point_edits.csv", text.getvalue())
    return notes
