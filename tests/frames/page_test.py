#!/usr/bin/env python3
"""Tests of the pages, in Chromium: page_test.py COMPARE_RUNS GALLERY_PAGE SOURCE [TEST…].

Exit code 77: Chromium is not installed, and what can be tested without it has passed.

The runs are made up. A picture has one colour, which says its run and its frame.
"""
import base64
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
import browser

COMPARE_RUNS, GALLERY_PAGE, SOURCE = map(pathlib.Path, sys.argv[1:4])
RED, BLUE = (200, 0, 0), (0, 0, 200)  # of run A and of run B, in frame 0
HOSTILE = "a \"b\" <i>c <script> & 'd' %20"


# --- pictures and runs

def png(width, height, colour):
    """The bytes of a picture of one colour."""
    def chunk(kind, data):
        checksum = zlib.crc32(kind + data)
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", checksum)

    rows = (b"\0" + bytes(colour) * width) * height
    size = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size)
            + chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b""))


def first_pixel(picture):
    """The colour of the first pixel of a PNG. No filter changes it: its neighbours count as 0."""
    data = b"".join(picture[at + 8:at + 8 + length] for at, length in chunks(picture, b"IDAT"))
    return tuple(zlib.decompress(data)[1:4])


def chunks(picture, kind):
    at = 8
    while at < len(picture):
        length = struct.unpack(">I", picture[at:at + 4])[0]
        if picture[at + 4:at + 8] == kind:
            yield at, length
        at += length + 12


def colour_of(base, number):
    """10 brighter in green with each frame: the pages are asked for these colours."""
    return base[0], 10 * number, base[2]


def make_run(directory, base, frames=5, h=0.01, still=(), program="step03_implicit"):
    """`still`: the frames whose picture is that of A."""
    directory.mkdir(parents=True)
    rows = ["frame,time,total,elastic,max_stretch,lowest,iterations"]
    for number in range(frames):
        time, lowest = number / 10, -number / 10
        rows.append(f"{number},{time},{-number},{number},1.{number},{lowest},{3 * number}")
        colour = colour_of(RED if number in still else base, number)
        (directory / f"frame_{number:04}.png").write_bytes(png(64, 36, colour))
    (directory / "log.csv").write_text("\n".join(rows) + "\n")
    (directory / "run.toml").write_text(f"[run]\nprogram = '{program}'\n[time]\nh = {h}\n")
    return directory


def report(html, *runs):
    """compare_runs --html; gives its exit code."""
    done = compare(*runs, "--html", html)
    assert done.stderr == "", done.stderr
    return done.returncode


def compare(*arguments):
    return subprocess.run([COMPARE_RUNS, *arguments], capture_output=True, text=True, check=False)


DATA = re.compile(r'(?<=<script type="application/json" id="data">).*?(?=</script>)', re.DOTALL)


def data_of(page):
    return json.loads(DATA.search(page)[0])


def with_data(html, change):
    """The same page with other data: change(data) changes them."""
    page = html.read_text()
    data = data_of(page)
    change(data)
    text = json.dumps(data).replace("<", "\\u003c")
    html.write_text(DATA.sub(lambda _: text, page))


# --- what the page shows

