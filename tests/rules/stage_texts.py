"""Every sentence that stages tell: findings, warnings, messages, progress and errors, with %1, %2 ... for what is
inserted.

    python3 tests/rules/stage_texts.py          lists them with the line that tells them
"""

import pathlib
import re
import sys

from cpp_texts import MOST_TEXTS, Source, split, tokens_of

PLACE = "\x00"  # of an inserted value, in a text
ROOT = pathlib.Path(__file__).resolve().parents[2]
LISTS = re.compile(r"warnings_?|damage_?|told|left_out")  # what is put into them is told later
HELD = {  # members whose text is told later
    "message", "warning", "stopped", "why", "lost", "note", "evidence", "unknown", "assumed_size", "rejected", "error",
}
REFUSALS = {"bad_input", "failure"}  # what was found, what was needed, what to do
# Of these files only programs see errors: results that were stored, and data from Python and ParaView.
FOR_PROGRAMS = re.compile(r"modules/(?:cloud/serialize|pipeline/report_json|vtkbridge/(?:grid_and_path_conversion|result_cache))\.cpp")
# Texts that stand in tables of the code: units, and edits (those with an underscore stay names).
IN_TABLES = {
    "modules/stems/core/edits/stem_edits.cpp": [
        "add", "delete", "move", "resize", "split", "merge", "accept", "reject", "note", "tilt",
    ],
    "modules/io/core/formats.cpp": [
        "a scan", "a point cloud", "a table", "a track", "a trajectory", "a folder of views",
        "a compressed archive", "Unpack it first", "an HDF5 file", "Export it as LAS or PLY",
    ],
    "modules/io/core/scan_format_rows.cpp": [
        "Ouster capture", "Hesai capture", "Velodyne capture", "ROS 1 bag", "ROS 2 bag", "folder of a ROS 2 bag",
        "folder of frames", "KITTI frame",
    ],
    "modules/plant/core/edits/plant_edits.cpp": ["assign"],
    "modules/rows/core/edits/row_edits.cpp": ["renumber"],
    "modules/slam/core/edits/loop_edits.cpp": ["refuse"],
    "modules/evaluation/core/same_plot.cpp": [
        "feet", "centimetres", "millimetres", "metres", "inches", "metres, the other list in feet",
        "metres, the other list in centimetres", "centimetres, those of the other list in millimetres",
        "centimetres, those of the other list in inches",
    ],
}
# Figures are called by the first argument of `add`, or by a member; progress says which is drawn.
FIGURES = {"modules/report/survey_figures.cpp", "modules/report/compare/compare_figures.cpp"}
NO_WORDS = {"Livox", "unit", "up", f"--set {PLACE}"}  # names, also of options
FILE = re.compile(r"tum_freiburg|<.*|(?:, )?[\w%./*-]*(?:\.(?:mp4|csv|html|json|tum|ply|xlsx|gpkg|geojson|laz|las|tif)|/|changed-[%\d-]*)")
UNITS = set("m mm cm km ms min deg mrad rad px pixel Hz kHz MHz MiB GiB KiB MB GB ha kg th nd st dB ppm".split())
WORDS = {"both", "degrees", "empty", "fewer", "metres", "millimetres", "numbers", "one", "some"}  # alone, and no names
NUMBERS = {"number_text", "option_text", "limit_text"}
HTML = "modules/report/core/"  # the texts of the page that a report is
SHARED = {"base", "camera", "cloud", "geo"}  # modules whose functions all others call
DEPTH = 6  # of functions and variables that are followed


def plain(template):
    return template.replace(PLACE, "")


def has_words(template):
    return any(w not in UNITS for w in re.findall(r"[A-Za-z]{2,}", plain(template)))


def numbered(template):
    """PLACE, PLACE -> %1, %2; two without a text between are one."""
    count = 0
    out = ""
    for i, part in enumerate(re.split(PLACE + "+", template)):
        if i > 0:
            count += 1
            out += f"%{count}"
        out += part
    return out


