"""Plots that gnuplot wrote as SVG, made fit to stand in a page: colours by name, so that they follow the colour scheme,
fonts of the page, names that are unique in it, and a fraction of the size."""
import re
import xml.etree.ElementTree as tree

import markup
from tables import Unreadable

SVG = "{http://www.w3.org/2000/svg}"
LINK = "{http://www.w3.org/1999/xlink}href"
# What the scripts of the plots use, and what page.css calls it.
COLOURS = {
    "#000000": "var(--ink)",
    "#ffffff": "var(--ground)",
    "#0b3c8c": "var(--blue)",
    "#c8102e": "var(--red)",
    "#2a9d4a": "var(--green)",
    "#b8860b": "var(--gold)",
    "#7b3fa0": "var(--purple)",
    "#555555": "var(--grey)",
    "#777777": "var(--grey)",
    "#999999": "var(--faint)",
    "#bbbbbb": "var(--faint)",
    "#cccccc": "var(--front)",
    "#dddddd": "var(--grid)",
    "#d9e7f7": "var(--sliding)",
    "#fbe3b5": "var(--stick-slip)",
    "#e2e2e2": "var(--at-rest)",
}
DROPPED = {"title", "desc", "filter"}
MARK = 0.7  # of the size of a mark in SVG, which is half as large again as in PNG
SIZE = 12.0  # of the font in the scripts of the plots; others are relative to it


class Panel:
    """A part of a plot that can be read alone: a box x y width height of its drawing, and what it shows."""

    def __init__(self, box, label):
        self.box, self.label = box, label


def colour(given):
    found = re.fullmatch(r"rgb\(\s*(\d+),\s*(\d+),\s*(\d+)\)", given)
    name = "#%02x%02x%02x" % tuple(int(part) for part in found.groups()) if found else given.lower()
    return COLOURS.get({"black": "#000000", "white": "#ffffff"}.get(name, name), name)


def short(number):
    return f"{float(number):.1f}".rstrip("0").rstrip(".")


def shorter_path(data):
    return re.sub(r" ?([MLZz]) ?", r"\1", re.sub(r"-?\d+\.\d+", lambda found: short(found[0]), data)).strip()


def rectangle(polygon):
    """(left, top, right, bottom) of a polygon whose sides are the axes', or None."""
    points = [tuple(float(part) for part in point.split(",")) for point in polygon.get("points").split()]
    xs, ys = sorted({x for x, _ in points}), sorted({y for _, y in points})
    return (xs[0], ys[0], xs[-1], ys[-1]) if len(points) == 4 and len(xs) == 2 and len(ys) == 2 else None


def joined(boxes):
    """Boxes of one colour in a row that overlap, as one: what they cover stays the same."""
    whole = []
    for box in boxes:
        last = whole[-1] if whole else None
        if last and last[1] == box[1] and last[3] == box[3] and last[0] <= box[0] <= last[2]:
            whole[-1] = (last[0], last[1], max(last[2], box[2]), last[3])
        else:
            whole.append(box)
    return whole


def boxes_path(fill, boxes):
    data = "".join(
        f"M{short(left)} {short(top)}H{short(right)}V{short(bottom)}H{short(left)}z"
        for left, top, right, bottom in joined(boxes)
    )
    return f'<path fill="{fill}" d="{data}"/>'


def attributes(node, prefix):
    kept = {}
    for key, given in node.attrib.items():
        name = key.split("}")[-1]
        if name in ("fill", "stroke", "color") and given != "none":
            given = colour(given)
        elif name == "id":
            if not given.startswith("gpPt"):
                continue
            given = prefix + given
        elif key == LINK:
            name, given = "href", "#" + prefix + given.lstrip("#")
        elif name == "font-size":
            relative = float(given) / SIZE
            if abs(relative - 1) < 0.01 and node.tag != SVG + "tspan":
                continue
            given = f"{relative:.3g}em"
        elif name == "font-family":
            if "Mono" not in given:
                continue
            given = "var(--mono)"
        elif name == "d":
            given = shorter_path(given)
        elif name == "transform":
            given = re.sub(r"(?<=scale\()[\d.]+", lambda found: f"{MARK * float(found[0]):.2f}", given)
            given = re.sub(r"-?\d+\.\d+(?=[,)])", lambda found: f"{float(found[0]):.2f}".rstrip("0").rstrip("."), given)
        elif name == "space":
            name = "xml:space"
        elif (name, given.strip()) in (
            ("stroke-linecap", "butt"),
            ("stroke-linejoin", "miter"),
            ("stroke-width", "1.00"),
        ):
            continue
        kept[name] = given.strip()
    return kept


def drawn(node, prefix):
    """A node and what is in it, as SVG; "" where nothing would be seen of it."""
    name = node.tag.replace(SVG, "")
    if name in DROPPED:
        return ""
    content, filled, fill = [markup.text(node.text or "")], [], None

    def finish():
        if filled:
            content.append(boxes_path(fill, filled))
            filled.clear()

    for child in node:
        box = rectangle(child) if child.tag == SVG + "polygon" else None
        if box:
            if colour(child.get("fill")) != fill:
                finish()
                fill = colour(child.get("fill"))
            filled.append(box)
        else:
            finish()
            content.append(drawn(child, prefix))
            content.append(markup.text(child.tail or ""))
    finish()
    inside = "".join(content) if name in ("text", "tspan") else "".join(part.strip() for part in content)
    if not inside and name in ("g", "text", "tspan", "defs"):
        return ""
    pairs = "".join(f' {key}="{markup.text(given)}"' for key, given in attributes(node, prefix).items())
    if name == "g" and not pairs:
        return inside
    return f"<{name}{pairs}>{inside}</{name}>" if inside else f"<{name}{pairs}/>"


def inline(path, prefix, panels, layout=""):
    """The plot as one <svg> a panel; the drawing is in the first, and the others show other parts of it. layout: "scrolls"
    stays wide on a narrow screen and is moved under its frame, "column" has its panels one below the other everywhere."""
    try:
        root = tree.parse(path).getroot()
    except (OSError, tree.ParseError) as error:
        raise Unreadable(
            f"{path}: {getattr(error, 'strerror', None) or error}; scripts/plots/draw.sh draws the plots"
        ) from error
    ground = root.find(f".//{SVG}rect")  # the first is the background of all
    if ground is not None and ground.get("width") == root.get("width"):
        next(parent for parent in root.iter() if ground in list(parent)).remove(ground)
    content = "".join(drawn(child, prefix + "-") for child in root)
    name = f"{prefix}-drawing"
    pictures = []
    for i, panel in enumerate(panels):
        inside = f'<g id="{name}">{content}</g>' if i == 0 else f'<use href="#{name}"/>'
        width, height = panel.box.split()[2:]
        pictures.append(
            f'<svg viewBox="{panel.box}" width="{width}" height="{height}" role="img"'
            f' aria-label="{markup.text(panel.label)}">{inside}</svg>'
        )
    return markup.element(
        "div",
        "\n".join(pictures),
        class_=f"plot {layout}".strip(),
        tabindex="0" if "scrolls" in layout else None,
        role="group",
        aria_label=" ".join(panel.label for panel in panels),
    )
