"""Small changes to C++ sources: where one is possible, and the text with it."""

import collections
import re

# Binary operators stand between spaces, or end a line: so the formatter leaves them.
OPERATORS = {"<": ["<="], "<=": ["<"], ">": [">="], ">=": [">"], "==": ["!="], "!=": ["=="],
             "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "&&": ["||"], "||": ["&&"],
             "+=": ["-="], "-=": ["+="]}
OPERATOR = re.compile(r"(?<= )(<=|>=|==|!=|\+=|-=|&&|\|\||[<>+*/-])(?= |$)", re.MULTILINE)
CALLS = {"min": "max", "max": "min", "floor": "ceil", "ceil": "floor", "lower_bound": "upper_bound",
         "upper_bound": "lower_bound", "true": "false", "false": "true"}
CALL = re.compile(r"\b(?:(?:(?<=std::)|(?<=glm::))(min|max|floor|ceil|lower_bound|upper_bound)(?=\()"
                  r"|(true|false))\b")
NOT = re.compile(r"(?<=[ (])!(?=[\w(])")
FRACTION = re.compile(r"(?<![\w.])(\d+\.\d+)(?=f?\b)")
WHOLE = re.compile(r"(?<=[ (\[])(\d+)(?=[ ;)\]u])")

# Text that is not code, and lines that steer the compiler.
NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"\(.*?\)"|"(?:\\.|[^"\\\n])*"|' r"(?<!\w)'(?:\\.|[^'\\\n])+'"
                     r"|^[ \t]*#[^\n]*|\bstatic_assert\b[^;]*;|\bassert\([^;]*;"
                     r"|^[ \t]*template <[^\n]*|\boperator ?[^\w\s(]+|\bthrow\b[^;]*;",
                     re.MULTILINE | re.DOTALL)

Change = collections.namedtuple("Change", "begin end old new line")


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def changes(text):
    """All that can be changed in one place."""
    code = NO_CODE.sub(blank, text)
    found = []

    def add(match, group, new):
        begin, end = match.span(group)
        found.append(Change(begin, end, text[begin:end], new, text.count("\n", 0, begin) + 1))

    for match in OPERATOR.finditer(code):
        for new in OPERATORS[match.group()]:
            add(match, 0, new)
    for match in CALL.finditer(code):
        add(match, 0, CALLS[match.group()])
    for match in NOT.finditer(code):
        add(match, 0, "")
    for match in FRACTION.finditer(code):
        value = float(match.group())
        add(match, 0, repr(value / 2 if value else 1.0))
    for match in WHOLE.finditer(code):
        add(match, 0, str(int(match.group()) + 1))
    return sorted(set(found))


def apply(text, change):
    return text[:change.begin] + change.new + text[change.end:]


def line_of(text, number):
    return text.split("\n")[number - 1].strip()
