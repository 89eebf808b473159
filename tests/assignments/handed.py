"""What is taken from a hand-in: the bodies of named functions, and helpers.h. The copy of a student
has this file too, so that ./check refuses what the grader refuses.
"""
import re

import functions

HELPERS = "common/math/helpers.h"
BYTES = 1_000_000  # of one file of a hand-in


class Refused(Exception):
    """What a hand-in must not have, as a sentence."""


def refuse_forbidden(text, where, first_line=1):
    """Raises Refused for a # line, and for words that make the compiler read other files."""
    code = functions.NOT_CODE.sub(functions.blank, text)
    for number, line in enumerate(code.split("\n")):
        place = f"{where}, line {first_line + number}"
        if re.match(r"\s*(#|%:)", line):
            raise Refused(
                f"{place}: a line that begins with # is not taken by the grader: "
                f"{text.splitlines()[number].strip()}"
            )
        if word := re.search(r"\b(asm|__asm|__asm__|_Pragma)\b", line):
            raise Refused(f"{place}: the word {word.group()} is not taken by the grader")


def read(hand_in, file):
    """The text of a file. Raises Refused also for a link to a device, which has no end."""
    path = hand_in / file
    try:
        if not path.is_file():
            reason = "there is no such file"
        elif path.stat().st_size > BYTES:
            reason = f"it is larger than {BYTES // 1000} kB"
        else:
            return path.read_text()
    except (OSError, UnicodeDecodeError) as error:
        reason = type(error).__name__
    raise Refused(f"The hand-in has no readable {file}: {reason}")


def bodies(task, hand_in):
    """The bodies of the task's functions, in order. `task`: a Task, or its public part in a copy."""
    text = read(hand_in, task.file)
    found = []
    for name in task.functions:
        try:
            function = functions.find(text, name, task.file)
        except functions.NotFound as error:
            raise Refused(
                f"{error}. Its name and its parameters must stay as they were handed out."
            ) from None
        except functions.CodeError as error:
            raise Refused(str(error)) from None
        body = text[function.begin : function.end]
        refuse_forbidden(body, task.file, 1 + text.count("\n", 0, function.begin))
        found.append(body)
    return found


def helpers(hand_in):
    """helpers.h of the hand-in. Empty if there is nothing in it."""
    if not (hand_in / HELPERS).exists():
        return ""
    text = read(hand_in, HELPERS).replace("#pragma once", "", 1)
    if not functions.squeezed(text):
        return ""
    refuse_forbidden(text, HELPERS)
    return "#pragma once\n" + text