class Texts:
    def __init__(self, sources):
        self.sources = sources
        self.found = {}  # text: place
        self.unread = []  # (place, expression) of what is told and holds no text that could be read
        self.refusing = False  # the text in hand is that of an error
        self.by_name = {}
        self.memory = {}
        for source in sources:
            for function in source.functions:
                self.by_name.setdefault(function.name, []).append((source, function))

    def told(self):
        for source in self.sources:
            for place, argument in roots(source):
                self.refusing = source.tokens[place].text in REFUSALS
                texts = self.texts(source, place, argument, DEPTH)
                self.add(source, place, texts)
                if not any(has_words(text) for text in texts) and not self.refusing and not self.is_a_known_call(argument):
                    self.unread.append((f"{source.path}:{source.tokens[place].line}", argument))
            for text in IN_TABLES.get(source.path, []):
                self.found.setdefault(text, f"{source.path}:1")
        return self.found

    # Its texts are looked up where it returns them.
    def is_a_known_call(self, tokens):
        return call_of(tokens)[0] in self.by_name

    def add(self, source, at, texts):
        for text in texts:
            text = text.strip("\n")
            if self.refusing and " " not in text and text not in WORDS:
                continue  # a word alone is the name of a key, an option or a column
            if has_words(text) and not FILE.fullmatch(plain(text)) and text not in NO_WORDS:
                self.found.setdefault(numbered(text), f"{source.path}:{source.tokens[at].line}")

    # All texts of an expression, with PLACE for what is inserted.
    def texts(self, source, at, tokens, depth):
        tokens = unwrapped(tokens)
        if not tokens or depth == 0:
            return [PLACE]
        question = split(tokens, "?")
        if len(question) > 1:
            rest = tokens[len(question[0]) + 1 :]
            first, second = split_choice(rest)
            return self.merged([self.texts(source, at, first, depth), self.texts(source, at, second, depth)])
        if any(t.is_op("<", ">", "==", "!=", "&&", "||", "<=", ">=") for t in top(tokens)):
            return [PLACE]
        terms = split(tokens, "+")
        if len(terms) > 1 and all(terms):
            return self.joined(source, at, [self.texts(source, at, term, depth) for term in terms])
        if all(t.kind == "str" for t in tokens):
            return ["".join(t.text for t in tokens)]
        name, arguments = call_of(tokens)
        if name == "format" and arguments:
            return self.formatted(source, at, arguments, depth)
        if name == "plural" and len(arguments) == 2:
            for noun in self.texts(source, at, arguments[1], depth):
                self.add(source, at, [PLACE + " " + noun, PLACE + " " + noun + "s"])
            return [PLACE]
        if name in {"string", "move", "string_view", "c_str"} and arguments and len(arguments) == 1:
            return self.texts(source, at, arguments[0], depth)
        if name is not None:
            return self.returned(source, at, name, depth, any(t.is_op(".", "->") for t in top(tokens)))
        if len(tokens) == 1 and tokens[0].kind == "id":
            return self.variable(source, at, tokens[0].text, depth)
        return [PLACE]

    def merged(self, lists):
        return list(dict.fromkeys(text for texts in lists for text in texts))

    # Texts one behind the other. Where there are too many ways, what varies becomes an inserted text with its own words.
    def joined(self, source, at, parts):
        ways = 1
        for part in parts:
            ways *= len(part)
        while ways > MOST_TEXTS:
            widest = max(range(len(parts)), key=lambda i: len(parts[i]))
            self.add(source, at, parts[widest])
            ways //= len(parts[widest])
            parts[widest] = [PLACE]
        texts = [""]
        for part in parts:
            texts = [text + more for text in texts for more in part]
        return texts

    def formatted(self, source, at, arguments, depth):
        if not all(t.kind == "str" for t in arguments[0]):
            return [PLACE]
        form = "".join(t.text for t in arguments[0]).replace("{{", "\x01").replace("}}", "\x02")
        parts, taken, end = [], 0, 0
        for hole in re.finditer(r"\{(\d*)(?::[^{}]*(?:\{\}[^{}]*)*)?\}", form):
            parts.append([form[end : hole.start()]])
            index = int(hole.group(1)) if hole.group(1) else taken
            taken += 1
            values = [PLACE]
            if ":" not in hole.group() and index + 1 < len(arguments):
                values = self.texts(source, at, arguments[index + 1], depth)
            parts.append(values)
            end = hole.end()
        parts.append([form[end:]])
        texts = self.joined(source, at, parts)
        return [text.replace("\x01", "{").replace("\x02", "}") for text in texts]

    # A function that returns a text: its texts are inserted, with words of their own.
    def returned(self, source, at, name, depth, of_an_object):
        if name in NUMBERS:
            return [PLACE]
        key = (name, source.path, self.refusing)
        if key in self.memory:
            return self.memory[key]
        self.memory[key] = [PLACE]
        own = [(s, f) for s, f in self.by_name.get(name, []) if s is source]
        anywhere = [(s, f) for s, f in self.by_name.get(name, []) if re.search(r"string|char", f.types)]
        if not of_an_object:
            anywhere = [(s, f) for s, f in anywhere if not f.types.endswith("::")]
        near = own or [(s, f) for s, f in anywhere if s.module in SHARED | {source.module}]
        near = near or (anywhere if len(anywhere) == 1 else [])
        if of_an_object and not own and len(near) != 1:
            return [PLACE]  # whose function this is cannot be told
        for other, function in near:
            for i in range(function.begin, function.end):
                if other.tokens[i].kind == "id" and other.tokens[i].text == "return":
                    end = statement_end(other.tokens, i)
                    self.add(other, i, self.texts(other, i, other.tokens[i + 1 : end], depth - 1))
        return [PLACE]

    # What a variable can hold: the last thing that was put in before this place, and what is added to it.
    def variable(self, source, at, name, depth):
        for function in source.around(at):
            if name in function.parameters:
                return self.passed(source, function, name, depth)
            texts = self.assigned(source, function, at, name, depth)
            if texts is not None:
                return texts
        return self.member(source, name, depth) if name.endswith("_") else self.constant(source, name, depth)

    # `constexpr const char* needed = "...";` outside of functions.
    def constant(self, source, name, depth):
        tokens = source.tokens
        for i in range(1, len(tokens) - 1):
            if tokens[i].kind == "id" and tokens[i].text == name and tokens[i + 1].is_op("=") and not source.around(i):
                return self.texts(source, i, tokens[i + 2 : statement_end(tokens, i)], depth - 1)
        return [PLACE]

    # What any function of the module puts into a member: inserted, with words of its own.
    def member(self, source, name, depth):
        key = (name, source.module, self.refusing)
        if key not in self.memory:
            self.memory[key] = [PLACE]
            for other in self.sources:
                if other.module != source.module:
                    continue
                tokens = other.tokens
                for i in range(1, len(tokens) - 1):
                    if tokens[i].text == name and tokens[i].kind == "id" and tokens[i + 1].is_op("=", "+="):
                        self.add(other, i, self.texts(other, i, tokens[i + 2 : statement_end(tokens, i)], depth - 1))
        return self.memory[key]

    def assigned(self, source, function, at, name, depth):
        tokens, texts, added = source.tokens, None, False
        i = function.begin
        while i < at:
            if tokens[i].kind == "id" and tokens[i].text == name and not tokens[i - 1].is_op(".", "->", "::"):
                ahead = tokens[i + 1]
                end = statement_end(tokens, i)
                if ahead.is_op("=") and end < at:
                    more = self.texts(source, i, tokens[i + 2 : end], depth - 1)
                    declared = tokens[i - 1].is_op("&", "*") or tokens[i - 1].kind == "id" and tokens[i - 1].text != "else"
                    texts = more if declared or texts is None else self.merged([texts, more])
                    i = end
                elif ahead.is_op("+=") and end < at:
                    self.add(source, i, self.texts(source, i, tokens[i + 2 : end], depth - 1))
                    added = True
                elif tokens[i - 1].kind == "id" and tokens[i - 1].text == "string" and ahead.is_op(";"):
                    texts = [""]
            i += 1
        if added:
            self.add(source, at, [text + more for text in texts or [] if text for more in ("", PLACE)])
            return [PLACE]
        return texts and ([text for text in texts if text] or [PLACE])

    def passed(self, source, function, name, depth):
        key = (source.path, function.name, name, self.refusing)
        if key in self.memory:
            return self.memory[key]
        self.memory[key] = [PLACE]
        index = function.parameters.index(name)
        lists = []
        for other in self.sources:
            if other.module != source.module or HTML in other.path:
                continue
            for at, arguments in other.calls(function.name):
                if index < len(arguments) <= len(function.parameters):
                    lists.append(self.texts(other, at, arguments[index], depth - 1))
                    self.add(other, at, lists[-1])
        texts = self.merged(lists) if lists else [PLACE]
        self.memory[key] = texts if len(texts) <= 4 and all(PLACE not in t for t in texts) else [PLACE]
        if PLACE in texts or len(texts) > 4:
            self.memory[key] = [PLACE]
        return self.memory[key]


