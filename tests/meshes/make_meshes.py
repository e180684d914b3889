#!/usr/bin/env python3
"""Makes the mesh files in this folder, and expected.json with their exact mass properties.

    python3 make_meshes.py            write the files beside this script
    python3 make_meshes.py --check    compare the files with what the script would write

The shapes: a gear with a bore, a die with rounded edges, a twisted bracket, a torus, and a tube along a
trefoil knot. Every coordinate is a multiple of 2^-18 m, so that it is a float as well as a double, that no
C library's sine changes a file, and that the mass properties are rational numbers (density 1, computed with
fractions by the surface integrals of Eberly 2002). Only the standard library is needed.
"""
import json
import math
import struct
import sys
from fractions import Fraction
from pathlib import Path

GRID = 2 ** 18


def snap(point):
    return tuple(round(x * GRID) / GRID for x in point)


def gear(teeth=18, height=0.25):
    """A hollow prism: trapezoid teeth outside, a round bore inside."""
    outer, inner = [], []
    for tooth in range(teeth):
        for part, radius in enumerate((0.82, 1.0, 1.0, 0.82)):
            angle = 2 * math.pi * (tooth + (0.0, 0.18, 0.42, 0.6)[part]) / teeth
            outer.append((radius * math.cos(angle), radius * math.sin(angle)))
            inner.append((0.3 * math.cos(angle), 0.3 * math.sin(angle)))
    vertices, faces, n = [], [], len(outer)
    for (x, y), (u, v) in zip(outer, inner):
        vertices += [(x, y, -height / 2), (x, y, height / 2), (u, v, -height / 2), (u, v, height / 2)]
    for i in range(n):
        a, b = 4 * i, 4 * ((i + 1) % n)
        faces += [(a, b, b + 1, a + 1), (a + 2, a + 3, b + 3, b + 2),
                  (a + 1, b + 1, b + 3, a + 3), (a, a + 2, b + 2, b)]
    return vertices, faces


def die(steps=10, half=0.5, rounding=0.15):
    """A cube whose edges and corners are rounded: each point is pushed out from an inner cube."""
    index, vertices, faces = {}, [], []

    def vertex(q):
        if q not in index:
            p = [half * (2 * x / steps - 1) for x in q]
            core = [max(-half + rounding, min(half - rounding, x)) for x in p]
            d = [x - c for x, c in zip(p, core)]
            length = math.sqrt(sum(x * x for x in d))
            index[q] = len(vertices)
            vertices.append(tuple(c + rounding * x / length for c, x in zip(core, d)))
        return index[q]

    for axis in range(3):
        for side in (0, steps):
            for i in range(steps):
                for j in range(steps):
                    corners = []
                    for u, v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        q = [0, 0, 0]
                        q[axis], q[(axis + 1) % 3], q[(axis + 2) % 3] = side, u, v
                        corners.append(vertex(tuple(q)))
                    faces.append(tuple(corners if side else reversed(corners)))
    return vertices, faces


def bracket(layers=24, height=1.5, twist=math.pi / 3):
    """An L profile drawn along z while it turns."""
    profile = [(0, 0), (1, 0), (1, 0.2), (0.2, 0.2), (0.2, 0.8), (0, 0.8)]
    n, vertices, faces = len(profile), [], []
    for layer in range(layers + 1):
        c, s = math.cos(twist * layer / layers), math.sin(twist * layer / layers)
        vertices += [(c * x - s * y, s * x + c * y, height * layer / layers) for x, y in profile]
    for layer in range(layers):
        for i in range(n):
            a, b = layer * n + i, layer * n + (i + 1) % n
            faces += [(a, b, b + n), (a, b + n, a + n)]
    cap = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]
    faces += [(a, c, b) for a, b, c in cap]
    faces += [tuple(layers * n + v for v in face) for face in cap]
    return vertices, faces


