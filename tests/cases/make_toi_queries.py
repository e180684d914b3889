#!/usr/bin/env python3
"""Writes toi_queries.json: vertices against faces and edges against edges, with exact first times.

Another road than the library's: fractions instead of whole numbers, Sturm's sequences instead of
Descartes' rule, and the inside test with products of normals instead of areas along an axis.
  make_toi_queries.py [--check]    writes the file beside this script, or compares it
Coordinates and times are written as hexadecimal doubles; a time is the exact one rounded down.
"""
import json
import math
import pathlib
import random
import sys
from fractions import Fraction as F

# --- Polynomials: lists of fractions, the constant first, the last one not zero


def trim(p):
    while p and p[-1] == 0:
        p = p[:-1]
    return p


def add(p, q, factor=1):
    n = max(len(p), len(q))
    at = lambda c, i: c[i] if i < len(c) else F(0)
    return trim([at(p, i) + factor * at(q, i) for i in range(n)])


def sub(p, q):
    return add(p, q, -1)


def mul(p, q):
    r = [F(0)] * max(len(p) + len(q) - 1, 0)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            r[i + j] += a * b
    return trim(r)


def value(p, t):
    v = F(0)
    for c in reversed(p):
        v = v * t + c
    return v


def divide(p, q):
    quotient = [F(0)] * max(len(p) - len(q) + 1, 0)
    while len(p) >= len(q):
        f, shift = p[-1] / q[-1], len(p) - len(q)
        quotient[shift] = f
        p = trim([c - f * q[i - shift] if i >= shift else c for i, c in enumerate(p)][:-1])
    return quotient, p


def gcd(p, q):
    while q:
        p, q = q, divide(p, q)[1]
    return p


def slope(p):
    return trim([i * c for i, c in enumerate(p)][1:])


def sturm(p):
    chain = [p, slope(p)]
    while chain[-1]:
        chain.append([-c for c in divide(chain[-2], chain[-1])[1]])
    return chain[:-1]


def count(chain, a, b):
    """Roots in (a, b] of a polynomial without multiple roots."""

    def changes(t):
        signs = [v > 0 for v in (value(p, t) for p in chain) if v != 0]
        return sum(x != y for x, y in zip(signs, signs[1:]))

    return changes(a) - changes(b)


class Root:
    def __init__(self, chain, a, b):
        self.chain, self.a, self.b = chain, a, b  # the only root in (a, b]

    def halve(self):
        m = (self.a + self.b) / 2
        if count(self.chain, self.a, m):
            self.b = m
        else:
            self.a = m

    def sign(self, q):
        if not q:
            return 0
        common = gcd(self.chain[0], q)
        if len(common) > 1 and count(sturm(common), self.a, self.b):
            return 0
        q_simple = divide(q, gcd(q, slope(q)))[0] if len(q) > 1 else q
        chain = sturm(q_simple)
        while len(q) > 1 and (value(q, self.b) == 0 or count(chain, self.a, self.b)):
            self.halve()
        return 1 if value(q, self.b) > 0 else -1

    def rounded_down(self):
        """The largest double that is not above the root."""
        while self.b - self.a > F(1, 2**70):
            self.halve()
        t = float(self.b)
        above = lambda t: self.sign([-F(t), F(1)]) < 0
        while above(t):
            t = math.nextafter(t, -1)
        while not above(math.nextafter(t, 2)):
            t = math.nextafter(t, 2)
        return t


def roots(p):
    simple = divide(p, gcd(p, slope(p)))[0] if len(p) > 1 else p
    chain = sturm(simple)
    found, todo = [], [(F(-1), F(1))]
    while todo:
        a, b = todo.pop()
        n = count(chain, a, b)
        if n == 1:
            root = Root(chain, a, b)
            if root.sign([F(0), F(1)]) >= 0:
                found.append(root)
        elif n > 1:
            todo += [((a + b) / 2, b), (a, (a + b) / 2)]
    return found


# --- Geometry: vectors of polynomials


def minus(u, v):
    return [sub(a, b) for a, b in zip(u, v)]


def dot(u, v):
    total = []
    for a, b in zip(u, v):
        total = add(total, mul(a, b))
    return total


def cross(u, v):
    return [sub(mul(u[(k + 1) % 3], v[(k + 2) % 3]), mul(u[(k + 2) % 3], v[(k + 1) % 3]))
            for k in range(3)]


def on_segment(root, p, x, y):
    if any(root.sign(c) for c in cross(minus(p, x), minus(y, x))):
        return False
    return root.sign(dot(minus(p, x), minus(p, y))) <= 0


