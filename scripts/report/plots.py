"""Plots that gnuplot wrote as SVG, made fit to stand in a page: colours by name, so that they follow the colour scheme, fonts of the
page, names that are unique in it, numbers of one decimal, and nothing that is not drawn."""
import re
import xml.etree.ElementTree as tree

from markupsafe import Markup

from tables import Unreadable

SVG, LINK = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/1999/xlink}href"
# What the scripts of the plots use, and what page.css calls it.
COLOURS = {
    "#000000": "ink", "#ffffff": "ground", "#0b3c8c": "blue", "#c8102e": "red", "#2a9d4a": "green", "#b8860b": "gold",
    "#7b3fa0": "purple", "#555555": "grey", "#777777": "grey", "#999999": "faint", "#bbbbbb": "faint", "#cccccc": "front",
    "#dddddd": "grid", "#d9e7f7": "sliding", "#fbe3b5": "stick-slip", "#e2e2e2": "at-rest", "black": "ink", "white": "ground",
}  # fmt: skip
DRAWN = {"g", "defs", "path", "circle", "use", "text", "tspan", "rect"}
KEPT = set("""d transform x y dx dy width height cx cy r fill stroke color stroke-width stroke-dasharray text-anchor font-weight
baseline-shift""".split())
MARK = 0.7  # of the size of a mark in SVG, which is half as large again as in PNG
SIZE = 12.0  # of the font in the scripts of the plots; others are relative to it


def colour(given):
    channels = re.fullmatch(r"rgb\(\s*(\d+),\s*(\d+),\s*(\d+)\)", given)
    name = "#%02x%02x%02x" % tuple(map(int, channels.groups())) if channels else given.strip()
    return f"var(--{COLOURS[name]})" if name in COLOURS else name


def short(text):
    return re.sub(r"-?\d+\.\d+", lambda found: f"{float(found[0]):.1f}".removesuffix(".0"), text).strip()


def attribute(key, given, prefix):
    """(name, value) as the page has it, or None."""
    if key in ("fill", "stroke", "color"):
        return key, colour(given)
    if key == "id" and given.startswith("gp"):
        return key, prefix + given
    if key == LINK and given.startswith("#"):
        return "href", "#" + prefix + given[1:]
    if key == "font-size":
        return key, f"{float(given) / SIZE:.3g}em"
    if key == "font-family" and "Mono" in given:
        return key, "var(--mono)"
    if key == "transform":
        given = re.sub(r"scale\(([\d.]+)\)", lambda found: f"scale({MARK * float(found[1]):.2f})", given)
        return key, re.sub(r"\d+\.\d+(?=,|\)$|\) )", lambda found: f"{float(found[0]):.2f}", given)
    return (key, short(given) if key == "d" else given.strip()) if key in KEPT else None


def boxes(node):
    """Polygons of one colour in a row become one path."""
    whole = None
    for child in list(node):
        if child.tag != SVG + "polygon":
            whole = None
            continue
        path = "M" + short(child.get("points", "")).replace(" ", "L") + "z"
        if whole is not None and whole.get("fill") == child.get("fill"):
            whole.set("d", whole.get("d") + path)
            node.remove(child)
        else:
            whole, child.tag = child, SVG + "path"
            child.attrib = {"fill": child.get("fill", "none"), "d": path}


def clean(node, prefix):
    """Takes away what is not drawn, and renames the rest."""
    boxes(node)
    for child in list(node):
        clean(child, prefix)
        empty = child.tag in ("g", "text", "tspan") and len(child) == 0 and not (child.text or "").strip()
        if child.tag not in DRAWN or empty:
            node.remove(child)
    node.tag = node.tag.replace(SVG, "")
    if node.tag not in ("text", "tspan"):
        node.text = None
        for child in node:
            child.tail = None
    found = [attribute(key, given, prefix) for key, given in node.attrib.items()]
    node.attrib = dict(pair for pair in found if pair)


def drawing(path, prefix):
    """The inside of an <svg>, and its width and height."""
    try:
        root = tree.parse(path).getroot()
    except (OSError, tree.ParseError) as error:
        raise Unreadable(f"{path}: {getattr(error, 'strerror', None) or error}; scripts/plots/draw.sh draws it") from error
    size = float(root.get("width")), float(root.get("height"))
    for parent in root.iter():
        for ground in parent.findall(SVG + "rect"):  # that is as large as all
            if ground.get("width") == root.get("width"):
                parent.remove(ground)
    clean(root, prefix + "-")
    return Markup("".join(tree.tostring(child, encoding="unicode") for child in root)), *size
