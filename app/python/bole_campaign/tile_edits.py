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


def box_of(corners, reach=(0, 0)):
    xs, ys = [c[0] for c in corners], [c[1] for c in corners]
    return min(xs) - reach[0], min(ys) - reach[1], max(xs) + reach[0], max(ys) + reach[1]


def normal_of(corners):
    """Of the plane of an outline, of length 1 (Newell)."""
    n = [0.0, 0.0, 0.0]
    for a, b in zip(corners, corners[1:] + corners[:1]):
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            n[k] += (a[i] - b[i]) * (a[j] + b[j])
    length = math.hypot(*n)
    return [v / length for v in n]


def outline_box(edit):
    """None where it is drawn in perspective, or reaches without end to a side."""
    corners, depth = edit["outline"], edit.get("depth_m")
    if "eye" in edit:
        return None
    normal = normal_of(corners)
    if depth is None:
        return box_of(corners) if abs(normal[2]) > 1 - 1e-9 else None
    return box_of([[c[k] + d * normal[k] for k in range(3)] for c in corners for side in (-1, 1) for d in (side * depth[0], side * depth[1])])


def box_around(edit):
    """(xmin, ymin, xmax, ymax) that holds all points of an edit; None where it may be any."""
    boxes = []
    try:
        if "within" in edit:
            boxes.append(box_of(edit["within"]))
        if "outline" in edit:
            boxes.append(outline_box(edit))
        if "centre" in edit:
            east, north, _ = edit["size_m"]
            turned = 0.5 * math.hypot(east, north)
            boxes.append(box_of([edit["centre"]], (turned, turned) if edit.get("turn_deg") else (0.5 * east, 0.5 * north)))
        if "path" in edit:
            boxes.append(box_of(edit["path"], (edit["radius_m"],) * 2))
    except (KeyError, IndexError, TypeError, ValueError, ZeroDivisionError):
        return None  # the stage says what is wrong with it
    boxes = [box for box in boxes if box is not None]
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


def told_by_tiles(plan):
    """{number of the edit: ([(tile, row)] of measured tiles, [names of tiles that are not])}. A row has what lies in the
    selection and the core, and what the tile made of it."""
    told = collections.defaultdict(lambda: ([], []))
    for tile in plan.tiles():
        numbered = of_tile(plan.edits(), tile, plan.info["buffer_m"])
        path = plan.done(f"{tile['name']}.stems") / "point_edits.csv"
        if not numbered:
            continue
        if tile["name"] not in plan.numbered or not path.exists():
            for number, _ in numbered:
                told[number][1].append(tile["name"])
            continue
        with open(path, encoding="utf-8-sig", newline="") as file:
            for (number, _), row in zip(numbered, csv.DictReader(file)):
                told[number][0].append((tile, row))
    return told


def outcome(edit, rows, waiting, buffer_m):
    """(applied, conflict or open; message) of an edit."""
    held = [(tile, row) for tile, row in rows if int(row["points"]) > 0]
    points, given = (sum(int(row[name]) for _, row in held) for name in ("points", "given"))
    gives_class = edit.get("action") in ("to_ground", "to_noise")
    # Where the tree of a condition is not seen, no point is of it.
    without = [(tile, row) for tile, row in held if row["lacks"] == "tree"]
    if waiting:
        return "open", f"tiles are not measured that it may reach: {', '.join(waiting[:5])}" + (", ..." if len(waiting) > 5 else "")
    if points == 0:
        return "conflict", "no point lies in its selection"
    if len(without) == len(held) or all(row["lacks"] for _, row in held):
        return "conflict", "its tree is not among the stems of the tiles that hold its points: a tile sees its neighbours as far as its buffer reaches"
    if without:
        lost = sum(int(row["points"]) for _, row in without)
        names = ", ".join(tile["name"] for tile, _ in without)
        return "conflict", f"{lost} of {points} points lie in tiles that do not see its tree ({names}): buffer_m is {buffer_m:g}"
    if given == 0 and not gives_class:
        return "conflict", "no point of its selection meets its condition"
    return "applied", f"{points} points selected"


def tree_number(plan, rows):
    """In the whole, of the tree that an edit gave points to; 0: none."""
    numbers = (plan.numbered[tile["name"]].get(int(row["tree_id"])) for tile, row in rows if int(row["tree_id"]) > 0)
    return next((number for number in numbers if number), 0)


def merge(plan):
    """Writes point_edits.csv. Returns what a person should know of edits that were not applied."""
    edits, notes, text = plan.edits(), [], io.StringIO()
    if not edits:
        (plan.out / "point_edits.csv").unlink(missing_ok=True)
        return []
    told = told_by_tiles(plan)
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADING)
    for number, edit in enumerate(edits, 1):
        rows, waiting = told[number]
        state, message = outcome(edit, rows, waiting, plan.info["buffer_m"])
        tree = edit["tree"] if isinstance(edit.get("tree"), list) and len(edit["tree"]) == 2 else ["", ""]
        writer.writerow([number, tree_number(plan, rows), *tree, edit.get("action", ""), state, message, *(edit.get(name, "") for name in ("author", "time", "reason"))])
        if state == "conflict":
            notes.append(f"edit {number} of points ({edit.get('action', '')}) is not applied as a whole: {message}")
    folders.write_text(plan.out / "point_edits.csv", text.getvalue())
    return notes