def meets(kind, points, root):
    """Do they meet at a time at which all four are in a plane?"""
    a, b, c, d = points
    if kind == "vertex-face":
        n = cross(minus(c, b), minus(d, b))
        if root.sign(dot(n, n)) == 0:
            return any(on_segment(root, a, x, y) for x, y in ((b, c), (c, d), (d, b)))
        return all(root.sign(dot(cross(minus(y, x), minus(a, x)), n)) >= 0
                   for x, y in ((b, c), (c, d), (d, b)))
    n = cross(minus(b, a), minus(d, c))
    nn = dot(n, n)
    if root.sign(nn) == 0:
        return (on_segment(root, a, c, d) or on_segment(root, b, c, d) or
                on_segment(root, c, a, b) or on_segment(root, d, a, b))
    s, t = dot(cross(minus(c, a), minus(d, c)), n), dot(cross(minus(c, a), minus(b, a)), n)
    return all(root.sign(x) >= 0 and root.sign(sub(nn, x)) >= 0 for x in (s, t))


def first_time(kind, start, end):
    points = [[trim([F(s), F(e) - F(s)]) for s, e in zip(p, q)] for p, q in zip(start, end)]
    a, b, c, d = points
    volume = dot(minus(b, a), cross(minus(c, a), minus(d, a)))
    if volume:
        candidates = [volume]
    else:
        candidates = [[F(0), F(1)]]  # the start
        sides = ([(a, b, c), (a, c, d), (a, d, b)] if kind == "vertex-face" else
                 [(a, c, d), (b, c, d), (c, a, b), (d, a, b)])
        for p, x, y in sides:
            candidates += [q for q in cross(minus(p, x), minus(y, x)) if q]
            candidates += [q for q in [dot(minus(p, x), minus(p, y))] if q]
    times = []
    for p in candidates:
        for root in roots(p):
            if meets(kind, points, root):
                times.append(root.rounded_down())
                break
    return min(times, default=None)


# --- Queries


def grid(rng, n):
    return [[float(rng.randint(0, n)) for _ in range(3)] for _ in range(8)]


def anywhere(rng):
    return [[rng.uniform(-1, 1) for _ in range(3)] for _ in range(8)]


def in_plane(rng):
    u, v = ([float(rng.randint(-2, 2)) for _ in range(3)] for _ in range(2))
    rows = []
    for _ in range(8):
        s, t = rng.randint(-3, 3), rng.randint(-3, 3)
        rows.append([s * x + t * y for x, y in zip(u, v)])
    return rows


def thin(rng):
    rows = anywhere(rng)
    height = 10.0 ** -rng.randint(4, 17)
    return [[x, y, 0.7 + height * z] for x, y, z in rows]


def sharing(rng):
    rows = grid(rng, 5) if rng.random() < 0.5 else anywhere(rng)
    rows[rng.choice([0, 4])] = list(rows[rng.choice([3, 7])])
    return rows


def grazing(rng):
    rows = anywhere(rng)
    t, s = rng.choice([0.25, 0.5, 1.0, rng.random()]), rng.choice([0.0, 0.5, rng.random()])
    at = [[(1 - t) * x + t * y for x, y in zip(rows[i], rows[i + 4])] for i in range(4)]
    aim = [(1 - s) * x + s * y for x, y in zip(at[1], at[2])]
    off = rng.choice([0.0, 1e-16, 1e-14])
    rows[4] = [p + (x + off * rng.uniform(-1, 1) - p) / max(t, 0.05) for p, x in zip(rows[0], aim)]
    return rows


FAMILIES = [("anywhere", anywhere, 40), ("grid of 3", lambda r: grid(r, 2), 60),
            ("grid of 8", lambda r: grid(r, 7), 60), ("in a plane", in_plane, 40),
            ("thin", thin, 40), ("sharing a point", sharing, 40), ("grazing", grazing, 40)]


def make(scale=1, seed=7):
    queries = []
    for name, family, n in FAMILIES:
        rng = random.Random(f"{name} {seed}")
        for i in range(n * scale):
            rows = family(rng)
            for kind in ("vertex-face", "edge-edge"):
                time = first_time(kind, rows[:4], rows[4:])
                queries.append({"family": name, "kind": kind,
                                "points": [x.hex() for row in rows for x in row],
                                "time": None if time is None else time.hex()})
    # Of what never comes near anything a few are enough.
    kept, misses = [], {}
    for q in queries:
        key = (q["family"], q["kind"])
        if q["time"] is None:
            misses[key] = misses.get(key, 0) + 1
            if misses[key] > 12 * scale:
                continue
        kept.append(q)
    return kept


def text(queries):
    about = ("Vertices against faces (point 0; points 1 to 3) and edges against edges (0, 1; 2, 3), "
             "which move in straight lines from the first four points to the last four. The time "
             "of the first contact is exact, rounded down; null: none. Hexadecimal doubles. "
             "Written by make_toi_queries.py with fractions.")
    rows = ",\n  ".join(json.dumps(q, separators=(",", ":")) for q in queries)
    return '{"about": ' + json.dumps(about) + ',\n "queries": [\n  ' + rows + "\n ]}\n"


def main():
    file = pathlib.Path(__file__).with_name("toi_queries.json")
    fresh = text(make())
    if "--check" in sys.argv:
        if file.read_text() != fresh:
            sys.exit("toi_queries.json is not what make_toi_queries.py writes")
        return
    file.write_text(fresh)


if __name__ == "__main__":
    main()
