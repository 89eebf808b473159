"""The results of all tasks: a table for people, Gradescope's results.json, and JUnit's XML."""
import dataclasses
import hashlib
import json
import textwrap
import xml.etree.ElementTree as ElementTree

import functions
from runs import FAILED, PASSED, UNWRITTEN, sentence

KINDS = {
    "write": "not written yet",
    "mend": "not mended yet",
    "invent": "not written yet",
    "measure": "not answered yet",
}


@dataclasses.dataclass
class Result:
    """One task and how it ended."""

    id: str
    title: str
    points: int  # that the task is worth
    lesson: str
    state: str  # of runs.py
    message: str = ""
    report: ElementTree.Element = None

    @property
    def score(self):
        return self.points if self.state == PASSED else 0

    @property
    def explanation(self):
        """A failure, and where to read again."""
        return (
            f"{self.message}\nRead again: {self.lesson}" if self.state == FAILED else self.message
        )


def result(task, ending):
    """task: a Task, or its public part in a copy."""
    return Result(
        task.id, task.title, task.points, task.lesson, ending.state, ending.message, ending.report
    )


def fingerprint(body):
    """Of a body that was handed out: to know it again."""
    return hashlib.sha256(functions.squeezed(body).encode()).hexdigest()


def table(results):
    lines = []
    for r in results:
        lines.append(f"{r.id:6} {r.score:3} of {r.points:2}  {r.state:9}  {r.title}")
        if r.state != PASSED:
            for part in r.explanation.split("\n"):
                lines += textwrap.wrap(
                    part,
                    96,
                    initial_indent=" " * 10,
                    subsequent_indent=" " * 10,
                    break_long_words=False,
                )
    lines.append(
        f"total  {sum(r.score for r in results):3} of {sum(r.points for r in results)} points"
    )
    return "\n".join(lines)


def gradescope(results):
    """results.json, as Gradescope reads it."""
    return (
        json.dumps(
            {
                "tests": [
                    {
                        "name": r.title,
                        "number": r.id,
                        "score": r.score,
                        "max_score": r.points,
                        "output": r.explanation,
                        "status": "passed" if r.state == PASSED else "failed",
                        "tags": [r.state],
                        "visibility": "visible",
                    }
                    for r in results
                ]
            },
            indent=1,
            ensure_ascii=False,
        )
        + "\n"
    )


def without_places(case):
    """A test case without the paths of the machine that graded it."""
    for attribute in ("file", "line"):
        case.attrib.pop(attribute, None)
    for failure in case.findall("failure"):
        failure.text = sentence(failure.get("message"))
        failure.set("message", failure.text)
    return case


def junit(results):
    """JUnit's XML: GoogleTest's own suites, with the task and its points. A task without them is
    one case.
    """
    root = ElementTree.Element("testsuites", name="assignments")
    for r in results:
        suite = ElementTree.SubElement(root, "testsuite", name=f"{r.id} {r.title}")
        properties = ElementTree.SubElement(suite, "properties")
        for name, value in (("task", r.id), ("points", r.points), ("score", r.score)):
            ElementTree.SubElement(properties, "property", name=name, value=str(value))
        cases = (
            r.report.findall(".//testcase") if r.report is not None and r.state != UNWRITTEN else []
        )
        for case in cases:
            case.set("classname", f"{r.id}.{case.get('classname')}")
            suite.append(without_places(case))
        if not cases:
            case = ElementTree.SubElement(suite, "testcase", name=r.title, classname=r.id)
            if r.state != PASSED:
                tag = "skipped" if r.state == UNWRITTEN else "failure"
                ElementTree.SubElement(case, tag, message=r.explanation)
        for attribute, tag in (("failures", "failure"), ("skipped", "skipped")):
            suite.set(attribute, str(len(suite.findall(f".//{tag}"))))
        suite.set("tests", str(len(suite.findall("testcase"))))
    ElementTree.indent(root)
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        + ElementTree.tostring(root, encoding="unicode")
        + "\n"
    )