class PageTest(unittest.TestCase):
    """Chromium, and a fresh directory. No page may complain, or ask for anything but files."""

    @classmethod
    def setUpClass(cls):
        cls.profile = cls.enterClassContext(tempfile.TemporaryDirectory())
        cls.browser = cls.enterClassContext(browser.Browser(cls.profile, "--window-size=1000,900"))

    def setUp(self):
        self.directory = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.page = self.browser
        self.page.open(SOURCE / "LICENSE")
        self.forget_the_logs()
        self.addCleanup(self.expect_a_quiet_page)

    def forget_the_logs(self):
        for kind in ("browser", "performance"):
            self.page.log(kind)

    def expect_a_quiet_page(self):
        self.assertEqual([entry["message"] for entry in self.page.log("browser")], [])
        for entry in self.page.log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                address = message["params"]["request"]["url"]
                self.assertRegex(address, r"^(file:///|data:)", "a request leaves")

    def open_report(self, *runs, html="report.html", change=None):
        html = self.directory / html
        code = report(html, *runs)
        if change:
            with_data(html, change)
        self.page.open(html)
        self.wait_for_pictures()
        return code

    def open_pair(self, **changes):
        a = make_run(self.directory / "a", RED)
        b = make_run(self.directory / "b", BLUE, h=0.02, still=(0, 1))
        return self.open_report(a, b, **changes)

    def wait_for_pictures(self):
        """Until the film shows the frame of its scrubber."""
        self.value("new Promise((done) => "
                   "requestAnimationFrame(() => requestAnimationFrame(done)))")
        self.page.wait_until("!active || active.frames.length === 0 || "
                             "(active.shown === active.at && !active.following)")

    def value(self, expression, *arguments):
        """Of an expression in JavaScript."""
        return self.page.run(f"return {expression}", *arguments)

    def key(self, key, event="keyDown"):
        text = key if key == " " else ""
        self.page.devtools("Input.dispatchKeyEvent", type=event, key=key, text=text)
        self.wait_for_pictures()

    def mouse(self, kind, x, y, buttons=1):
        self.page.devtools("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left",
                           buttons=buttons, clickCount=1)
        self.wait_for_pictures()

    def scrub(self, index):
        self.page.run("""const scrubber = document.querySelector(".scrubber");
            scrubber.value = arguments[0]; scrubber.dispatchEvent(new Event("input"));""", index)
        self.wait_for_pictures()

    def box(self, selector):
        return self.page.run("""
            const box = document.querySelector(arguments[0]).getBoundingClientRect();
            return [box.x, box.y, box.width, box.height];""", selector)

    def point(self, selector, across=0.5, down=0.5):
        """A point inside of an element, which is scrolled into sight."""
        self.value('document.querySelector(arguments[0]).scrollIntoView({block: "center"})',
                   selector)
        x, y, width, height = self.box(selector)
        return x + across * width, y + down * height

    def colour(self, x, y):
        """The colour of a pixel of the window."""
        left, top = self.value("[scrollX, scrollY]")
        clip = {"x": x + left, "y": y + top, "width": 1, "height": 1, "scale": 1}
        return first_pixel(base64.b64decode(
            self.page.devtools("Page.captureScreenshot", clip=clip)["data"]))

    def text(self, selector):
        return self.value("document.querySelector(arguments[0]).textContent", selector)

    def texts(self, selector):
        return self.value("[...document.querySelectorAll(arguments[0])].map((e) => e.textContent)",
                          selector)

    def shown(self):
        """The files of both pictures, and the last directory of each."""
        addresses = self.value(
            '[...document.querySelectorAll(".screen canvas")].map((c) => c.dataset.picture)')
        return ["/".join(address.split("/")[-2:]) for address in addresses]

    def expect_frame(self, number):
        self.assertEqual(self.shown(), [f"0/frame_{number:04}.png", f"1/frame_{number:04}.png"])
        self.assertEqual(self.text(".facts dd"), str(number))
        self.assertEqual(self.colour(*self.point(".screen.a canvas")), colour_of(RED, number))
        base = RED if number in (0, 1) else BLUE
        self.assertEqual(self.colour(*self.point(".screen.b canvas")), colour_of(base, number))


class Files(unittest.TestCase):
    """What can be said of a page without a browser."""

    def setUp(self):
        self.directory = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.runs = [make_run(self.directory / HOSTILE / name, base)
                     for name, base in (("a", RED), ("b", BLUE))]
        self.html = self.directory / "new" / "a report.html"
        report(self.html, *self.runs)

    def test_the_page_is_one_file(self):
        page = self.html.read_text()
        names_a_file = r"<link|<script[^>]* src|https?:(?!//www.w3.org/2000/svg)"
        self.assertEqual(re.findall(names_a_file, page), [])
        self.assertEqual(page.count("<script"), page.count("</script"))

    def test_its_data_are_those_of_json(self):
        expected = json.loads(compare(*self.runs, "--json", "-").stdout)
        for number, run in enumerate(expected["pairs"][0]["runs"]):
            run["pictures"] = f"a%20report_files/{number}"
        self.assertEqual(data_of(self.html.read_text()), expected)

    def test_the_pictures_lie_beside_it(self):
        for number, run in enumerate(self.runs):
            for picture in run.glob("*.png"):
                copy = self.html.parent / "a report_files" / str(number) / picture.name
                self.assertEqual(copy.read_bytes(), picture.read_bytes())


