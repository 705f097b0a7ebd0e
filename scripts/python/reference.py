#!/usr/bin/python3
"""Reference values, 50 digits each, for the two-body crawler with dry friction.

Model.  Bodies 1 and 2 have masses m1, m2 and Coulomb friction forces F1, F2 (equal
in both directions, static equal to sliding).  Their separation l(t) = x2 - x1 has
period T: it grows from 0 to L during the extension, of duration alpha*T, and falls
to 0 during the contraction, of duration (1 - alpha)*T.  With tau the duration of
such a phase and sg = +1 (extension) or -1 (contraction) the two gaits are

    quadratic:   l'' = sg*4L/tau^2 in the first half, -sg*4L/tau^2 in the second;
    sinusoidal:  l'  = sg*(L/2)(pi/tau) sin(pi t/tau).

Let M = m1 + m2, c the velocity of the centre of mass, b1 = -m2/M and b2 = m1/M.
Then v_i = c + b_i l', and

    both slide:    c' = -(F1 s1 + F2 s2)/M with s_i = sgn(v_i);
    body i rests:  c = -b_i l', while |h_i| <= F_i, where
                   h_i = M b_i l'' - F_j s_j, and j is the other body.

A body whose velocity reaches zero stays at rest if |h_i| <= F_i, and otherwise
moves on in the direction of h_i; so does a resting body when |h_i| exceeds F_i.

Method.  All is computed with 120 digits in plain laboratory variables, following
the motion from event to event.  While both bodies slide, v_i is monotone between
the known times where its acceleration vanishes; so each such stretch holds at most
one zero of v_i and none is missed.  The steady motion is the fixed point of the
period map P.  As P(v) - v does not increase with v, its root can be bracketed.

Columns.  Inputs; for a phase started with velocity v0: time t1 of the first change
of mode, time dT from the last change to the end, end velocity, displacement dxC of
(x1 + x2)/2; for the steady motion: velocity at the start and end of the extension,
displacement per period; the modes, that is the signs of v1 and v2 (0: at rest).
cond_q is the sum over the inputs p of |p dq/dp|, not divided by q: each input is
changed by 1e-30 of itself to both sides and the larger effect counts.  A value near
1e30 times the size of q, or inf, means that q jumps here.

Usage:  reference.py                          print the whole table
        reference.py --check FILE --every N   recompute every N-th row of FILE
"""

import argparse
import math
import multiprocessing
import random
import re
import sys

from mpmath import mp, mpf

mp.dps = 120
TINY = mpf(10) ** -105      # velocities below TINY * L/tau are rounding errors
SNAP = mpf(10) ** -85       # outputs below SNAP * (their unit) are zero
STEP = mpf(10) ** -30       # relative change of inputs for the condition numbers

INPUTS = ("m1", "m2", "F1", "F2", "L", "T", "alpha", "v0")
PHASE_OUT = ("t1", "dT", "v_end", "dxC")
OUTPUTS = PHASE_OUT + ("v_start", "v_mid", "displacement")
LABELS = ("family", "kind", "gait", "phase")
COLUMNS = (LABELS[:3] + INPUTS[:7] + ("phase", "v0") + OUTPUTS + ("modes",)
           + tuple("cond_" + q for q in OUTPUTS))

class QuadraticPiece:
    """One half of a quadratic phase: l'' is constant."""
    def __init__(self, sg, L, tau, second):
        self.acc = sg * 4 * L / tau ** 2 * (-1 if second else 1)
        self.end = tau if second else tau / 2
        self.zero = tau if second else mpf(0)         # where l' vanishes
    def rate(self, t):
        return self.acc * (t - self.zero)
    def accel(self, t):
        return self.acc
    def change(self, t, u):
        return self.acc * ((u - self.zero) ** 2 - (t - self.zero) ** 2) / 2
    def times_of_accel(self, a):
        return []

