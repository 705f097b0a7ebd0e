"""The formulas of a formula file (asymptotics/published/paper.cfg), by their names, typeset in MathML."""
import ast
import re

from markupsafe import Markup

from tables import text_of

GROUP = re.compile(r'\{(?:[^{}"]|"[^"]*"|\{[^{}]*\})*\}')
MEMBER = re.compile(r'(\w+) = ((?:"[^"]*"\s*)+|\d+);')
NAMES = {"alpha": "α", "v0": "ẋ_0", "mstar": "m^*", "dT": "ΔT", "l_start": "l(0)", "l_end": "l(T)", "x_switch": "x(T − ΔT)"}
OPERATORS = {ast.Add: "+", ast.Sub: "−"}
TIMES = Markup("<mo>&#x2062;</mo>")


class Unknown(Exception):
    """What a formula has in it that is not typeset."""


def tag(name, *inside):
    return Markup("<{0}>{1}</{0}>").format(name, Markup("").join(inside))


def row(*inside):
    return tag("mrow", *inside)


def brackets(inside):
    return row(tag("mo", "("), inside, tag("mo", ")"))


def plain(mark):
    """A bracket that does not grow with what it holds."""
    return Markup('<mo stretchy="false">{}</mo>').format(mark)


def letters(name):
    """F1, lT, L_kin: a letter and an index; what NAMES has otherwise, letter by letter; displacement: a word."""
    if name not in NAMES:
        letter, index = name[0], name[1:].lstrip("_")
        if len(index) > 1 and name[1] != "_":
            return tag("mtext", name)
        inside = tag("mi", letter)
        return tag("msub", inside, tag("mn" if index.isdigit() else "mi", index)) if index else inside
    shown = NAMES[name]
    if shown[1:2] in ("_", "^"):
        return tag("msub" if shown[1] == "_" else "msup", tag("mi", shown[0]), tag("mn" if shown[1] == "_" else "mo", shown[2:]))
    return row(*(plain(c) if c in "()" else tag("mi" if c.isalpha() else "mn" if c.isdigit() else "mo", c) for c in shown.replace(" ", "")))


def factors(node):
    """A product as a sign and a list of (numerators, denominators): a divisor takes what stands before it, up to the last fraction."""
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        negative, parts = factors(node.operand)
        return not negative, parts
    if not isinstance(node, ast.BinOp) or not isinstance(node.op, (ast.Mult, ast.Div)):
        return False, [([node], [])]
    negative, parts = factors(node.left)
    if isinstance(node.op, ast.Mult):
        return negative, [*parts, ([node.right], [])]
    last = max((i + 1 for i, (_, below) in enumerate(parts) if below), default=0)
    if last == len(parts):  # a/b/c
        return negative, [*parts[:-1], (parts[-1][0], [node.right, *parts[-1][1]])]
    return negative, [*parts[:last], ([above for part in parts[last:] for above in part[0]], [node.right])]


def product(nodes, alone):
    """Factors side by side; sums are in brackets, unless one stands alone."""
    bare = alone and len(nodes) == 1
    return TIMES.join(math(node) if bare else held(node) for node in nodes)


def held(node):
    """In brackets where a factor, or what is subtracted, needs them."""
    is_sum = isinstance(node, ast.BinOp) and type(node.op) in OPERATORS
    return brackets(math(node)) if is_sum or factors(node)[0] else math(node)


def math(node):
    """The MathML of a parsed formula."""
    if isinstance(node, ast.Name):
        return letters(node.id)
    if isinstance(node, ast.Constant):
        return tag("mn", str(node.value))
    if isinstance(node, ast.Call):
        return row(math(node.func), plain("("), math(node.args[0]), plain(")"))
    if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
        right = held(node.right) if isinstance(node.op, ast.Sub) or factors(node.right)[0] else math(node.right)
        return row(math(node.left), tag("mo", OPERATORS[type(node.op)]), right)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
        base = node.left if isinstance(node.left, (ast.Name, ast.Constant)) else None
        return tag("msup", math(base) if base else brackets(math(node.left)), math(node.right))
    if not isinstance(node, (ast.BinOp, ast.UnaryOp)):
        raise Unknown(type(node).__name__)
    negative, parts = factors(node)
    shown = [
        tag("mfrac", row(product(above, True)), row(product(below, True))) if below else product(above, len(parts) == 1)
        for above, below in parts
    ]
    return row(tag("mo", "−") if negative else "", TIMES.join(shown))


def typeset(text):
    """Text in the language of formulas, as in "x_C(T) - v0*T", as the inside of a <math>; None where it is not such a text."""
    try:
        return math(ast.parse(text.replace("^", "**"), mode="eval").body)
    except (SyntaxError, Unknown):
        return None


def read(path):
    """The groups of a formula file by their names; each has its members as text."""
    source = re.sub(r"/\*.*?\*/", "", text_of(path), flags=re.S)
    groups = [dict(MEMBER.findall(re.sub(r"\{[^{}]*\}", "", group[1:-1]))) for group in GROUP.findall(source)]
    formulas = {}
    for group in groups:
        members = {key: "".join(re.findall(r'"([^"]*)"', value)) or value for key, value in group.items()}
        formulas[members["name"]] = members
    return formulas