class Report(PageTest):
    def test_its_head_says_what_differs(self):
        self.assertEqual(self.open_pair(), 1)
        self.assertEqual(self.texts(".inputs td"), ["0.01", "0.02"])
        self.assertEqual(self.text(".pair summary .badge"), "different")
        self.assertIn("frame 2, t = 0.2 s", self.text(".sentence"))
        self.assertIn("--export obj", self.text(".notes"))
        labels, commands = self.texts(".command span"), self.texts(".command code")
        self.assertEqual(labels, ["reproduce A", "reproduce B", "accept B as the new A"])
        self.assertIn("step03_implicit", commands[0])

    def test_the_scrubber_shows_the_frames(self):
        self.open_pair()
        for number in (0, 3, 1, 4):
            self.scrub(number)
            self.expect_frame(number)
        self.assertEqual(self.value('document.querySelector(".screen.b canvas").ariaLabel'),
                         "Run B, frame 4, t = 0.4 s")

    def test_frames_of_the_same_time_are_shown_whatever_their_numbers(self):
        a = make_run(self.directory / "a", RED)
        b = make_run(self.directory / "b", BLUE, frames=9)
        log = b / "log.csv"
        log.write_text(re.sub(r"^(\d+),[^,]*", lambda row: f"{row[1]},{int(row[1]) / 20}",
                              log.read_text(), flags=re.MULTILINE))
        self.open_report(a, b)
        self.scrub(3)
        self.assertEqual(self.shown(), ["0/frame_0003.png", "1/frame_0006.png"])
        self.assertEqual(self.text(".facts dd"), "3 | 6")

    def test_keys_move_in_time(self):
        self.open_pair()
        for key, number in [("ArrowRight", 1), ("ArrowRight", 2), ("ArrowLeft", 1), ("End", 4),
                            ("ArrowRight", 4), ("Home", 0), ("ArrowLeft", 0)]:
            self.key(key)
            self.expect_frame(number)

    def test_an_arrow_on_the_scrubber_moves_one_frame(self):
        self.open_pair()
        self.page.run('document.querySelector(".scrubber").focus()')
        self.key("ArrowRight")
        self.expect_frame(1)

    def test_space_plays_and_pauses(self):
        self.open_pair()
        self.key(" ")
        self.page.wait_until("active.playing && active.at > 0")
        self.key(" ")
        self.assertFalse(self.value("active.playing"))
        self.expect_frame(self.value("active.at"))

    def test_the_wipe_wipes(self):
        self.open_pair()
        self.scrub(3)
        self.key("2")
        a, b = colour_of(RED, 3), colour_of(BLUE, 3)

        def left_and_right():
            return [self.colour(*self.point(".screens", across)) for across in (0.25, 0.75)]

        self.assertEqual(left_and_right(), [a, b])
        for across, colours in [(0.9, [a, a]), (0.1, [b, b])]:
            x, y = self.point(".screens", across, 0.9)
            self.mouse("mousePressed", x, y)
            self.mouse("mouseReleased", x, y, buttons=0)
            self.assertEqual(left_and_right(), colours)

    def test_holding_swaps(self):
        self.open_pair()
        self.scrub(3)
        self.key("3")
        x, y = self.point(".screens")
        a, b = colour_of(RED, 3), colour_of(BLUE, 3)
        self.assertEqual(self.colour(x, y), a)
        self.mouse("mousePressed", x, y)
        self.assertEqual(self.colour(x, y), b)
        self.mouse("mouseReleased", x, y, buttons=0)
        self.assertEqual(self.colour(x, y), a)
        self.key("1")
        self.key("b")
        self.assertEqual(self.colour(x, y), b)
        self.key("b", "keyUp")
        self.assertEqual(self.colour(x, y), a)

    def test_the_difference_is_black_where_nothing_differs(self):
        self.open_pair()
        self.key("4")
        self.assertEqual(self.colour(*self.point(".screens")), (0, 0, 0))
        self.scrub(3)
        # 200 in red and in blue; eight times that is more than 255.
        self.assertEqual(self.colour(*self.point(".screens")), (255, 0, 255))
        self.page.run("""const amplify = document.querySelector(".views select");
            amplify.value = 1; amplify.dispatchEvent(new Event("change"));""")
        self.wait_for_pictures()
        self.assertEqual(self.colour(*self.point(".screens")), (200, 0, 200))

    def test_a_click_on_a_curve_moves_the_scrubber(self):
        self.open_pair()
        left, right = self.value("[Curve.margin.left, Curve.margin.right]")
        x, y = self.point(".curve svg", 0)
        width = self.box(".curve svg")[2] - left - right
        at = x + left + 0.85 * width
        self.mouse("mousePressed", at, y)
        self.mouse("mouseReleased", at, y, buttons=0)
        self.expect_frame(3)
        mark, first = self.page.run("""return [".mark", ".first-difference"].map((name) =>
            Number(document.querySelector(name).getAttribute("x1")))""")
        self.assertAlmostEqual(mark, left + 0.75 * width, delta=0.01)
        self.assertAlmostEqual(first, left + 0.5 * width, delta=0.01)
        self.assertEqual(self.texts(".curve .series.a b")[0], "−3")  # the energy

    def test_the_worst_comes_first_and_what_passed_is_folded(self):
        self.open_report(*[make_run(self.directory / name, base)
                           for name, base in [("a", RED), ("same", RED), ("other", BLUE)]])
        self.assertEqual(self.texts(".who .b"), ["other", "same"])
        self.assertEqual(self.value('[...document.querySelectorAll(".pair")].map((p) => p.open)'),
                         [True, False])
        self.assertEqual(self.value('document.querySelectorAll(".film").length'), 1)
        self.value('document.querySelectorAll("summary")[1].click()')
        self.page.wait_until('document.querySelectorAll(".film").length === 2')

    def test_hostile_names_are_text(self):
        a = make_run(self.directory / HOSTILE / "a", RED)
        b = make_run(self.directory / (HOSTILE + "b"), BLUE, still=(0, 1))
        (b / "run.toml").write_text(
            "[run]\n'</script><i>key' = '<img src=x onerror=alert(1)>'\n[time]\nh = 0.01\n")
        self.open_report(a, b, html=HOSTILE + ".html")
        self.scrub(2)
        self.expect_frame(2)
        self.assertEqual(self.value('document.querySelectorAll("i:not([class]), img").length'), 0)
        self.assertEqual(self.text("h1"), f"{HOSTILE}/a and {HOSTILE}b")
        self.assertIn("<img src=x onerror=alert(1)>", self.texts(".inputs td"))

    def test_words_stand_in_for_a_picture_that_cannot_be_shown(self):
        a = make_run(self.directory / "a", RED)
        b = make_run(self.directory / "b", BLUE)
        (a / "frame_0001.png").unlink()
        (b / "frame_0002.png").write_bytes(b"no picture")
        self.open_report(a, b)
        self.scrub(1)
        self.assertEqual(self.text(".screen.a .words"), "A has no picture of frame 1.")
        self.assertEqual(self.colour(*self.point(".screen.b canvas")), colour_of(BLUE, 1))
        self.scrub(2)
        self.assertIn("frame_0002.png of B cannot be shown", self.text(".screen.b .words"))
        (self.directory / "report_files/0/frame_0004.png").unlink()
        self.open_again()
        self.scrub(4)
        self.assertIn("frame_0004.png of A cannot be shown", self.text(".screen.a .words"))
        self.scrub(3)
        self.expect_frame(3)
        self.forget_the_logs()  # the console names the file that is missing

    def open_again(self):
        self.page.open(self.directory / "report.html")
        self.wait_for_pictures()

    def test_a_report_without_frames_says_so(self):
        nothing = {"frames": [], "first_difference": None,
                   "summary": "No two frames are of the same time."}
        self.open_pair(change=lambda data: data["pairs"][0].update(nothing))
        self.assertIn("No two frames", self.text(".sentence"))
        self.assertEqual(self.text(".screen.a .words"), "A has no such frame.")
        for key in ("ArrowRight", "End", " ", "2", "b"):
            self.key(key)
        self.mouse("mousePressed", *self.point(".curve svg"))

    def test_numbers_that_do_not_exist_are_dashes(self):
        self.open_pair()
        self.assertEqual(self.texts(".facts dd")[-2:], ["–", "–"])

    def test_it_fits_a_phone(self):
        self.open_pair()
        self.page.devtools("Emulation.setDeviceMetricsOverride", width=390, height=844,
                           deviceScaleFactor=1, mobile=True)
        self.addCleanup(self.page.devtools, "Emulation.clearDeviceMetricsOverride")
        for view in "1234":
            self.key(view)
            self.assertLessEqual(self.value("document.documentElement.scrollWidth"), 390)

    def test_it_holds_few_pictures_of_long_films(self):
        length = 300

        def lengthen(data):
            [pair] = data["pairs"]
            for run in pair["runs"]:
                run["frames"] = [{**run["frames"][0], "number": n, "time": n / 100,
                                  "picture": f"{n}.png"} for n in range(length)]
            pair["frames"] = [{**pair["frames"][0], "numbers": [n, n], "time": n / 100}
                              for n in range(length)]

        before = self.memory()
        self.open_pair(change=lengthen)
        self.forget_the_logs()  # the pictures were not there yet
        for run, base in enumerate((RED, BLUE)):
            files = self.directory / "report_files" / str(run)
            (files / "one.png").write_bytes(png(640, 360, base))
            for number in range(length):
                (files / f"{number}.png").hardlink_to(files / "one.png")
        self.open_again()
        most = self.page.run("""return (async () => {
            let most = 0;
            for (let i = 0; i < active.frames.length; ++i) {
              active.goTo(i);
              while (active.shown !== i) await new Promise(requestAnimationFrame);
              most = Math.max(most, pictures.count);
            }
            return most;
          })()""")
        self.assertEqual(self.shown(), [f"0/{length - 1}.png", f"1/{length - 1}.png"])
        grown = self.memory() - before
        print(f"\n{most} pictures held; the renderer grew by {grown / 1e6:.0f} MB")
        self.assertLessEqual(most, 40)
        self.assertLessEqual(grown, 150e6)

    def memory(self):
        """Proportional set size of the renderers, bytes."""
        total = 0
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                command = (process / "cmdline").read_bytes()
                if b"--type=renderer" in command and self.profile.encode() in command:
                    sizes = (process / "smaps_rollup").read_text()
                    total += int(re.search(r"^Pss: *(\d+)", sizes, re.MULTILINE)[1])
            except (OSError, TypeError):
                pass  # it ended meanwhile
        self.assertGreater(total, 0)
        return 1024 * total


