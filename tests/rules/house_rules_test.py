#!/usr/bin/env python3
"""Rules that keep the house in order: namespaces, private names, sizes of folders, names of bounds, a README for every
module."""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODULES = ROOT / "modules"
SOURCES = {".h", ".cpp", ".cxx"}
# The vocabulary of all others: their namespaces are inline, so that bole::PointCloud is bole::cloud::PointCloud.
INLINE = {"base", "camera", "cloud"}
MOST_SOURCES_IN_A_FOLDER = 40

NAMESPACE = re.compile(r"^(inline )?namespace ([\w:]+) \{", re.M)
NO_CODE = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')
# What base/angles.h and base/statistics.h have already.
OWN_DEGREES = re.compile(r"\bpi(?:_v<\w+>)? */ *180\b|\b180(?:\.0)? */ *std::numbers::pi")
OWN_MEDIAN = re.compile(r"^(?:inline |static )*double median(?:_of)?\(std::vector<double> ", re.M)
# Definitions that begin a line, as clang-format sets what stands in a namespace: type, alias, function, constant.
ALIAS = re.compile(r"^using (\w+) = ([^;]+);", re.M)
PRIVATE = (
    re.compile(r"^(?:struct|class|union|enum(?: class)?) (\w+)", re.M),
    re.compile(r"^(?!using |struct |class |enum |namespace |return )[\w\[][^;={}()]*?[\s*&](\w+)\(", re.M),
    re.compile(r"^(?:inline |static |thread_local )*const(?:expr|init)? [^;=(){}]*?[\s*&](\w+)(?:\[\w*\])?(?: = |\{|;)", re.M),
)
CALLED_BY_LIBRARIES = {"PrintTo"}  # and found by the type of the argument
OLD_BOUND = re.compile(r"\b(?:least|most)_[a-z]\w*|\b[a-z]\w*_(?:min|max)\b")


def modules():
    return sorted(p for p in MODULES.iterdir() if p.is_dir())


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in SOURCES)


def code_of(text):
    """The text without comments and strings."""
    return NO_CODE.sub("", text)


def private_names(text):
    """What the anonymous namespaces of a file define: {name: of an alias what it stands for, else None}."""
    code = re.sub(r"'(?:\\.|[^'\\\n])'", "", code_of(text))
    found = {}
    for begin in re.finditer(r"^namespace \{\n", code, re.M):
        depth = 1
        for end in range(begin.end(), len(code)):
            depth += {"{": 1, "}": -1}.get(code[end], 0)
            if depth == 0:
                break
        block = code[begin.end() : end]
        found.update((name, None) for kind in PRIVATE for name in kind.findall(block))
        found.update(ALIAS.findall(block))
    return found


def shared_private_names(files):
    """Private names that two of these files have, {path: text}. The same alias twice is no second meaning."""
    meanings = {}
    for path, text in sorted(files.items()):
        for name, meaning in private_names(text).items():
            meanings.setdefault(name, []).append((path, meaning))
    return {
        name: [path for path, _ in uses]
        for name, uses in meanings.items()
        if len(uses) > 1 and name not in CALLED_BY_LIBRARIES and (None in (m for _, m in uses) or len({m for _, m in uses}) > 1)
    }


def compiled_with(path):
    """The folder whose files are compiled together with this one (bole_unity() in resources/cmake)."""
    return pathlib.Path(*path.parts[:3]) if path.parts[:2] == ("app", "desktop") and len(path.parts) > 3 else path.parent


def foreign_namespaces(module, text):
    """Namespaces that a file of a module opens at the top level and that are not its own."""
    own = f"bole::{module}"
    found = []
    for line in NAMESPACE.finditer(code_of(text)):
        inline, name = line.groups()
        if name == "bole" or inline or "=" in line.group(0):
            continue  # `namespace bole {` holds the inline namespaces of base, camera and cloud, and forward declarations
        if name.startswith("bole") and name != own and not name.startswith(own + "::"):
            found.append(name)
    return found


def forward_declarations_only(name, text):
    """Whether a block of another module's namespace only announces types."""
    block = re.search(rf"namespace {re.escape(name)} \{{\n(.*?)\n\}}", text, re.S)
    return block is not None and all(re.fullmatch(r"\s*((class|struct) \w+;.*)?", line) for line in block.group(1).splitlines())


