#!/usr/bin/env python3
"""Every picture of the Markdown files has its commands; tests of pictures.py with made-up pictures.

    python3 tests/lesson/pictures_test.py
"""
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import pictures
from links_test import links
from pictures import chunk, frames_of
from run_commands import documents
from update_lessons import SOURCE, LessonError


def shown_pictures():
    """The pictures (PNG) that the Markdown files show or link, but for the golden ones."""
    found = {((SOURCE / document).parent / path).resolve().relative_to(SOURCE)
             for document in documents()
             for _, path, _ in links((SOURCE / document).read_text(encoding="utf-8"))
             if path.endswith(".png")}
    return {str(path) for path in found if path.name != "frame.png"}


class Repository(unittest.TestCase):
    def test_has_commands_for_every_picture_that_is_shown_and_for_no_other(self):
        listed = [picture for _, _, files in pictures.RECIPES for picture in files]
        self.assertEqual(len(listed), len(set(listed)), "a picture is in the list twice")
        self.assertEqual(sorted(listed), sorted(shown_pictures()))

    def test_has_every_picture_of_the_list(self):
        self.assertEqual([picture for _, _, files in pictures.RECIPES for picture in files
                          if not (SOURCE / picture).exists()], [])


def png(*frames):
    """A PNG of one pixel, or an animation: each frame is a grey value."""
    data = [zlib.compress(bytes([0, grey])) for grey in frames]
    chunks = [chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 0, 0, 0, 0))]
    for i, part in enumerate(data):
        if len(data) > 1:
            chunks.append(chunk(b"fcTL", bytes(26)))
        chunks.append(chunk(b"fdAT", bytes(4) + part) if i else chunk(b"IDAT", part))
    return pictures.SIGNATURE + b"".join(chunks) + chunk(b"tEXt", b"a\0b") + chunk(b"IEND", b"")


class Room(unittest.TestCase):
    """A directory with pictures, and with a compare_frames that compares bytes."""

    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.room = pathlib.Path(room.name)
        compare = self.room / "build/tests/frames/compare_frames"
        compare.parent.mkdir(parents=True)
        compare.write_text('#!/bin/sh\ncmp -s "$1" "$2" && exit 0\necho DIFFERENT; exit 1\n')
        compare.chmod(0o755)
        patch = mock.patch.object(pictures, "SOURCE", self.room)
        patch.start()
        self.addCleanup(patch.stop)

    def write(self, name, *frames):
        (self.room / name).write_bytes(png(*frames))
        return self.room / name


class Comparing(Room):
    def difference(self, stored, drawn):
        return pictures.difference(stored, drawn, self.room / "build")

    def test_the_frames_of_an_animation_are_pictures(self):
        two = frames_of(self.write("two.png", 1, 2))
        self.assertEqual(two, [*frames_of(self.write("a.png", 1)), *frames_of(self.write("b.png", 2))])

    def test_a_frame_of_an_animation_that_differs_is_found(self):
        a, b = self.write("a.png", 1, 2), self.write("b.png", 1, 3)
        self.assertEqual(self.difference(a, a), "")
        self.assertEqual(self.difference(a, b), "DIFFERENT")

    def test_a_picture_that_is_absent_or_longer_differs(self):
        a, b = self.write("a.png", 1), self.write("b.png", 1, 1)
        self.assertEqual(self.difference(self.room / "none.png", a), "it is not stored yet")
        self.assertEqual(self.difference(a, b), "1 frames are stored, and 2 are drawn")

    def test_a_file_that_is_no_picture_is_refused(self):
        (self.room / "a.png").write_text("text")
        with self.assertRaisesRegex(LessonError, "a.png is no PNG"):
            frames_of(self.room / "a.png")


class Renewing(Room):
    def setUp(self):
        super().setUp()
        for name, grey in (("old.png", 1), ("new.png", 2), ("time.png", 1)):
            self.write(name, grey)
        copy = f"mkdir out; cp {self.room}/new.png out/a.png; exit 1"
        recipes = (("quick", copy, {"old.png": "out/a.png", "new.png": "out/a.png"}),
                   ("timed", f"{copy} ", {"time.png": "out/a.png"}))
        patch = mock.patch.object(pictures, "RECIPES", recipes)
        patch.start()
        self.addCleanup(patch.stop)

    def renew(self, *names, check=False):
        with mock.patch("builtins.print") as lines:
            differ = pictures.renew(names, self.room / "build", check)
        return differ, [call.args[0] for call in lines.call_args_list]

    def grey(self, name):
        return [grey for grey in range(3) if (self.room / name).read_bytes() == png(grey)][0]

    def test_a_picture_that_differs_is_replaced(self):
        self.assertEqual(self.renew(), (1, ["renewed  old.png: DIFFERENT", "same     new.png"]))
        self.assertEqual(self.grey("old.png"), 2)

    def test_a_check_changes_nothing_and_names_the_repair(self):
        differ, lines = self.renew(check=True)
        self.assertEqual(differ, 1)
        self.assertEqual(lines[0], "differs  old.png: DIFFERENT; renew it by "
                                   "python3 tests/lesson/pictures.py old.png")
        self.assertEqual(self.grey("old.png"), 1)

    def test_a_picture_of_times_is_drawn_only_when_it_is_named(self):
        self.renew()
        self.assertEqual(self.grey("time.png"), 1)
        self.assertEqual(self.renew("time.png"), (1, ["renewed  time.png: DIFFERENT"]))
        self.assertEqual(self.grey("time.png"), 2)

    def test_a_name_that_is_in_no_list_is_refused(self):
        with self.assertRaisesRegex(LessonError, "no command draws x.png"):
            self.renew("old.png", "x.png")

    def test_commands_that_fail_or_draw_nothing_are_faults(self):
        runner = pictures.Runner(self.room / "build")
        self.addCleanup(runner.room.cleanup)
        with self.assertRaisesRegex(LessonError, "(?s)exit code 3.*why"):
            pictures.draw("mkdir out; touch out/a.png; echo why; (exit 3)", ["out/a.png"], runner)
        with self.assertRaisesRegex(LessonError, "out/b.png is missing"):
            pictures.draw("true", ["out/a.png", "out/b.png"], runner)


class CommandLine(unittest.TestCase):
    def test_prints_every_picture_with_its_commands(self):
        text = subprocess.run([sys.executable, pictures.__file__, "--list"], text=True, check=True,
                              stdout=subprocess.PIPE).stdout
        for kind, commands, files in pictures.RECIPES:
            self.assertIn(commands.splitlines()[0], text)
            for picture in files:
                self.assertIn(f"\n{kind:5}  {picture} ", f"\n{text}")


if __name__ == "__main__":
    unittest.main()