class SinePiece:
    """A whole sinusoidal phase."""
    def __init__(self, sg, L, tau):
        self.end, self.w, self.half = tau, mp.pi / tau, sg * L / 2
    def rate(self, t):
        return self.half * self.w * mp.sin(self.w * t)
    def accel(self, t):
        return self.half * self.w ** 2 * mp.cos(self.w * t)
    def change(self, t, u):
        return self.half * (mp.cos(self.w * t) - mp.cos(self.w * u))
    def times_of_accel(self, a):
        cosine = a / (self.half * self.w ** 2)
        return [mp.acos(cosine) / self.w] if abs(cosine) <= 1 else []

def monotone_root(f, slope, lo, hi, tol):
    """The zero of f, which decreases from f(lo) > 0 to f(hi) < 0: Newton's method
    inside the bracket, with bisection when it leaves the bracket or is slow.  For
    a linear f (the quadratic gait) a Newton step is the closed formula."""
    t, last = (lo + hi) / 2, hi - lo
    while last > tol:
        value, s = f(t), slope(t)
        lo, hi = (t if value >= 0 else lo), (t if value <= 0 else hi)
        new = t - value / s if s != 0 else lo - 1
        if not lo <= new <= hi or abs(new - t) > last / 2:
            new = (lo + hi) / 2
        t, last = new, abs(new - t)
    return t

class Phase:
    """The motion during one phase that starts with the velocity v0."""
    def __init__(self, p, gait, sg, v0):
        self.sg, self.F, self.M = sg, (p["F1"], p["F2"]), p["m1"] + p["m2"]
        self.b = (-p["m2"] / self.M, p["m1"] / self.M)
        self.tau = p["T"] * (p["alpha"] if sg > 0 else 1 - p["alpha"])
        self.tiny = TINY * p["L"] / self.tau
        self.t, self.c, self.dxC, self.changes = mpf(0), v0, mpf(0), []
        args = sg, p["L"], self.tau
        pieces = ([SinePiece(*args)] if gait == "sinusoidal" else
                  [QuadraticPiece(*args, False), QuadraticPiece(*args, True)])
        self.mode = self.first_mode(pieces[0])
        self.modes = [self.mode]
        for piece in pieces:
            self.march(piece)
        self.text = " ".join("-0+"[i + 1] + "-0+"[j + 1] for i, j in self.modes)
        self.v_end = self.c if abs(self.c) > self.tiny else mpf(0)
        self.t1 = self.changes[0] if self.changes else mp.nan
        self.dT = self.tau - self.changes[-1] if self.changes else mp.nan

    def state_at_zero(self, i, piece, may_rest=True):
        """Sign of the velocity of body i just after it is zero; 0 if it rests."""
        other_sign = self.sg if i == 0 else -self.sg
        h = self.M * self.b[i] * piece.accel(self.t) - self.F[1 - i] * other_sign
        return 0 if may_rest and abs(h) <= self.F[i] else (1 if h > 0 else -1)

    def first_mode(self, piece):
        if abs(self.c) > self.tiny:
            return (1, 1) if self.c > 0 else (-1, -1)
        self.c = mpf(0)
        if self.state_at_zero(0, piece) == 0:
            return (0, self.sg)
        return (-self.sg, 0 if self.state_at_zero(1, piece) == 0 else self.sg)

    def set_state(self, i, state):
        if state != self.mode[i]:
            self.mode = (state, self.mode[1]) if i == 0 else (self.mode[0], state)
            self.modes.append(self.mode)
            self.changes.append(self.t)

    def march(self, piece):
        if 0 in self.mode:                                 # l'' may have jumped
            i = self.mode.index(0)
            self.set_state(i, self.state_at_zero(i, piece))
        while self.t < piece.end:
            rests = 0 in self.mode
            when, i = self.release(piece) if rests else self.stop(piece)
            self.advance(piece, when)
            if i is not None:
                self.c = -self.b[i] * piece.rate(self.t)   # v_i = 0 exactly
                self.set_state(i, self.state_at_zero(i, piece, may_rest=not rests))

    def drag(self):
        return (self.F[0] * self.mode[0] + self.F[1] * self.mode[1]) / self.M

    def advance(self, piece, t):
        dl, h = piece.change(self.t, t), t - self.t
        if 0 in self.mode:
            b = self.b[self.mode.index(0)]
            shift, self.c = -b * dl, -b * piece.rate(t)
        else:
            a = self.drag()
            shift, self.c = self.c * h - a * h ** 2 / 2, self.c - a * h
        self.dxC += shift + (self.b[0] + self.b[1]) / 2 * dl
        self.t = t

    def release(self, piece):
        """Next time at which the force needed to hold the resting body is F_i."""
        i = self.mode.index(0)
        other = self.F[1 - i] * self.mode[1 - i]
        found = [(t, i) for limit in (self.F[i], -self.F[i])
                 for t in piece.times_of_accel((limit + other) / (self.M * self.b[i]))
                 if self.t < t < piece.end]
        return min(found, default=(piece.end, None))

    def stop(self, piece):
        """Next time at which a sliding body comes to zero velocity."""
        found = [(t, i) for i in (0, 1) for t in self.zeros(piece, i)]
        return min(found, default=(piece.end, None))

    def zeros(self, piece, i):
        """The first zero of v_i, if there is one, as a list."""
        a, b, s, t0, c0 = self.drag(), self.b[i], self.mode[i], self.t, self.c

        def speed(t):
            return s * (c0 - a * (t - t0) + b * piece.rate(t))
        def slope(t):
            return s * (b * piece.accel(t) - a)

        tol, lo = self.tau * mpf(10) ** -112, t0
        turns = [t for t in piece.times_of_accel(a / b)
                 if t0 + self.tau * mpf(10) ** -100 < t < piece.end]
        for hi in turns + [piece.end]:
            if speed(hi) < -self.tiny:
                return [monotone_root(speed, slope, lo, hi, tol) if speed(lo) > 0 else lo]
            lo = hi
        return []

