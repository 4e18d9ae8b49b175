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


NUMBERS = {"why-sample-plots-differ": list(samples()), "why-a-row-has-no-exact-direction": list(rows())}
