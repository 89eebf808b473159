"""Reads answers.toml: one number for each task that asks for a measurement, "C1.1" = 2.6e-4."""
import re
import tomllib

FILE = "answers.toml"
BYTES = 100_000
EXAMPLE = (
    'Write a line such as "C1.1" = 2.6e-4, with the task in quotes, a point in the number, '
    "and no unit"
)


class AnswerError(Exception):
    """Why an answer cannot be used, as a sentence."""


def read(directory):
    """All of the file, task → value. A directory without the file has no answers."""
    path = directory / FILE
    if not path.is_file():
        return {}
    try:
        with open(path, "rb") as file:
            text = file.read(BYTES + 1).decode()
        if len(text) > BYTES:
            raise AnswerError(f"{FILE} is larger than {BYTES // 1000} kB")
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise AnswerError(f"{FILE} cannot be read: {place(text, error)}. {EXAMPLE}") from None
    except (OSError, ValueError, RecursionError) as error:
        raise AnswerError(f"{FILE} cannot be read: {str(error)[:200]}. {EXAMPLE}") from None


def place(text, error):
    """The line that is no TOML, if the error names it."""
    if not (found := re.search(r"at line (\d+)", str(error))):
        return str(error)[:100]
    number = int(found.group(1))
    return f"line {number} is {text.splitlines()[number - 1].strip()[:60]}"


def number(directory, task):
    """The number that stands for a task, or None."""
    found = read(directory)
    letter, _, rest = task.partition(".")
    if task not in found and isinstance(found.get(letter), dict) and rest in found[letter]:
        raise AnswerError(f'{FILE}: the name of a task stands in quotes, "{task}" = …')
    value = found.get(task)
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not abs(value) < 1e300:
        raise AnswerError(f'{FILE}: "{task}" is not a number; 2.6e-4 is one')
    return value