def period(p, gait, v0):
    ext = Phase(p, gait, 1, v0)
    return ext, Phase(p, gait, -1, ext.v_end)

def bracket(g, v, width):
    """Velocities a <= b with g(a) >= 0 >= g(b), searched from v outwards."""
    side, u = (1 if g(v) > 0 else -1), v
    while side * g(u) > 0:
        v, u, width = u, u + side * width, 16 * width
    return min(u, v), max(u, v)

def bracketed_root(g, a, b, tol):
    """Ridders' method, each step of which at least halves the bracket."""
    ga, gb, x, last = g(a), g(b), a, b
    while ga > 0 > gb and abs(x - last) > tol:
        m = (a + b) / 2
        gm = g(m)
        last, x = x, m + (m - a) * gm / mp.sqrt(gm ** 2 - ga * gb)
        points = [(a, ga), (m, gm), (x, g(x)), (b, gb)]
        a, ga = max(point for point in points if point[1] >= 0)
        b, gb = min(point for point in points if point[1] <= 0)
    return a if ga == 0 else b if gb == 0 else x

def steady(p, gait, guess):
    """Start velocity of the steady motion; guess is close to it, or None."""
    def g(v):
        return period(p, gait, v)[1].v_end - v
    unit = p["L"] / p["T"]
    a, b = bracket(g, guess or mpf(0), unit * (1 if guess is None else mpf(10) ** -25))
    v = bracketed_root(g, a, b, unit * mpf(10) ** -95)
    v = v if abs(v) >= SNAP * unit else mpf(0)
    if not g(v - SNAP * unit) >= 0 >= g(v + SNAP * unit):
        raise ArithmeticError("the steady state is not bracketed")
    return v

def exact_inputs(case):
    return {n: mpf(case[n]) for n in INPUTS if n in case}

