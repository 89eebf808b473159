"""The tasks: what each asks, where its functions are, and what is handed out in their place."""
import dataclasses
import hashlib
import pathlib
import re
import tomllib

from results import KINDS

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[1]


class TaskError(Exception):
    """One clear sentence about a task that cannot be handed out or graded."""


@dataclasses.dataclass
class Task:
    """One file of tasks/, in the words of that file."""

    id: str
    kind: str  # of KINDS
    title: str
    points: int
    minutes: int  # for a student who has read the lesson
    lesson: str  # the section to read, FILE.md#heading
    hint: str
    file: str = ""  # the functions and their file
    functions: list = dataclasses.field(default_factory=list)
    check: str = ""  # of checks/
    libraries: list = dataclasses.field(default_factory=list)
    mistakes: list = dataclasses.field(default_factory=list)  # name, cut, with: typical ones
    planted: dict = dataclasses.field(default_factory=dict)  # cut, with: what `mend` hands out
    question: str = ""  # of `measure` and `invent`
    unit: str = ""  # of the answer to `measure`
    given: dict = dataclasses.field(default_factory=dict)  # numbers that differ between students
    term: str = ""  # of `invent`: the term and the list of math/cloth.h that it joins
    list: str = ""

    @property
    def step(self):
        return int(self.id[1])

    @property
    def source(self):
        """Where its file is in the project."""
        return (HERE if self.kind == "invent" else SOURCE) / self.file

    @property
    def numbers_file(self):
        """Of `invent`: the header with the numbers of one student."""
        return self.file.replace(".h", "_numbers.h")

    @property
    def target(self):
        return "check_" + self.id.replace(".", "_")

    def given_body(self, body, function):
        """What is handed out in place of the body of a function."""
        if self.kind == "mend":
            return replaced_once(body, self.planted, f"tasks/{self.id}.toml: planted")
        name = re.sub(r"\(.*", "", function)
        return f'\n  not_written("{self.id}", "{name}");\n'

    def numbers(self, student):
        """The numbers of one student: a name → value. They follow from the student's ID and the
        task.
        """
        digest = hashlib.sha256(f"{student}/{self.id}".encode()).digest()
        shares = [int.from_bytes(digest[4 * i : 4 * i + 4], "big") / 2**32 for i in range(8)]
        return {
            name: chosen(values, share) for (name, values), share in zip(self.given.items(), shares)
        }


def chosen(values, share):
    """{from, to, digits}: a number between the two. A list: one of its values."""
    if isinstance(values, list):
        return values[int(share * len(values))]
    return round(values["from"] + share * (values["to"] - values["from"]), values["digits"])


def replaced_once(text, change, where):
    if text.count(change["cut"]) != 1:
        raise TaskError(
            f"{where}: the body has {text.count(change['cut'])} times the text {change['cut']!r}; "
            "it must have it once"
        )
    return text.replace(change["cut"], change["with"])


def load_file(path):
    try:
        task = Task(id=path.stem, **tomllib.loads(path.read_text()))
    except (tomllib.TOMLDecodeError, TypeError) as error:
        raise TaskError(f"tasks/{path.name}: {error}") from None
    if task.kind not in KINDS:
        raise TaskError(
            f"tasks/{path.name}: kind is {task.kind!r}; it must be one of {', '.join(KINDS)}"
        )
    return task


def load_all(directory=HERE / "tasks"):
    return {path.stem: load_file(path) for path in sorted(directory.glob("*.toml"))}


def select(names, every=None):
    """The tasks of a list such as A3.2 A1 B: a letter and a number choose all that begin so."""
    every = every or load_all()
    found = []
    for name in names:
        hits = [id for id in every if id == name or re.match(re.escape(name) + r"(\.|\d|$)", id)]
        if not hits:
            raise TaskError(f"there is no task {name}; there are {', '.join(every)}")
        found += [every[id] for id in hits if every[id] not in found]
    return found
