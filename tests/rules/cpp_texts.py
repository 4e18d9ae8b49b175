"""The texts that C++ code can put into a call, read from the source: "{} of {} frames" becomes "%1 of %2 frames".

A reader of tokens, not a compiler: it follows local variables, parameters to the calls of their function, and functions
that return texts, and takes everything else for a name or number that is inserted."""

import dataclasses
import re

TOKEN = re.compile(
    r"""(?P<skip>\s+|//[^\n]*|/\*.*?\*/|\#(?:\\\n|[^\n])*)
      |(?P<raw>(?:u8|[LuU])?R"(?P<mark>[^()\s]*)\((?P<body>.*?)\)(?P=mark)")
      |(?P<str>(?:u8|[LuU])?"(?:\\.|[^"\\])*")
      |(?P<chr>'(?:\\.|[^'\\])+')
      |(?P<num>\.?\d(?:[\w.']|[eEpP][+-])*)
      |(?P<id>[A-Za-z_]\w*)
      |(?P<op>::|->|\+\+|--|\+=|-=|==|!=|<=|>=|&&|\|\||<<|.)""",
    re.X | re.S,
)
ESCAPE = {"n": "\n", "t": "\t", "\\": "\\", '"': '"', "'": "'", "0": "\0"}
OPEN, CLOSE = {"(", "[", "{"}, {")", "]", "}"}
MOST_TEXTS = 12  # of one expression; with more, what differs is looked up by itself


@dataclasses.dataclass(frozen=True)
class Token:
    kind: str
    text: str
    line: int

    def is_op(self, *texts):
        return self.kind == "op" and self.text in texts


def tokens_of(code):
    tokens, line = [], 1
    for match in TOKEN.finditer(code):
        kind = next(k for k in ("skip", "raw", "str", "chr", "num", "id", "op") if match.group(k) is not None)
        if kind == "raw":
            tokens.append(Token("str", match.group("body"), line))
        elif kind == "str":
            body = match.group("str")
            body = body[body.index('"') + 1 : -1]
            tokens.append(Token("str", re.sub(r"\\(.)", lambda m: ESCAPE.get(m.group(1), m.group(1)), body), line))
        elif kind != "skip":
            tokens.append(Token(kind, match.group(), line))
        line += match.group().count("\n")
    return tokens


def split(tokens, separator):
    """The parts between separators that stand in no brackets. A comma in `<int, double>` is taken for none."""
    parts, depth, angle = [[]], 0, 0
    for i, token in enumerate(tokens):
        if token.kind == "op":
            depth += (token.text in OPEN) - (token.text in CLOSE)
            if token.text == "<" and i > 0 and tokens[i - 1].text in TEMPLATES:
                angle += 1
            elif token.text == ">" and angle > 0:
                angle -= 1
        if depth == 0 and angle == 0 and token.is_op(separator):
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


TEMPLATES = {"vector", "map", "pair", "optional", "array", "function", "span", "static_cast", "tuple", "get", "set", "to_string_view"}


def closing(tokens, begin):
    """Where the bracket at `begin` closes."""
    depth = 0
    for i in range(begin, len(tokens)):
        if tokens[i].kind == "op":
            depth += (tokens[i].text in OPEN) - (tokens[i].text in CLOSE)
            if depth == 0:
                return i
    return len(tokens) - 1


@dataclasses.dataclass
class Function:
    name: str
    parameters: list
    types: str  # what stands before the name
    begin: int  # of the body
    end: int
    head: int  # of the parameters


QUALIFIERS = {"const", "noexcept", "override", "final", "mutable"}


def functions_of(tokens):
    found = []
    for i, token in enumerate(tokens):
        if not token.is_op("{") or i == 0:
            continue
        j = i - 1
        while j > 0 and (tokens[j].kind == "id" and tokens[j].text in QUALIFIERS):
            j -= 1
        back = j  # a type behind `->`, or the initialisation of members behind `:`
        while back > 0 and i - back < 60 and not tokens[back].is_op("->", ";", "{", "}"):
            back -= 1
        if tokens[back].is_op("->") and tokens[back - 1].is_op(")"):
            j = back - 1
        if not tokens[j].is_op(")"):
            continue
        depth, k = 0, j
        while k >= 0:
            if tokens[k].kind == "op":
                depth += (tokens[k].text in CLOSE) - (tokens[k].text in OPEN)
            if depth == 0:
                break
            k -= 1
        if k <= 0:
            continue
        name = None
        if tokens[k - 1].kind == "id" and tokens[k - 1].text not in {"if", "for", "while", "switch", "catch"}:
            name, before = tokens[k - 1].text, k - 2
        elif tokens[k - 1].is_op("]"):
            m = k - 1
            while m > 0 and not tokens[m].is_op("["):
                m -= 1
            name, before = "", m
            if m > 1 and tokens[m - 1].is_op("=") and tokens[m - 2].kind == "id":
                name, before = tokens[m - 2].text, m - 3
        if name is None:
            continue
        kinds = []
        while before >= 0 and not tokens[before].is_op(";", "{", "}", ")"):
            kinds.append(tokens[before].text)
            before -= 1
        parameters = []
        for parameter in split(tokens[k + 1 : j], ","):
            parameter = split(parameter, "=")[0]
            names = [t.text for t in parameter if t.kind == "id"]
            parameters.append(names[-1] if len(names) > 1 else "")
        found.append(Function(name, parameters, " ".join(reversed(kinds)), i, closing(tokens, i), k))
    return found


@dataclasses.dataclass
class Source:
    path: str
    tokens: list
    functions: list = None

    def __post_init__(self):
        self.functions = functions_of(self.tokens)

    @property
    def module(self):
        return self.path.split("/")[1]

    def around(self, at):
        """Functions around a place, the innermost first."""
        return sorted((f for f in self.functions if f.begin <= at <= f.end), key=lambda f: f.end - f.begin)

    def calls(self, name):
        """(place, arguments) of each call of a function of this name; definitions are no calls."""
        heads = {f.head for f in self.functions}
        for i, token in enumerate(self.tokens[:-1]):
            if token.kind == "id" and token.text == name and self.tokens[i + 1].is_op("(", "{") and i + 1 not in heads:
                end = closing(self.tokens, i + 1)
                yield i, split(self.tokens[i + 2 : end], ",")
