#!/usr/bin/env python3
"""What stages tell has its Chinese words in app/desktop/i18n/findings_zh_CN.ts, and that file has no others."""

import re
import unittest
import xml.etree.ElementTree

from cpp_texts import Source, tokens_of
from stage_texts import IN_TABLES, ROOT, Texts, sources

CATALOGUE = ROOT / "app/desktop/i18n/findings_zh_CN.ts"
# Numbers and names of options, columns and files in a text; what a translation must have too.
KEPT = re.compile(r"%\d+|(?<![%\w.])\d+(?:\.\d+)?(?!-D)|\w+=\w+|[a-z0-9]+(?:_[a-z0-9]+)+|\w+\.(?:csv|json|html|txt|ply|yaml)")
# What is told and is made elsewhere, or no text of ours.
FORWARDED = re.compile(r"(?:std::move\()?\w*(?:text|warning|w|what|sentence|advice|problem|told|message|why|reason|error)\)?")
UNREAD = {
    "finding.text": "the finding of a reader, told again",
    "e.finding.text": "likewise",
    "e.what()": "an error, told as a warning",
    "e.found()": "likewise",
    "summary.BriefReport()": "Ceres",
    'j.at("message").get<std::string>()': "read from summary.json",
    "times_.warning": "filled where the times are read",
    'e.run.name+": "+warning': "the warning of an evaluation, told again",
    's.name+": "+text': "a parameter that is followed by itself",
    'text(what)+(remedy.empty()?"":"; "+remedy)': "parameters that are followed by themselves",
    '{"text",told.back()}': "a line of a file",
    'fmt::format(", {}",video_file)': "the name of a file",
    'fmt::format("{0} m x {0} m",usual_plot_width_m)': "numbers",
    "vtk_stage->GetErrorText()": "an error of a stage, told again",
}


def catalogue():
    texts = {}
    for message in xml.etree.ElementTree.parse(CATALOGUE).getroot().iter("message"):
        texts[message.find("source").text] = message.find("translation").text or ""
    return texts


def texts_of(code):
    return Texts([Source("modules/stems/core/some.cpp", tokens_of(code))]).told()


def spelled(tokens):
    return "".join(f'"{t.text}"' if t.kind == "str" else t.text for t in tokens)


class FindingWords(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        texts = Texts(sources())
        cls.told, cls.unread = texts.told(), texts.unread
        cls.chinese = catalogue()

    def test_everything_told_is_translated(self):
        self.assertGreater(len(self.told), 2500)
        missing = [f"{place}: {text!r}" for text, place in sorted(self.told.items()) if not self.chinese.get(text)]
        self.assertEqual(missing, [], "translate in app/desktop/i18n/findings_zh_CN.ts:\n" + "\n".join(missing))

    def test_nothing_is_translated_that_is_not_told(self):
        old = sorted(set(self.chinese) - set(self.told))
        self.assertEqual(old, [], "no stage tells this any more:\n" + "\n".join(old))

    def test_translations_keep_numbers_and_names(self):
        lost = []
        for text, chinese in self.chinese.items():
            lost += [f"{word} in: {chinese}" for word in KEPT.findall(text) if word not in chinese]
            if sorted(re.findall(r"%\d+", text)) != sorted(re.findall(r"%\d+", chinese)):
                lost.append(f"places in: {chinese}")
        self.assertEqual(lost, [], "\n".join(lost))

    def test_translations_are_chinese(self):
        english = [c for c in self.chinese.values() if not re.search(r"[\u4e00-\u9fff]", re.sub(r"^[%\dx ,至]+$", "至", c))]
        self.assertEqual(english, [])

    # A finding whose text the reader cannot follow would miss its translation unseen.
    def test_every_text_can_be_read(self):
        unread = [
            f"{place}: {spelled(tokens)}"
            for place, tokens in self.unread
            if not FORWARDED.fullmatch(spelled(tokens)) and spelled(tokens) not in UNREAD
        ]
        self.assertEqual(unread, [], "\n".join(unread))

    def test_texts_in_tables_are_there(self):
        for path, texts in IN_TABLES.items():
            code = (ROOT / path).read_text(encoding="utf-8")
            for text in texts:
                self.assertIn(f'"{text}', code)


class Reader(unittest.TestCase):
    """The reader finds what a new finding would say."""

    def check(self, code, *texts):
        self.assertEqual(sorted(texts_of(code)), sorted(texts))

    def test_formats(self):
        self.check('void f(Report& r) { r.warn(fmt::format("{} of {:.1f} % are {{bad}}", n, p)); }', "%1 of %2 % are {bad}")

    def test_sums_and_literals_in_lines(self):
        self.check('void f(Report& r) { r.find(Severity::note, "code", "a tree of "\n "wood, " + name(x) + " high"); }', "a tree of wood, %1 high")

    def test_choices(self):
        self.check('void f(Report& r) { r.warn("the tree " + (a > b ? "fell" : c ? "grew" : "stands")); }', "the tree fell", "the tree grew", "the tree stands")

    def test_variables_and_what_is_added(self):
        self.check(
            'void f(Report& r) { std::string text = "some words"; if (a) text += fmt::format(", and {}", b); r.warn(text); }',
            "some words", "some words%1", ", and %1",
        )

    def test_parameters(self):
        self.check('void tell(Report& r, const std::string& what) { r.warn("lost: " + what); }\nvoid g() { tell(r, "the map"); }', "the map", "lost: the map")

    def test_constants_of_a_file(self):
        self.check('constexpr const char* lost = "the map is lost";\nvoid f(Report& r) { r.warn(lost); }', "the map is lost")

    def test_functions(self):
        self.check('std::string why(int n) { if (n) return "too few"; return "too many"; }\nvoid f(Report& r) { r.warn(why(3)); }', "too few", "too many")

    def test_plurals(self):
        self.check('void f(Report& r) { r.warn(plural(n, "packet") + " lost"); }', "%1 packet", "%1 packets", "%1 lost")

    def test_other_calls_tell_nothing(self):
        self.check('void f() { spdlog::warn("for programmers"); const auto it = names.find("some name"); text.find("a b", 3); }')


if __name__ == "__main__":
    unittest.main()
