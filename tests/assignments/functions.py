"""Functions in C++ text: finds them by qualified name, and reads or replaces their bodies.

The text is not parsed as a compiler does. Braces are matched, and the words before an opening brace
tell whether it begins a namespace, a class, or the body of a function.
"""
import re


class CodeError(Exception):
    """One clear sentence about C++ text that cannot be used."""


class NotFound(CodeError):
    """A text has no such function."""


NOT_CODE = re.compile(
    r"""
    //[^\n]* | /\*.*?\*/                              # comments
  | R"(?P<mark>[^\s()\\]{0,16})\(.*?\)(?P=mark)"      # raw strings
  | "(?:\\.|[^"\\\n])*"                               # strings
  | (?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'               # characters; not the ' of 1'000
""",
    re.VERBOSE | re.DOTALL,
)
DIRECTIVE = re.compile(r"^[ \t]*(?:\#|%:)(?:\\\n|[^\n])*", re.MULTILINE)
OPEN, CLOSE = "([{", ")]}"


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def code_only(text):
    """The text, with blanks for comments, strings, characters and # lines. Every place stays the
    same.
    """
    return DIRECTIVE.sub(blank, NOT_CODE.sub(blank, text))


def closing(code, opening):
    """The place of the bracket that closes the one at `opening`."""
    depth = 0
    for i in range(opening, len(code)):
        depth += (code[i] in OPEN) - (code[i] in CLOSE)
        if depth == 0:
            return i
    line = code.count("\n", 0, opening) + 1
    raise CodeError(f"line {line}: '{code[opening]}' is never closed")


class Function:
    """A function that has a body."""

    def __init__(self, name, parameters, head, begin, end):
        self.name, self.parameters = name, parameters  # step01::act, "const Term& term, …"
        self.head = head  # where its declaration begins
        self.begin, self.end = begin, end  # the body, without its braces

    def is_called(self, wanted):
        """wanted: step01::act, or act(const Term if the parameters must tell it from others."""
        name, _, parameters = wanted.partition("(")
        squeezed = re.sub(r"\s+", " ", self.parameters).strip()
        return self.name == name and squeezed.startswith(parameters.rstrip(")"))


def without_template(head):
    """The words before a brace, without labels, attributes and `template <…>`."""
    head = re.sub(r"\b(public|private|protected)\s*:(?!:)", "", head)
    head = re.sub(r"\[\[.*?\]\]", "", head, flags=re.DOTALL).strip()
    while match := re.match(r"template\s*<", head):
        depth, i = 1, match.end()
        while depth and i < len(head):
            depth += (head[i] == "<") - (head[i] == ">")
            i += 1
        head = head[i:].strip()
    return head


def scope_of(head):
    """The name of the namespace or class that `head` begins; None if it begins none."""
    if match := re.match(r"(?:inline\s+)?namespace\b\s*([\w:]*)", head):
        return match.group(1)
    if match := re.match(r"(?:struct|class|union)\s+(\w+)", head):
        return match.group(1) if "(" not in head else None
    return None


def signature(head):
    """(name, parameters, what follows them) of a function; None if `head` begins no function."""
    match = re.match(r"[^(=]*?((?:\w+(?:<[^()]*>)?::)*(?:operator\W+|~?\w+))\s*\(", head)
    if not match:
        return None
    close = closing(head, match.end() - 1)
    name = re.sub(r"<[^()]*>", "", match.group(1))
    return name, head[match.end() : close], head[close + 1 :].strip()


def functions(text):
    """All functions of the text that have a body, in order."""
    code, found = code_only(text), []

    def scan(begin, end, scope):
        head = i = begin
        while i < end:
            c = code[i]
            if c in "([":
                i = closing(code, i)
            elif c in ";}":
                head = i + 1
            elif c == "{":
                close = closing(code, i)
                words = without_template(code[head:i])
                inner = scope_of(words)
                if inner is not None:
                    scan(i + 1, close, scope + [inner] if inner else scope)
                    head = close + 1
                elif (parts := signature(words)) and is_body(parts[2]):
                    start = head + len(code[head:i]) - len(code[head:i].lstrip())
                    found.append(
                        Function("::".join(scope + [parts[0]]), parts[1], start, i + 1, close)
                    )
                    head = close + 1
                i = close
            i += 1

    def is_body(tail):  # after `: a(1), b` a brace is a value, after `: a(1), b{2}` it is the body
        return not tail.startswith(":") or tail[-1] in ")}"

    scan(0, len(code), [])
    return found


def find(text, wanted, where="the text"):
    """The one function that is called so. Raises CodeError if there is none, or more than one."""
    try:
        hits = [f for f in functions(text) if f.is_called(wanted)]
    except CodeError as error:
        raise CodeError(f"{where}, {error}") from None
    if not hits:
        raise NotFound(f"{where} has no function {wanted}" + ", …)" * ("(" in wanted))
    if len(hits) > 1:
        lines = ", ".join(str(text.count("\n", 0, f.head) + 1) for f in hits)
        raise CodeError(
            f"{where} has {len(hits)} functions {wanted} (lines {lines}): "
            f"name the first parameters too, as in {wanted}({hits[0].parameters.split(',')[0]}"
        )
    return hits[0]


def body(text, wanted, where="the text"):
    function = find(text, wanted, where)
    return text[function.begin : function.end]


def with_body(text, wanted, new, where="the text"):
    """The text, with another body for one function."""
    function = find(text, wanted, where)
    return text[: function.begin] + new + text[function.end :]


def indentation(text, wanted, where="the text"):
    """The spaces before the declaration of one function."""
    line = text[: find(text, wanted, where).head].rpartition("\n")[2]
    return " " * len(line)


def squeezed(text):
    """The text without comments and spaces: two bodies that differ only in these are the same."""
    comments = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
    return re.sub(
        r"\s+", "", NOT_CODE.sub(lambda m: "" if comments.fullmatch(m.group()) else m.group(), text)
    )
