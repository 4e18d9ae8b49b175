"""campaign.html: one file that needs nothing else. Map, table, the worst inputs first, links to their reports."""

import html
import os
import pathlib
import string
import urllib.parse

from . import states

COLUMNS = (("input_id", "input", ""), ("state", "state", ""), ("verdict", "verdict", ""), ("stems", "stems", "d"), ("seconds", "time (s)", ".1f"),
           ("peak_mib", "memory (MiB)", ".0f"), ("attempts", "attempts", "d"), ("killed", "killed", "d"), ("findings", "findings", "d"), ("error", "error", ""))
MAP_WIDTH, MARGIN = 640.0, 20.0


def cell(row, name, form):
    value = row[name]
    if value is None or value == "":
        return "<td></td>"
    text = html.escape(format(value, form) if form else str(value))
    if name == "input_id":
        target = row["report"] or row["log"]
        text = f'<a href="{urllib.parse.quote(target)}">{text}</a>' if target else text
    kind = f' class="{html.escape(str(value))}"' if name in ("state", "verdict") else ' class="n"' if form else ""
    key = f' data-v="{value}"' if form else ""
    return f"<td{kind}{key}>{text}</td>"


def table(rows):
    head = "".join(f"<th>{title}</th>" for _, title, _ in COLUMNS)
    body = "\n".join("<tr>" + "".join(cell(row, name, form) for name, _, form in COLUMNS) + "</tr>" for row in rows)
    return f'<table id="inputs"><thead><tr>{head}</tr></thead><tbody>\n{body}\n</tbody></table>'


def map_of(rows):
    """A map, north up, with a scale bar; where no coordinates are known a sentence that says so."""
    placed = [row for row in rows if row["x_m"] is not None and row["y_m"] is not None]
    if not placed:
        if any("tile_m" in row for row in rows):
            return "<p>No map: the tiles are known once the cloud is cut.</p>"
        return "<p>No map: the inputs have no map coordinates (x_m and y_m in the campaign document, or surveys with a coordinate system).</p>"
    half = max((row.get("tile_m") or 0.0) for row in placed) / 2
    xs, ys = ([row[axis] + side for row in placed for side in (-half, half)] for axis in ("x_m", "y_m"))
    span = max(max(xs) - min(xs), max(ys) - min(ys), 1e-9)
    scale = (MAP_WIDTH - 2 * MARGIN) / span
    height = (max(ys) - min(ys)) * scale + 2 * MARGIN + 24
    dots = []
    for row in sorted(placed, key=states.badness, reverse=True):  # the worst on top
        x, y = MARGIN + (row["x_m"] - min(xs)) * scale, MARGIN + (max(ys) - row["y_m"]) * scale
        name = html.escape(row["input_id"])
        told = f"{name}: {row['state'].replace('_', ' ')}" + ("" if row["stems"] is None else f", {row['stems']} stems")
        shape = f'circle cx="{x:.1f}" cy="{y:.1f}" r="5"'
        if row.get("tile_m"):
            side = row["tile_m"] * scale
            shape = f'rect x="{x - side / 2:.1f}" y="{y - side / 2:.1f}" width="{side:.1f}" height="{side:.1f}"'
        dot = f'<{shape} class="{row["state"]}"><title>{told}</title></{shape.split()[0]}>'
        dots.append(f'<a href="{urllib.parse.quote(row["report"] or row["log"])}">{dot}</a>' if row["report"] or row["log"] else dot)
    power = 10 ** (len(str(int(span / 4))) - 1) if span >= 4 else span / 4
    bar = next((k * power for k in (5, 2, 1) if k * power <= span / 2), span / 4)
    y = height - 10
    ruler = f'<line x1="{MARGIN}" x2="{MARGIN + bar * scale:.1f}" y1="{y:.1f}" y2="{y:.1f}" class="bar"/><text x="{MARGIN}" y="{y - 5:.1f}">{bar:g} m</text>'
    others = sum(1 for row in rows if row["x_m"] is None and "tile_m" not in row)
    absent = f"<p>{others} inputs have no coordinates and are not on the map.</p>" if others else ""
    return f'<svg viewBox="0 0 {MAP_WIDTH:.0f} {height:.0f}" width="{MAP_WIDTH:.0f}">{"".join(dots)}{ruler}</svg>{absent}'


def write(path, title, rows, notes):
    rows = sorted(rows, key=states.badness)
    spent = [row["seconds"] for row in rows if row["seconds"]]
    counts = "".join(f'<span class="{state}">{n} {state.replace("_", " ")}</span> ' for state, n in states.counts_of(rows).items())
    template = string.Template(pathlib.Path(__file__).with_name("page.html").read_text(encoding="utf-8"))
    noun = "tiles" if any("tile_m" in row for row in rows) else "inputs"
    count = sum(1 for row in rows if row.get("tile_m")) if noun == "tiles" else len(rows)
    text = template.substitute(
        title=html.escape(title), counts=counts, map=map_of(rows), table=table(rows),
        sums=f"{count} {noun}, {sum(row['stems'] or 0 for row in rows if row['state'] == 'done')} stems, {sum(spent) / 3600:.2f} hours of work",
        notes="".join(f"<li>{html.escape(note)}</li>" for note in notes))
    draft = path.with_name(f".{path.name}.{os.getpid()}")
    draft.write_text(text, encoding="utf-8")
    os.replace(draft, path)
