"""The state of every tile as a row: of all the phases that work on it."""

from . import states

# The worst first; what runs tells more than what is missing.
ORDER = ("crashed", "failed", "bad_input", "running", "changed", "missing", "done")
PHASES_OF_A_TILE = ("ground", "stems", "label")


def expected(plan):
    return PHASES_OF_A_TILE if plan.info["cloud_files"] else PHASES_OF_A_TILE[:2]


def row_of(plan, name, running=None):
    """`running`: {task: whether it runs}, where the caller knows."""
    tasks = [task for task in plan.tasks if task["row"] == name]
    parts = [states.row_of(task, plan.out, (running or {}).get(task["id"])) for task in tasks]
    worst = min(parts, key=lambda part: ORDER.index(part["state"]))
    measured = next((part for part, task in zip(parts, tasks) if task["phase"] == "stems"), parts[-1])
    row = {**parts[-1], "verdict": measured["verdict"], "input_id": name, "state": worst["state"], "error": worst["error"], "log": worst["log"] or parts[-1]["log"]}
    tile = plan.tile(name)
    if tile is not None:
        missing = [phase for phase in expected(plan) if phase not in {task["phase"] for task in tasks}]
        if worst["state"] == "done" and missing:
            row.update(state="missing", error=f"{missing[0]} has not run yet")
            if "stems" in missing and parts[0]["state"] == "done" and not (plan.done(f"{name}.ground") / "dem.tif").exists():
                row.update(state="done", error="no terrain lies in its core: no stems were looked for")
        xmin, ymin, xmax, ymax = tile["core"]
        row.update(x_m=(xmin + xmax) / 2, y_m=(ymin + ymax) / 2)
    for total in ("seconds", "attempts", "killed", "findings", "warnings"):
        values = [part[total] for part in parts if part[total] is not None]
        row[total] = round(sum(values), 3) if values else None
    peaks = [part["peak_mib"] for part in parts if part["peak_mib"] is not None]
    row.update(peak_mib=max(peaks) if peaks else None, memory_gib=max(part["memory_gib"] for part in parts), stems=None,
               points=tile["points"] if tile else None, tile_m=plan.info["tile_m"] if tile else None)
    return row