class Gallery(PageTest):
    def test_it_shows_each_step_and_compares_it_with_the_one_before(self):
        steps = ["step01_explicit", "step02_damping", "step03_implicit"]
        for number, step in enumerate(steps):
            run = make_run(self.directory / step, RED if number < 2 else BLUE, program=step)
            film = run / ("motion.png" if number == 0 else "film.png")
            film.write_bytes(png(64, 36, (10, 20, 30)))
        subprocess.run([GALLERY_PAGE, self.directory, "--frames 4", *steps], check=True, cwd=SOURCE,
                       capture_output=True)
        self.page.open(self.directory / "index.html")
        self.page.wait_until("[...document.images].every((image) => image.naturalWidth > 0)")
        self.assertEqual([title.split(" · ")[0] for title in self.texts("article h2")],
                         ["Step 1", "Step 2", "Step 3"])
        self.assertNotIn("<!--", self.text("#steps"))
        films = self.value(
            '[...document.querySelectorAll("article img")].map((i) => i.getAttribute("src"))')
        self.assertEqual(films, [f"{step}/{film}" for step, film in
                                 zip(steps, ["motion.png", "film.png", "film.png"])])
        self.assertIn("--frames 4", self.text("article code"))
        self.assertEqual(self.texts("article .badge"), ["identical", "different"])
        lesson = self.value('document.querySelector("article a").href')
        self.assertEqual(lesson, (SOURCE / steps[0] / "README.md").resolve().as_uri())
        self.page.open(self.directory / "compared/step03_implicit.html")
        self.wait_for_pictures()
        self.scrub(2)
        self.assertEqual(self.colour(*self.point(".screen.b canvas")), colour_of(BLUE, 2))


if __name__ == "__main__":
    has_chromium = browser.is_installed()
    chosen = sys.argv[4:] or ([] if has_chromium else ["Files"])
    program = unittest.main(argv=[sys.argv[0], *chosen], verbosity=2, exit=False)
    passed = program.result.wasSuccessful()
    if passed and not has_chromium:
        print("Chromium is not installed, so no page was opened: "
              "sudo apt-get install chromium-driver")
    sys.exit(1 if not passed else 0 if has_chromium else 77)
