#!/usr/bin/env python3
"""Every link inside the repository's Markdown files leads to a file and to a heading that exist.

    python3 tests/lesson/links_test.py
"""
import collections
import pathlib
import re
import sys
import unicodedata
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from run_commands import documents, without_comments
from update_lessons import SOURCE

LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)")
WEB = re.compile(r"\w+:")
FENCE = re.compile(r"^ *```.*?^ *```", re.S | re.M)
INDENTED = re.compile(r"^ {4}.*", re.M)
SPAN = re.compile(r"`[^`]*`")
HEADING = re.compile(r"^#{1,6} +(.+?)(?: +#+)? *$", re.M)


def blank(pattern, text):
    """Without what the pattern matches, but with as many lines."""
    return pattern.sub(lambda match: "\n" * match[0].count("\n"), text)


def without_blocks(text):
    """The text without its comments and its blocks of code."""
    return blank(FENCE, without_comments(text))


def is_kept(character):
    """Letters with their marks, decimal digits, connectors such as _, hyphens and spaces."""
    category = unicodedata.category(character)
    return category[0] in "LM" or category in ("Nd", "Pc") or character in "- "


def anchor(heading):
    """The anchor that GitHub gives to a heading."""
    shown = re.sub(r"!?\[([^]]*)\]\([^)]*\)", r"\1", heading)
    return "".join(filter(is_kept, shown.lower())).replace(" ", "-")


def anchors(text):
    """The anchors of a Markdown text. The second of two equal headings ends with -1."""
    found = set()
    seen = collections.Counter()
    for match in HEADING.finditer(without_blocks(text)):
        name = anchor(match[1])
        found.add(f"{name}-{seen[name]}" if seen[name] else name)
        seen[name] += 1
    return found


def links(text):
    """(line, path, anchor) of each link and picture inside the repository; "" where one is absent."""
    text = blank(SPAN, blank(INDENTED, without_blocks(text)))
    for match in LINK.finditer(text):
        if not WEB.match(match[1]):
            yield text.count("\n", 0, match.start()) + 1, match[1], match[2] or ""


def fault(document, path, heading, root=SOURCE):
    """What is wrong with a link that stands in a document: one line, or "" if nothing is."""
    target = (document.parent / path).resolve() if path else document
    if not target.is_relative_to(root) or not target.exists():
        return f"there is no file {path}"
    if not heading:
        return ""
    if target.suffix != ".md":
        return f"{path} is no Markdown file and has no heading #{heading}"
    there = anchors(target.read_text(encoding="utf-8"))
    return "" if heading in there else f"{path or 'this file'} has no heading #{heading}"


class Anchor(unittest.TestCase):
    def test_is_lower_case_with_hyphens_and_without_punctuation(self):
        self.assertEqual(anchor("Which stiffness?"), "which-stiffness")
        self.assertEqual(anchor("What a run is worth: `--explain`"), "what-a-run-is-worth---explain")
        self.assertEqual(anchor("Part 2, continued: *one* `w_u`"), "part-2-continued-one-w_u")

    def test_keeps_letters_of_all_languages_and_no_other_signs(self):
        self.assertEqual(anchor("Übung Ω – 10⁻³ · m²"), "übung-ω--10--m")

    def test_of_a_link_is_that_of_its_words(self):
        self.assertEqual(anchor("See [the step](time_step.h) 1"), "see-the-step-1")

    def test_of_equal_headings_is_numbered(self):
        self.assertEqual(anchors("# A\n\n## B\n\n## A\n\n## A\n"), {"a", "b", "a-1", "a-2"})

    def test_is_found_outside_of_code_and_comments(self):
        self.assertEqual(anchors("```sh\n# a\n```\n<!-- # b -->\n# c ##\n"), {"c"})


class Link(unittest.TestCase):
    def test_is_found_with_its_line(self):
        text = "[a](b.md#c)\n![d\ne](f.png) and [g](#h)\n[i](https://j.org/k#l)\n"
        self.assertEqual(list(links(text)), [(1, "b.md", "c"), (3, "f.png", ""), (3, "", "h")])

    def test_is_not_found_in_code(self):
        text = "```cpp\n[](a)\n```\n    [](b)\n`[](c)`\n<!-- [](d) -->\n[](e)\n"
        self.assertEqual(list(links(text)), [(7, "e", "")])

    def test_that_leads_nowhere_is_a_fault(self):
        readme = SOURCE / "README.md"
        self.assertEqual(fault(readme, "common/README.md", "symbols"), "")
        self.assertEqual(fault(readme, "common/math", ""), "")
        self.assertEqual(fault(readme, "common/READYOU.md", ""), "there is no file common/READYOU.md")
        self.assertEqual(fault(readme, "..", ""), "there is no file ..")
        self.assertEqual(fault(readme, "", "nowhere"), "this file has no heading #nowhere")
        self.assertEqual(fault(readme, "common/README.md", "Symbols"),
                         "common/README.md has no heading #Symbols")
        self.assertEqual(fault(readme, "LICENSE", "mit"),
                         "LICENSE is no Markdown file and has no heading #mit")


class Repository(unittest.TestCase):
    def test_has_no_link_that_leads_nowhere(self):
        found = [(path, line, fault(SOURCE / path, file, heading)) for path in documents()
                 for line, file, heading in links((SOURCE / path).read_text(encoding="utf-8"))]
        self.assertGreater(len(found), 100)
        faults = [f"{path}:{line}: {what}" for path, line, what in found if what]
        self.assertEqual(faults, [])


if __name__ == "__main__":
    unittest.main()