def unwrapped(tokens):
    while len(tokens) > 1 and tokens[0].is_op("(") and tokens[-1].is_op(")") and len(split(tokens, ",")) == 1:
        depth = 0
        for i, token in enumerate(tokens):
            if token.kind == "op":
                depth += token.text == "("
                depth -= token.text == ")"
            if depth == 0 and i < len(tokens) - 1:
                return tokens
        tokens = tokens[1:-1]
    return tokens


def top(tokens):
    depth = 0
    for token in tokens:
        if token.kind == "op" and token.text in "([{":
            depth += 1
        if depth == 0:
            yield token
        if token.kind == "op" and token.text in ")]}":
            depth -= 1


# `a : b`, where a may be a choice itself.
def split_choice(tokens):
    depth = choices = 0
    for i, token in enumerate(tokens):
        if token.kind != "op":
            continue
        depth += (token.text in "([{") - (token.text in ")]}")
        if depth == 0 and token.text == "?":
            choices += 1
        if depth == 0 and token.text == ":":
            if choices == 0:
                return tokens[:i], tokens[i + 1 :]
            choices -= 1
    return tokens, []


# `ns::name(arguments)` or `object.name(arguments)`, and nothing behind it.
def call_of(tokens):
    for i, token in enumerate(tokens):
        if token.is_op("(", "{"):
            inside = tokens[i + 1 : -1]
            if i == 0 or tokens[i - 1].kind != "id" or not tokens[-1].is_op(")", "}"):
                return None, None
            if any(t.is_op(".", "->") for t in tokens[:i]):
                return tokens[i - 1].text, split(inside, ",")
            depth = 0
            for k in range(i, len(tokens)):
                if tokens[k].kind == "op":
                    depth += (tokens[k].text in "([{") - (tokens[k].text in ")]}")
                if depth == 0 and k < len(tokens) - 1:
                    return None, None
            return tokens[i - 1].text, split(inside, ",")
    return None, None