def outputs(case, p, guess=None):
    """Outputs of a case, and its modes, with the inputs p."""
    if case["kind"] == "phase":
        run = Phase(p, case["gait"], 1 if case["phase"] == "ext" else -1, p["v0"])
        return {q: getattr(run, q) for q in PHASE_OUT}, run.text
    v = steady(p, case["gait"], guess)
    ext, con = period(p, case["gait"], v)
    values = {"v_start": v, "v_mid": ext.v_end, "displacement": ext.dxC + con.dxC}
    return values, ext.text + " | " + con.text

def difference(x, y):
    return (abs(x - y), mp.inf, mpf(0))[mp.isnan(x) + mp.isnan(y)]

def conditions(case, p, values):
    """Sum over the inputs of |p dq/dp|, for every output q."""
    total = {q: mpf(0) for q in values}
    for name in p:
        sides = [outputs(case, {**p, name: p[name] * (1 + s * STEP)},
                         values.get("v_start"))[0] for s in (1, -1)]
        for q in values:
            total[q] += max(difference(x[q], values[q]) for x in sides) / STEP
    return total

def unit_of(q, p):
    return p["L"] / p["T"] if q[0] == "v" else p["T"] if q in ("t1", "dT") else p["L"]

def digits(x, n, zero):
    return "0" if abs(x) < zero else mp.nstr(x, n, strip_zeros=False).lstrip("+")

def row_text(case):
    p = exact_inputs(case)
    values, modes = outputs(case, p)
    cond = conditions(case, p, values)
    fields = {n: case[n] for n in LABELS if n in case}
    fields.update({n: case[n].hex() for n in p}, modes=modes)
    for q in values:
        fields[q] = digits(values[q], 50, SNAP * unit_of(q, p))
        fields["cond_" + q] = digits(cond[q], 3, SNAP / STEP * unit_of(q, p))
    return "\t".join(fields.get(c, "-") for c in COLUMNS)

# Number of quadratic and of sinusoidal cases, both for 'steady' and for 'phase'.
FAMILIES = {"ordinary": (30, 12), "stick-slip": (30, 18), "mass-ratio": (30, 12),
            "force-ratio": (30, 12), "mass-force-ratio": (30, 12), "small-T": (30, 12),
            "near-equal-F": (30, 12), "near-half-alpha": (24, 10),
            "near-symmetric": (24, 10), "edge-alpha": (30, 12), "equal-F": (8, 4),
            "half-alpha": (12, 6), "symmetric": (4, 3)}
DEFAULT = dict(m1=1.0, m2=1.0, F1=4.0, F2=1.0, L=10.0, T=1.0, alpha=0.75)

def spread(rng, lo, hi):
    return math.exp(rng.uniform(math.log(lo), math.log(hi)))

def draw_inputs(rng, family):
    near = [1 + rng.choice((-1, 1)) * 10.0 ** -rng.randint(1, 12) for _ in (0, 1)]
    near = near if family.startswith("near") else (1, 1)
    c = {n: spread(rng, 0.3, 3.0) for n in ("m1", "m2", "F1", "F2")}
    c.update(L=rng.uniform(1, 20), T=spread(rng, 0.05, 3), alpha=rng.uniform(0.1, 0.9))
    if family in ("mass-ratio", "mass-force-ratio"):
        c["m1"] = c["m2"] * spread(rng, 1e-6, 1e6)
    if family in ("force-ratio", "mass-force-ratio"):
        c["F1"] = c["F2"] * spread(rng, 1e-6, 1e6)
    if family in ("near-equal-F", "near-symmetric", "equal-F", "symmetric"):
        c["F1"] = c["F2"] * near[0]
    if family in ("near-half-alpha", "near-symmetric", "half-alpha", "symmetric"):
        c["alpha"] = 0.5 * near[1]
    if family == "small-T":
        c["T"] = spread(rng, 1e-8, 1e-2)
    if family == "edge-alpha":
        small = spread(rng, 1e-4, 1e-2)
        c["alpha"] = rng.choice((1e-4, 1 - 1e-4, small, 1 - small))
    if family == "stick-slip":                 # T^2 (F1 + F2)/(M L) from 1 to 60
        unit = math.sqrt((c["m1"] + c["m2"]) * c["L"] / (c["F1"] + c["F2"]))
        c["T"] = unit * math.sqrt(spread(rng, 1, 60))
    return c

