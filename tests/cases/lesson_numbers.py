"""Where the numbers in the tables of the lessons come from: row and heading of the table, file and name of the value, factor.

A value is FILE NAME of a summary.json or another JSON file ("angle_error_mean/value" leads into it), or FILE {COLUMN: VALUE} COLUMN of a table.
"""


def samples():
    name = "basal_area_m2_per_ha"
    for radius in ("4", "8", "12.62", "15"):
        where = {"radius_m": radius, "edge": "inside"}
        yield {"row": f"{radius} m", "heading": "SD of single plots", "from": ("sample/sample_summary.csv", where, f"{name}_sd_pct")}
        yield {"row": f"{radius} m", "heading": "of trees at random", "from": ("sample/sample_summary.csv", where, f"{name}_poisson_sd_pct")}
    for edge in ("ignore", "inside", "area", "mirage"):
        for radius in ("4", "8", "15"):
            yield {"row": edge, "heading": f"{radius} m", "from": ("sample/sample_summary.csv", {"radius_m": radius, "edge": edge}, f"{name}_bias_pct")}
    for radius in ("4", "8", "15"):
        for heading, folder in (("bias of basal area", "sample"), ("with distances to the bark", "bark")):
            yield {"row": f"{radius} m", "heading": heading, "from": (f"{folder}/sample_summary.csv", {"radius_m": radius, "edge": "mirage"}, f"{name}_bias_pct")}


def rows():
    for row, folder in (("`face`: the axis behind the side that is seen", "face"), ("`mean`: the mean of the trunk points", "mean")):
        yield {"row": row, "heading": "angle error, mean", "from": (f"{folder}/evaluation.json", "angle_error_mean/value")}
        yield {"row": row, "heading": "largest", "from": (f"{folder}/evaluation.json", "angle_error_max/value")}
    for row, folder in (("from the marks", "face"), ("true", "pose")):
        for number in ("1", "2"):
            yield {"row": row, "heading": f"angle of row {number}", "from": (f"{folder}/rows.csv", {"row_id": number}, "angle_deg")}
        yield {"row": row, "heading": "angle error, mean", "from": (f"{folder}/evaluation.json", "angle_error_mean/value")}
    for heading, column in (("angle", "angle_deg"), ("standard error", "angle_se_deg"), ("interval from", "angle_lo_deg"), ("to", "angle_hi_deg")):
        yield {"row": "1", "heading": heading, "from": ("face/rows.csv", {"row_id": "1"}, column)}
    for heading, column in (("angle as planted", "angle_deg"), ("standard error as planted", "angle_se_deg")):
        yield {"row": "1", "heading": heading, "from": ("planted/rows.csv", {"row_id": "1"}, column)}


def gaps():
    for number in ("1", "2"):
        for heading, column in (("plants", "plants"), ("missing", "missing"), ("spacing", "spacing_m")):
            yield {"row": number, "heading": heading, "from": ("found/rows.csv", {"row_id": number}, column)}
    for row, number in (("1", "2"), ("2", "7")):
        for heading, folder in (("computed", "found"), ("planted", "field")):
            for axis in ("x", "y"):
                yield {"row": f"row {row}, number {number}", "heading": f"{axis}, {heading}", "from": (f"{folder}/plants.csv", {"row_id": row, "number": number}, f"{axis}_m")}
    for row, folder in (("of row 2 alone", "alone"), ("of both rows together", "together"), ("given", "given")):
        for heading, column in (("taken", "spacing_m"), ("missing in row 2", "missing")):
            yield {"row": row, "heading": heading, "from": (f"{folder}/rows.csv", {"row_id": "2"}, column)}
    halved = ("plants", "missing", "in no row"), (("found", "halved"), ("1.2 m", "halved_given"))
    blind = ("trees in rows", "gaps"), (("5 and more (as it comes)", "found"), ("30 and more", "blind"), ("40 and more", "blinder"))
    broken = ("plants in rows", "missing trees", "trees in no row"), (("6 (as it comes)", "together"), ("1", "broken"))
    for headings, runs in (halved, blind, broken):
        for row, folder in runs:
            for heading, name in zip(headings, ("rows.plants", "rows.missing", "rows.strays")):
                yield {"row": row, "heading": heading, "from": (f"{folder}/summary.json", name)}


def loops():
    measures = (("error of the path, RMSE", "evaluate.ate_rmse", 100), ("largest error", "evaluate.ate_max", 100),
                ("two passes of a trunk apart (median)", "check.stem_pass_spread", 1), ("thickness of the bark in the map", "check.wall", 1),
                ("DBH bias", "evaluate.dbh_bias", 1), ("DBH RMSE", "evaluate.dbh_rmse", 1))
    by_hand = (("error of the path", "evaluate.ate_rmse", 1), ("trees at their place", "evaluate.matched", 1),
               ("a trunk in two passes, apart", "check.stem_pass_spread", 1))
    for of, runs in ((measures, (("none", "open"), ("9", "closed"))), (by_hand, (("nothing", "closed"), ("59 and 339", "wrong")))):
        for row, folder in runs:
            for heading, name, factor in of:
                yield {"row": row, "heading": heading, "from": (f"{folder}/summary.json", name), "factor": factor}
    for first, second, found_by in (("59", "339", "context"), ("0", "355", "odometry"), ("35", "372", "odometry")):
        where = {"from_frame": first, "to_frame": second, "found_by": found_by}
        for heading, column in (("share of points that agree", "overlap"), ("correction", "correction_m")):
            yield {"row": f"{first} and {second}", "heading": heading, "from": ("closed/loop_candidates.csv", where, column)}


NUMBERS = {
    "why-sample-plots-differ": list(samples()),
    "why-a-row-has-no-exact-direction": list(rows()),
    "why-a-gap-is-computed": list(gaps()),
    "why-a-walk-drifts-and-loops-help": list(loops()),
}