def statement_end(tokens, begin):
    depth = 0
    for i in range(begin, len(tokens)):
        if tokens[i].kind == "op":
            if depth == 0 and tokens[i].text in ";)}":
                return i
            if depth == 0 and tokens[i].text == ",":
                return i
            depth += (tokens[i].text in "([{") - (tokens[i].text in ")]}")
    return len(tokens)


def roots(source):
    """(place, tokens of the text) of everything that a stage tells."""
    tokens = source.tokens
    for i in range(2, len(tokens) - 2):
        token = tokens[i]
        member = tokens[i - 1].is_op(".", "->")
        if token.kind != "id":
            continue
        if tokens[i + 1].is_op("=", "+=") and not member and is_given_back(source, i):
            yield i, tokens[i + 2 : statement_end(tokens, i)]
        if source.path in FIGURES and tokens[i + 2].kind == "str" and (token.text, tokens[i + 1].text) in {("add", "("), ("add_one", "("), ("name", "=")}:
            yield i, [tokens[i + 2]]
        if tokens[i + 1].is_op("(", "{"):
            if token.text.endswith("Conflict") and tokens[i - 1].text in {"throw", "return"}:
                yield i, arguments_at(tokens, i)[0]  # becomes a warning
            if token.text in REFUSALS and not FOR_PROGRAMS.fullmatch(source.path):
                yield from ((i, a) for a in arguments_at(tokens, i)[:3] if a)
            if not member:
                continue
            arguments = arguments_at(tokens, i)
            if token.text == "warn" and len(arguments) == 1:
                yield i, arguments[0]
            elif token.text == "report" and len(arguments) == 2 and names_a_text(arguments[1], tokens[i - 2]):  # progress
                yield i, arguments[1]
            elif token.text == "find" and len(arguments) == 3 and any(t.kind == "str" or "code" in t.text for t in arguments[1]):
                yield i, arguments[2]
            elif token.text in {"add", "tell"} and any(names_severity(a) for a in arguments[:2]):
                first = next(k for k, a in enumerate(arguments) if names_severity(a)) + 2
                yield from ((i, a) for a in arguments[first : first + 2 if token.text == "tell" else first + 1])
            elif token.text == "skip" and len(arguments) == 2 and source.module == "survey":
                yield from ((i, a) for a in arguments)
            elif token.text in {"push_back", "emplace_back"} and len(arguments) == 1:
                if LISTS.fullmatch(tokens[i - 2].text):
                    yield i, arguments[0]
                elif names_severity(arguments[0]) and arguments[0][0].is_op("{"):
                    yield i, split(arguments[0][1:-1], ",")[-1]
        elif token.text in HELD and member and tokens[i + 1].is_op("=", "+=") and HTML not in source.path:
            if token.text == "note" and not tokens[i - 2].text.startswith("outcome"):
                continue
            text = tokens[i + 2 : statement_end(tokens, i)]
            if token.text == "error" and source.module != "vtkbridge":
                continue
            if any(t.kind == "str" for t in text) or call_of(text)[0] or token.text == "error":
                yield i, text