class House(unittest.TestCase):
    def test_every_module_lives_in_its_namespace(self):
        found = []
        for module in modules():
            for p in sources(module):
                text = p.read_text(encoding="utf-8", errors="replace")
                for name in foreign_namespaces(module.name, text):
                    if not forward_declarations_only(name, text):
                        found.append(f"{p.relative_to(ROOT)} opens namespace {name}")
                if module.name not in INLINE and re.search(r"^namespace bole \{\n(?!inline namespace)", text, re.M):
                    found.append(f"{p.relative_to(ROOT)} declares in bole itself")
        self.assertEqual(found, [], "\n".join(found))

    def test_folders_stay_small(self):
        found = []
        for top in ("app", "modules", "tests"):
            folders = {p.parent for p in sources(ROOT / top)}
            for folder in sorted(folders):
                count = sum(1 for p in folder.iterdir() if p.suffix in SOURCES)
                if count > MOST_SOURCES_IN_A_FOLDER:
                    found.append(f"{folder.relative_to(ROOT)}: {count} sources")
        self.assertEqual(found, [], "give each purpose a folder")

    def test_private_names_differ_within_a_folder(self):
        found = []
        groups = {}
        for path in (p for top in ("app", "modules", "tests/modules") for p in sources(ROOT / top) if p.suffix == ".cpp"):
            groups.setdefault(compiled_with(path.relative_to(ROOT)), []).append(path)
        for folder, paths in sorted(groups.items()):
            files = {str(p.relative_to(ROOT / folder)): p.read_text(encoding="utf-8") for p in paths}
            for name, where in sorted(shared_private_names(files).items()):
                found.append(f"{folder}: {name} in {', '.join(where)}")
        self.assertEqual(found, [], "share what is the same, else give each a name that tells them apart:\n" + "\n".join(found))

    def test_bounds_are_named_min_and_max(self):
        found = {}
        for top in ("app", "modules"):
            for p in sources(ROOT / top):
                names = set(OLD_BOUND.findall(code_of(p.read_text(encoding="utf-8", errors="replace"))))
                if names:
                    found[str(p.relative_to(ROOT))] = sorted(names)
        self.assertEqual(found, {}, "a lower bound is min_x, an upper bound max_x")

    def test_degrees_and_medians_are_those_of_base(self):
        found = []
        for top in ("app", "modules"):
            for p in sources(ROOT / top):
                text = code_of(p.read_text(encoding="utf-8", errors="replace"))
                if p.parent.name == "base":
                    continue
                if OWN_DEGREES.search(text):
                    found.append(f"{p.relative_to(ROOT)} turns degrees by itself: base/angles.h")
                if OWN_MEDIAN.search(text):
                    found.append(f"{p.relative_to(ROOT)} has a median of its own: base/statistics.h")
        self.assertEqual(found, [], "\n".join(found))

    def test_every_module_has_a_readme_that_names_its_folders(self):
        found = []
        for module in modules():
            readme = module / "README.md"
            if not readme.exists():
                found.append(f"{module.name} has no README.md")
                continue
            text = readme.read_text(encoding="utf-8")
            core = module / "core"
            for folder in sorted(p for p in core.iterdir() if p.is_dir()) if core.is_dir() else []:
                if not re.search(rf"core/{folder.name}\b|\b{folder.name}/", text):
                    found.append(f"modules/{module.name}/README.md does not name core/{folder.name}/")
        self.assertEqual(found, [], "\n".join(found))

    def test_the_rules_can_fail(self):
        self.assertEqual(foreign_namespaces("io", "namespace bole::slam {\n"), ["bole::slam"])
        self.assertEqual(foreign_namespaces("io", "namespace bole::io::las {\nnamespace bole::io {\n"), [])
        one = "namespace {\nusing Json = a::b;\nstruct Row {\n  int size() const;\n};\nint sum_of(const Row& r) {\n  return r;\n}\n"
        one += "constexpr double step_m = 0.5;  // and more\ntemplate <class T>\nvoid put(T& t, char c = '}');\n}  // namespace\n"
        self.assertEqual(private_names(one + "int seen();\n"), {"Json": "a::b", "Row": None, "sum_of": None, "step_m": None, "put": None})
        self.assertEqual(shared_private_names({"a": one, "b": "namespace {\nusing Json = a::b;\nint step = 1;\n}\nint put();\n"}), {})
        self.assertEqual(shared_private_names({"a": one, "b": "namespace {\nusing Json = c;\n}\n"}), {"Json": ["a", "b"]})
        self.assertEqual(shared_private_names({"a": one, "b": "namespace {\nbool sum_of(int a);\n}\n"}), {"sum_of": ["a", "b"]})
        self.assertEqual(OLD_BOUND.findall("least_points + range_min + max_range + min_x"), ["least_points", "range_min"])
        self.assertTrue(OWN_DEGREES.search("angle * std::numbers::pi / 180;") and OWN_DEGREES.search("x * 180.0 / std::numbers::pi"))
        self.assertFalse(OWN_DEGREES.search("std::numbers::pi / 18000") or OWN_DEGREES.search("2 * std::numbers::pi / 36"))
        self.assertTrue(OWN_MEDIAN.search("namespace {\ndouble median(std::vector<double> values) {"))
        self.assertTrue(forward_declarations_only("bole::x", "namespace bole::x {\nstruct A;\n}\n"))
        self.assertFalse(forward_declarations_only("bole::x", "namespace bole::x {\nint f();\n}\n"))


if __name__ == "__main__":
    sys.exit(unittest.main())
