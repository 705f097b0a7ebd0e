"""The crawler in motion: what CSS needs to move its bodies along a table of positions."""
STROKE = 100  # pixels of the picture that L is long
SECONDS = 2.5  # that a period takes on the page


def easing(values):
    """Equally spaced values as an easing function: those of linear() may leave the range from 0 to 1."""
    return "linear(" + ",".join(f"{value:.3f}".rstrip("0").rstrip(".") for value in values) + ")"


def style(table, kinematics):
    """Rules for .KINEMATICS .body1, .body2 and .rod; where nothing moves, they show the pair apart, at the end of an extension."""
    rows = table.where(kinematics=kinematics)
    seconds = SECONDS * (float(rows[-1]["t_over_T"]) - float(rows[0]["t_over_T"]))
    apart = max(reversed(range(len(rows))), key=lambda i: float(rows[i]["l_over_L"]))
    rules = []
    for part, column, moved in (
        ("body1", "x1_over_L", "translateX({}px)"),
        ("body2", "x2_over_L", "translateX({}px)"),
        ("rod", "l_over_L", "scaleX({})"),
    ):
        whole = STROKE if moved.startswith("t") else 1
        values, name = [float(row[column]) for row in rows], f"{kinematics}-{part}"
        rules.append(
            f"@keyframes {name}{{from{{transform:{moved.format(0)}}}to{{transform:{moved.format(whole)}}}}}\n"
            f".{kinematics} .{part}{{transform:{moved.format(round(whole * values[apart], 3))};"
            f"animation:{name} {seconds:g}s {easing(values)} infinite}}\n"
        )
    return "".join(rules)


def marks(table, kinematics):
    """Where the centre is when a period begins, in pixels."""
    return [STROKE * float(row["xC_over_L"]) for row in table.where(kinematics=kinematics) if float(row["t_over_T"]) % 1 == 0]
