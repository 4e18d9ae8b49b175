"""What mkdocs.yml leaves to the folders: pages of stages, decisions and modules, so that no list of them is kept by hand.

Notebooks become pages of their texts and code. READMEs of modules and programs lie beside their code. In the site they are the pages code/..., and links between them and docs/ are
turned accordingly; links to source files, which the site does not hold, become plain text.
"""

import json
import pathlib
import re

from mkdocs.structure.files import File

TOP = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"(!?)\[([^\]]*)\]\((?!https?:|#|mailto:)([^)\s]+)\)")


def readmes():
    return sorted(p.relative_to(TOP) for top in ("modules", "app") for p in (TOP / top).glob("*/README.md"))


def section(nav, name):
    """The list of pages under a title, at any depth."""
    for entry in nav:
        for title, pages in entry.items() if isinstance(entry, dict) else ():
            if title == name:
                return pages
            found = section(pages, name) if isinstance(pages, list) else None
            if found is not None:
                return found
    return None


def on_config(config):
    for folder, name in (("stages", "Stages"), ("adr", "Decisions")):
        pages = sorted(p.name for p in (TOP / "docs" / folder).glob("*.md") if p.name != "README.md")
        section(config.nav, name).extend(f"{folder}/{page}" for page in pages)
    # A new page for people is in the site before somebody gives it its place in mkdocs.yml.
    listed = repr(config.nav)
    for folder, name in (("user", "Surveying"), ("dev", "Development")):
        pages = (f"{folder}/{p.name}" for p in sorted((TOP / "docs" / folder).glob("*.md")))
        section(config.nav, name).extend(page for page in pages if page not in listed)
    section(config.nav, "Modules").extend({p.parent.name: f"code/{p.as_posix()}"} for p in readmes())
    return config


def notebook_page(path):
    """The cells of a notebook as Markdown, with a link to the notebook itself."""
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    texts = ["".join(cell["source"]) if cell["cell_type"] == "markdown" else "```python\n" + "".join(cell["source"]) + "\n```" for cell in cells]
    return "\n\n".join([texts[0], f"[Download the notebook]({path.name})", *texts[1:]]) + "\n"


def on_files(files, config):
    for p in sorted((TOP / "docs").rglob("*.ipynb")):
        files.append(File.generated(config, p.relative_to(TOP / "docs").with_suffix(".md").as_posix(), content=notebook_page(p)))
    for p in readmes():
        files.append(File.generated(config, f"code/{p.as_posix()}", abs_src_path=str(TOP / p)))
    icon = "resources/icons/hicolor/scalable/apps/bole.svg"
    files.append(File.generated(config, "assets/bole.svg", abs_src_path=str(TOP / icon)))
    return files


def place_in_site(target):
    """Where a file of the repository lies in the site; None when it is not there."""
    if target.is_relative_to(TOP / "docs"):
        return target.relative_to(TOP / "docs")
    if target == TOP / "README.md":
        return pathlib.PurePath("README.md")
    return pathlib.PurePath("code") / target.relative_to(TOP) if target.is_relative_to(TOP) and target.relative_to(TOP) in readmes() else None


def on_page_markdown(markdown, page, **_):
    source = pathlib.PurePosixPath(page.file.src_uri)
    in_repository = TOP / source.relative_to("code") if source.parts[0] == "code" else TOP / "docs" / source

    def turned(found):
        path, hash_sign, anchor = found[3].partition("#")
        target = (in_repository.parent / path).resolve()
        place = place_in_site(target)
        if place is not None:
            up = "../" * (len(source.parts) - 1)
            return f"{found[1]}[{found[2]}]({up}{place.as_posix()}{hash_sign}{anchor})"
        return found[2] if target.exists() else found[0]

    return LINK.sub(turned, markdown)