def tube(curve, radius, around, across):
    """A tube along a closed curve. The frame of a cut is turned as little as possible, and the rest spread."""
    def sub(a, b): return [x - y for x, y in zip(a, b)]
    def dot(a, b): return sum(x * y for x, y in zip(a, b))
    def unit(a): return [x / math.sqrt(dot(a, a)) for x in a]
    def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    points = [curve(2 * math.pi * i / around) for i in range(around)]
    tangents = [unit(sub(points[(i + 1) % around], points[i - 1])) for i in range(around)]

    def carried(normal, tangent):
        return unit(sub(normal, [dot(normal, tangent) * t for t in tangent]))

    normals = [carried([0, 0, 1] if abs(tangents[0][2]) < 0.9 else [1, 0, 0], tangents[0])]
    for i in range(1, around):
        normals.append(carried(normals[-1], tangents[i]))
    back = carried(normals[-1], tangents[0])  # after one round the frame has turned by this angle
    rest = math.atan2(dot(cross(normals[0], back), tangents[0]), dot(normals[0], back))

    vertices, faces = [], []
    for i in range(around):
        binormal = cross(tangents[i], normals[i])
        for j in range(across):
            v = 2 * math.pi * j / across - rest * i / around
            vertices.append(tuple(p + radius * (math.cos(v) * n + math.sin(v) * b)
                                  for p, n, b in zip(points[i], normals[i], binormal)))
    for i in range(around):
        for j in range(across):
            a, b = i * across + j, i * across + (j + 1) % across
            c, d = (i + 1) % around * across + (j + 1) % across, (i + 1) % around * across + j
            faces += [(a, b, c), (a, c, d)]
    return vertices, faces


def triangles_of(faces):
    return [(f[0], f[k], f[k + 1]) for f in faces for k in range(1, len(f) - 1)]


def number(x):
    return repr(x)


def write_off(vertices, faces):
    lines = ["OFF", "# a gear with a bore", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(map(number, v)) for v in vertices]
    lines += [" ".join(map(str, (len(f),) + tuple(f))) for f in faces]
    return ("\n".join(lines) + "\n").encode()


def write_obj(vertices, faces):
    lines = ["# a die with rounded edges, in squares", "o die"]
    lines += ["v " + " ".join(map(number, v)) for v in vertices]
    lines += ["vn 0 0 1", "s off"]
    lines += ["f " + " ".join(f"{i + 1}//1" for i in f) for f in faces]
    return ("\n".join(lines) + "\n").encode()


def normal_of(a, b, c):
    u, w = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    n = (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])
    length = math.sqrt(sum(x * x for x in n))
    return tuple(round(x / length, 4) + 0.0 for x in n)


def write_stl_ascii(vertices, faces):
    lines = ["solid bracket"]
    for f in triangles_of(faces):
        corners = [vertices[i] for i in f]
        lines += ["facet normal " + " ".join(map(number, normal_of(*corners))), " outer loop"]
        lines += ["  vertex " + " ".join(map(number, v)) for v in corners]
        lines += [" endloop", "endfacet"]
    return ("\n".join(lines + ["endsolid bracket"]) + "\n").encode()


def write_stl_binary(vertices, faces):
    triangles = triangles_of(faces)
    data = b"a twisted bracket, binary".ljust(80, b" ") + struct.pack("<I", len(triangles))
    for f in triangles:
        corners = [vertices[i] for i in f]
        data += struct.pack("<12fH", *normal_of(*corners), *(x for v in corners for x in v), 0)
    return data


def ply_header(kind, vertices, faces):
    return "\n".join(["ply", f"format {kind} 1.0", "comment made by make_meshes.py",
                      f"element vertex {len(vertices)}", "property double x", "property double y",
                      "property double z", f"element face {len(faces)}",
                      "property list uchar int vertex_indices", "end_header"]) + "\n"


def write_ply_ascii(vertices, faces):
    lines = [" ".join(map(number, v)) for v in vertices]
    lines += [" ".join(map(str, (len(f),) + tuple(f))) for f in faces]
    return (ply_header("ascii", vertices, faces) + "\n".join(lines) + "\n").encode()