def names_severity(tokens):
    return any(t.text == "Severity" for t in tokens)


# A sentence that is put into, or added to, a parameter.
def is_given_back(source, at):
    if source.module in {"base", "documents", "render"} or source.path == "modules/pipeline/printing.cpp" or HTML in source.path:
        return False
    text = source.tokens[at + 2 : statement_end(source.tokens, at)]
    around = source.around(at)
    return any(t.kind == "str" and " " in t.text for t in text) and around and source.tokens[at].text in around[0].parameters


def names_a_text(tokens, of):
    return of.text.startswith("run") or any(t.kind == "str" for t in tokens)


def arguments_at(tokens, name):
    depth = 0
    for i in range(name + 1, len(tokens)):
        if tokens[i].kind == "op":
            depth += (tokens[i].text in "([{") - (tokens[i].text in ")]}")
        if depth == 0:
            return split(tokens[name + 2 : i], ",")
    return []


def sources():
    files = sorted(p for p in (ROOT / "modules").rglob("*") if p.suffix in {".h", ".cpp"})
    return [Source(str(p.relative_to(ROOT)), tokens_of(p.read_text(encoding="utf-8"))) for p in files]


def stage_texts():
    """{text: "file:line" of one place}."""
    return Texts(sources()).told()


if __name__ == "__main__":
    for text, place in sorted(stage_texts().items(), key=lambda item: item[1]):
        sys.stdout.write(f"{place}: {text!r}\n")
