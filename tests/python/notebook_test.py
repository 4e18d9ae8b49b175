#!/usr/bin/env python3
"""Runs the code cells of a notebook in order, without Jupyter; and what holds for all notebooks.

notebook_test.py NAME runs docs/user/notebooks/NAME.ipynb; without a name all of them are looked at.
"""

import ast
import json
import os
import pathlib
import sys
import tempfile
import traceback

TOP = pathlib.Path(__file__).resolve().parents[2]
NOTEBOOKS = TOP / "docs" / "user" / "notebooks"


def cells_of(path):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    if (notebook["nbformat"], bool(notebook["cells"])) != (4, True):
        raise SystemExit(f"{path}: nbformat is {notebook['nbformat']}, {len(notebook['cells'])} cells; needed: 4, some cells")
    return notebook["cells"]


def run(path):
    """As a kernel does: one namespace, the value of the last line of a cell is shown."""
    names = {"__name__": "__main__"}
    for number, cell in enumerate((c for c in cells_of(path) if c["cell_type"] == "code"), 1):
        tree = ast.parse("".join(cell["source"]), f"{path.name}, code cell {number}")
        shown = ast.Expression(tree.body.pop().value) if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        try:
            exec(compile(tree, tree_name := f"{path.name}, code cell {number}", "exec"), names)
            if shown is not None:
                value = eval(compile(shown, tree_name, "eval"), names)
                if value is not None:
                    print(repr(value))
        except Exception:
            traceback.print_exc()
            raise SystemExit(f"{path.name}: code cell {number} of it fails:\n{''.join(cell['source'])}") from None


def look():
    """Every notebook is listed, explained, and kept without outputs."""
    wrong = []
    page = (TOP / "docs" / "user" / "python.md").read_text(encoding="utf-8")
    site = (TOP / "mkdocs.yml").read_text(encoding="utf-8")
    tests = (TOP / "tests" / "python" / "CMakeLists.txt").read_text(encoding="utf-8")
    paths = sorted(NOTEBOOKS.glob("*.ipynb"))
    for path in paths:
        cells = cells_of(path)
        texts = ["".join(c["source"]) for c in cells if c["cell_type"] == "markdown"]
        told = {
            f"docs/user/python.md has no link to notebooks/{path.name}": f"notebooks/{path.name}" in page,
            f"mkdocs.yml does not list user/notebooks/{path.stem}.md": f"user/notebooks/{path.stem}.md" in site,
            f"tests/python/CMakeLists.txt does not run {path.stem}": path.stem in tests,
            "it does not begin with a heading": cells[0]["cell_type"] == "markdown" and texts[0].startswith("# "),
            "it has fewer texts than code cells": len(texts) >= sum(c["cell_type"] == "code" for c in cells),
            "a cell has outputs": not any(c.get("outputs") or c.get("execution_count") for c in cells),
            "it is larger than 30 kB": path.stat().st_size < 30_000,
        }
        wrong += [f"{path.name}: {text}" for text, holds in told.items() if not holds]
    if len(paths) < 3:
        wrong.append(f"{len(paths)} notebooks were found in {NOTEBOOKS}; needed: 3")
    return wrong


if __name__ == "__main__":
    if len(sys.argv) == 1:
        if found := look():
            sys.exit("\n".join(found))
    else:
        with tempfile.TemporaryDirectory(prefix="bole_notebook_") as folder:
            os.chdir(folder)
            run(NOTEBOOKS / f"{sys.argv[1]}.ipynb")
