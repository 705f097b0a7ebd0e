"""The largest error of every family of stress.tsv beside what is promised, drawn as rows of dots."""
import found
import tables
from markup import element, text

WIDTH, LEFT, RIGHT, LINE, TOP = 450, 182, 16, 17, 44
GAITS = {"quadratic": "M{x} {y}m-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z", "sinusoidal": "M{x} {y}m0-5l5 5l-5 5l-5-5z"}
COLOURS = {"quadratic": "var(--blue)", "sinusoidal": "var(--red)"}


def mark(gait, x, y):
    return f'<path d="{GAITS[gait].format(x=round(x, 1), y=y)}" fill="{COLOURS[gait]}" stroke="var(--ground)"/>'


def label(x, y, words, anchor):
    return f'<text x="{x}" y="{y}" text-anchor="{anchor}">{text(words)}</text>'


def dots(stress):
    """An <svg>: one line a family, one mark a gait, and a line at the promised error."""
    promised = found.promises(stress)[0]
    families = found.grouped(stress.rows, "family")
    bottom = TOP + LINE * len(families)

    def across(units):
        return LEFT + (WIDTH - LEFT - RIGHT) * units / promised

    parts = []
    for units in range(int(promised) + 1):
        x = round(across(units), 1)
        colour = "var(--red)" if units == promised else "var(--grid)"
        parts.append(f'<path d="M{x} {TOP - 6}V{bottom}" stroke="{colour}"/>')
        parts.append(label(x, bottom + 16, str(units), "middle"))
    parts.append(label(round(across(promised)) + 8, TOP - 12, "promised", "end"))
    parts.append(label(round(across(promised / 2)), bottom + 36, "largest error, in units", "middle"))
    for i, ((family,), rows) in enumerate(families.items()):
        y = TOP + LINE * i + LINE // 2
        parts.append(label(LEFT - 10, y + 4, family, "end"))
        for row in rows:
            units = tables.value(row["units"])
            if row["gait"] in GAITS and units is not None:
                parts.append(mark(row["gait"], across(min(units, promised)), y))
    x = LEFT - 40
    for gait in GAITS:
        parts += [mark(gait, x, 10), label(x + 10, 14, f"{gait} gait", "start")]
        x += 135
    title = f"Largest error of {len(families)} families of cases, in units; {promised:g} are promised"
    picture = (
        f'<svg viewBox="0 0 {WIDTH} {bottom + 42}" width="{WIDTH}" height="{bottom + 42}" role="img"'
        f' aria-label="{text(title)}"><g fill="currentColor">{"".join(parts)}</g></svg>'
    )
    return element("div", picture, class_="plot column", role="group", aria_label=title)