def draw_velocity(rng, c, k):
    tau = c["T"] * (c["alpha"] if c["phase"] == "ext" else 1 - c["alpha"])
    size = spread(rng, *((1e-6, 0.1) if k % 3 == 1 else (0.1, 3))) * c["L"] / tau
    if c["family"] == "small-T" and k % 3 == 1:
        size = spread(rng, 0.1, 10)
    return rng.choice((-1, 1)) * size if k % 6 else 0.0

def draw_case(rng, family, kind, gait, k):
    """Odd cases of the stick-slip family are drawn until body 1 or 2, in turn,
    comes to rest (quadratic) or is released inside a phase (sinusoidal)."""
    wanted = ("0[-+]", "[-+]0")[k // 2 % 2] + (" [-+]" if gait == "sinusoidal" else "")
    while True:
        c = dict(draw_inputs(rng, family), family=family, kind=kind, gait=gait)
        if kind == "phase":
            c["phase"] = rng.choice(("ext", "con"))
            c["v0"] = draw_velocity(rng, c, k)
        free = family != "stick-slip" or k % 2 == 0
        if free or re.search(wanted, outputs(c, exact_inputs(c))[1]):
            return c

def all_cases():
    cases = [dict(DEFAULT, family="default", kind="steady", gait=gait)
             for gait in ("quadratic", "sinusoidal")]
    for family, counts in FAMILIES.items():
        for gait, count in zip(("quadratic", "sinusoidal"), counts):
            for kind in ("steady", "phase"):
                rng = random.Random(" ".join((family, gait, kind)))
                cases += [draw_case(rng, family, kind, gait, k) for k in range(count)]
    return cases

def compute(cases):
    values, _ = outputs(dict(kind="steady", gait="quadratic"), exact_inputs(DEFAULT))
    assert abs(values["v_start"] - mpf("3.016620657688953")) < 1e-15
    assert abs(values["displacement"] - mpf("3.241212215329884")) < 1e-15
    with multiprocessing.Pool(2) as pool:
        return pool.map(row_text, cases, chunksize=4)

def print_table():
    print("# Reference values for the two-body crawler, made by scripts/python/reference.py,"
          " which explains model and columns.")
    print("# Inputs are exact doubles (C hexadecimal); outputs have 50 significant"
          " digits; '-' does not apply, nan does not exist.")
    print("# cond_q is the sum over the inputs p of |p dq/dp| (absolute).")
    print("\t".join(COLUMNS))
    print("\n".join(compute(all_cases())))

def case_of(row):
    fields = dict(zip(COLUMNS, row.split("\t")))
    case = {n: fields[n] for n in LABELS if fields[n] != "-"}
    case.update((n, float.fromhex(fields[n])) for n in INPUTS if fields[n] != "-")
    return case

def check(name, every):
    with open(name) as f:
        header, *rows = [x.rstrip("\n") for x in f if not x.startswith("#")]
    if header != "\t".join(COLUMNS) or not rows:
        sys.exit("%s: not the expected header row, or no data" % name)
    if any(row.count("\t") != header.count("\t") for row in rows):
        sys.exit("%s: a row has the wrong number of columns" % name)
    rows = rows[::every]
    for old, new in zip(rows, compute([case_of(row) for row in rows])):
        for column, x, y in zip(COLUMNS, old.split("\t"), new.split("\t")):
            if x != y:
                sys.exit("%s: %s is %s but should be %s in the row\n%s"
                         % (name, column, x, y, old))
    print("%d rows agree" % len(rows))

if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", metavar="FILE")
    parser.add_argument("--every", metavar="N", type=int, default=1)
    args = parser.parse_args()
    check(args.check, max(args.every, 1)) if args.check else print_table()