def write_ply_binary(vertices, faces):
    data = ply_header("binary_little_endian", vertices, faces).encode()
    data += b"".join(struct.pack("<3d", *v) for v in vertices)
    return data + b"".join(struct.pack(f"<B{len(f)}i", len(f), *f) for f in faces)


def decimal(x, digits=25):
    """A fraction rounded to so many significant digits."""
    if x == 0:
        return "0"
    exponent = math.floor(math.log10(abs(x)))
    scaled = round(x * Fraction(10) ** (digits - 1 - exponent))
    text = str(abs(scaled))
    return f"{'-' if scaled < 0 else ''}{text[0]}.{text[1:]}e{exponent + len(text) - digits}"


def mass_properties(vertices, faces):
    volume, first, square, product = Fraction(0), [Fraction(0)] * 3, [Fraction(0)] * 3, [Fraction(0)] * 3
    triangles = triangles_of(faces)
    for f in triangles:
        p = [[Fraction(x) for x in vertices[i]] for i in f]
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            n = (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j])
            w = [corner[i] for corner in p]
            f1 = sum(w)
            f2 = w[0] * w[0] + w[1] * (w[0] + w[1]) + w[2] * f1
            f3 = w[0] ** 3 + w[1] * (w[0] * w[0] + w[1] * (w[0] + w[1])) + w[2] * f2
            if i == 0:
                volume += n * f1 / 6
            first[i] += n * f2 / 24
            square[i] += n * f3 / 60
            product[i] += n * sum(q[j] * (f2 + q[i] * (f1 + q[i])) for q in p) / 120
    assert volume > 0
    center = [x / volume for x in first]
    square = [s - volume * c * c for s, c in zip(square, center)]
    inertia = [[Fraction(0)] * 3 for _ in range(3)]
    for i in range(3):
        j = (i + 1) % 3
        inertia[i][i] = square[j] + square[(i + 2) % 3]
        inertia[i][j] = inertia[j][i] = volume * center[i] * center[j] - product[i]
    return {"triangles": len(triangles), "volume": decimal(volume), "center": [decimal(x) for x in center],
            "inertia": [[decimal(x) for x in row] for row in inertia]}


def all_files():
    def trefoil(t):
        return (0.3 * (math.sin(t) + 2 * math.sin(2 * t)), 0.3 * (math.cos(t) - 2 * math.cos(2 * t)),
                -0.3 * math.sin(3 * t))

    shapes = {"gear": gear(), "die": die(), "bracket": bracket(),
              "torus": tube(lambda t: (math.cos(t), math.sin(t), 0), 0.3, 36, 18),
              "knot": tube(trefoil, 0.12, 120, 14)}
    shapes = {name: ([snap(v) for v in vertices], faces) for name, (vertices, faces) in shapes.items()}
    files, expected = {}, {}
    for file, shape, writer in (("gear.off", "gear", write_off), ("die.obj", "die", write_obj),
                                ("bracket.stl", "bracket", write_stl_binary),
                                ("bracket_ascii.stl", "bracket", write_stl_ascii),
                                ("torus.ply", "torus", write_ply_ascii),
                                ("knot.ply", "knot", write_ply_binary)):
        files[file] = writer(*shapes[shape])
        expected[file] = mass_properties(*shapes[shape])
    files["expected.json"] = (json.dumps(expected, indent=1) + "\n").encode()
    return files


def main():
    folder = Path(__file__).resolve().parent
    different = []
    for name, data in all_files().items():
        if "--check" in sys.argv:
            if not (folder / name).exists() or (folder / name).read_bytes() != data:
                different.append(name)
        else:
            (folder / name).write_bytes(data)
    for name in different:
        print(f"{name} is not what make_meshes.py writes", file=sys.stderr)
    sys.exit(1 if different else 0)


if __name__ == "__main__":
    main()
