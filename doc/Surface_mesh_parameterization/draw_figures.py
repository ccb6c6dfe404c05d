#!/usr/bin/env python3
# Copyright (c) 2026  The Hierarchical Parameterization authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the manual's figures into fig/: schemes, whose geometry is computed as the package computes it. With the paths of
the programs hierarchical_parameterization and paper_figures as arguments, also their maps of the built-in face, by rsvg-convert."""

import math
import pathlib
import re
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent / "fig"

LIGHT, SHADE, MARK, INK = "#f7f7f0", "#f4c79a", "#960a1e", "#222"


class Drawing:
    """SVG panels side by side, each with a box of the plane that is scaled to it."""

    PANEL, TOP, BOTTOM = 300, 20, 56

    def __init__(self, number_of_panels):
        self.number_of_panels = number_of_panels
        self.parts = []

    def panel(self, index, points, title):
        xs, ys = [p[0] for p in points], [p[1] for p in points]
        margin = 34
        self.scale = (self.PANEL - 2 * margin) / max(max(xs) - min(xs), max(ys) - min(ys))
        self.origin = (self.PANEL * (index + 0.5) - self.scale * (max(xs) + min(xs)) / 2, self.TOP + self.PANEL / 2 + self.scale * (max(ys) + min(ys)) / 2)
        for i, line in enumerate(title):
            self.text((self.PANEL * (index + 0.5), self.TOP + self.PANEL + 16 + 17 * i), line)

    def at(self, p):
        return self.origin[0] + self.scale * p[0], self.origin[1] - self.scale * p[1]

    def polygon(self, points, fill="none", stroke=INK, width=1.2, dash=""):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in map(self.at, points))
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<polygon points="{path}" fill="{fill}" stroke="{stroke}" stroke-width="{width}" stroke-linejoin="round"{dashes}/>')

    def line(self, p, q, stroke=INK, width=1.2, dash=""):
        (x1, y1), (x2, y2) = self.at(p), self.at(q)
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{stroke}" stroke-width="{width}"{dashes}/>')

    def dot(self, p, fill=INK, radius=3.5):
        x, y = self.at(p)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{fill}"/>')

    def name(self, p, away_from, letter, index="", color=INK):
        (x, y), (cx, cy) = self.at(p), self.at(away_from)
        length = math.hypot(x - cx, y - cy) or 1
        self.text((x + 15 * (x - cx) / length, y + 15 * (y - cy) / length + 5), letter, index, color)

    def text(self, place, text, index="", color=INK):
        sub = f'<tspan dy="4" font-size="10">{index}</tspan>' if index != "" else ""
        self.parts.append(f'<text x="{place[0]:.1f}" y="{place[1]:.1f}" text-anchor="middle" fill="{color}">{text}{sub}</text>')

    def write(self, name):
        width, height = self.PANEL * self.number_of_panels, self.TOP + self.PANEL + self.BOTTOM
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
                'font-family="sans-serif" font-size="13">\n<rect width="100%" height="100%" fill="white"/>\n')
        (FOLDER / name).write_text(head + "\n".join(self.parts) + "\n</svg>\n")


def subtract(p, q):
    return tuple(a - b for a, b in zip(p, q))


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


def angle(p, q):
    return math.acos(sum(a * b for a, b in zip(p, q)) / math.hypot(*p) / math.hypot(*q))


def combine(points, coordinates):
    return tuple(sum(c * p[i] for c, p in zip(coordinates, points)) for i in range(2))


def barycentric(p, a, b, c):
    area = cross(subtract(b, a), subtract(c, a))
    return (cross(subtract(b, p), subtract(c, p)) / area, cross(subtract(c, p), subtract(a, p)) / area, cross(subtract(a, p), subtract(b, p)) / area)


def discrete_exponential_map(v, ring):
    """The ring around the origin: lengths kept, angles scaled to one full turn."""
    edges = [subtract(w, v) for w in ring]
    angles = [angle(edges[i], edges[(i + 1) % len(ring)]) for i in range(len(ring))]
    result, direction = [], 0.0
    for edge, a in zip(edges, angles):
        result.append((math.hypot(*edge) * math.cos(direction), math.hypot(*edge) * math.sin(direction)))
        direction += 2 * math.pi * a / sum(angles)
    return result


def kernel(polygon):
    """The points from which all of a counter-clockwise polygon is seen: a box, clipped by the half-plane of each edge."""
    result = [(-9, -9), (9, -9), (9, 9), (-9, 9)]
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        clipped = []
        for r, s in zip(result, result[1:] + result[:1]):
            at_r, at_s = cross(subtract(q, p), subtract(r, p)), cross(subtract(q, p), subtract(s, p))
            if at_r >= 0:
                clipped.append(r)
            if at_r * at_s < 0:
                clipped.append(combine((r, s), (at_s / (at_s - at_r), at_r / (at_r - at_s))))
        result = clipped
    return result


def centroid(polygon):
    """Of the area."""
    a = polygon[0]
    triangles = [(cross(subtract(b, a), subtract(c, a)), combine((a, b, c), (1 / 3, 1 / 3, 1 / 3))) for b, c in zip(polygon[1:], polygon[2:])]
    total = sum(area for area, _ in triangles)
    return tuple(sum(area * middle[i] for area, middle in triangles) / total for i in range(2))


def draw_star(drawing, center, ring):
    for i, w in enumerate(ring):
        drawing.polygon((center, w, ring[(i + 1) % len(ring)]), LIGHT)


def draw_names(drawing, center, ring):
    for i, w in enumerate(ring):
        drawing.dot(w)
        drawing.name(w, center, "W", i)


def draw_collapse():
    v = (0.05, -0.1, 0.75)
    polar = [(0.0, 1.0, 0.0), (0.9, 1.25, 0.1), (1.75, 0.9, -0.1), (2.7, 1.2, 0.15), (3.7, 1.0, 0.0), (4.6, 1.15, -0.15), (5.5, 1.0, 0.1)]
    ring = [(r * math.cos(a - 1.0), r * math.sin(a - 1.0), z) for a, r, z in polar]

    def project(p):     # seen from the front and above
        return p[0] + 0.12 * p[1], 0.62 * p[1] + 0.78 * p[2]

    drawing = Drawing(3)
    flat_v, flat_ring = project(v), [project(w) for w in ring]
    drawing.panel(0, flat_ring + [flat_v], ("The star of V in space",))
    draw_star(drawing, flat_v, flat_ring)
    draw_names(drawing, flat_v, flat_ring)
    drawing.dot(flat_v, MARK)
    drawing.text((drawing.at(flat_v)[0] + 14, drawing.at(flat_v)[1] - 6), "V", color=MARK)

    plane = discrete_exponential_map(v, ring)
    turn = math.radians(-57)    # as in the first panel
    plane = [(x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)) for x, y in plane]
    origin = (0.0, 0.0)
    drawing.panel(1, plane, ("Discrete exponential map: lengths", "kept, angles scaled to one full turn"))
    draw_star(drawing, origin, plane)
    draw_names(drawing, origin, plane)
    drawing.dot(origin, MARK)
    drawing.text((drawing.at(origin)[0] + 4, drawing.at(origin)[1] - 10), "V", color=MARK)

    fans = [(plane[0], plane[i], plane[i + 1]) for i in range(1, len(plane) - 1)]
    parent = max(range(len(fans)), key=lambda i: min(barycentric(origin, *fans[i])))
    assert all(cross(subtract(b, a), subtract(c, a)) > 0 for a, b, c in fans), "the fan must be positive"
    drawing.panel(2, plane, ("Collapsed onto W₀: V is in its parent triangle,", "V = ρ W₀ + σ W%s + τ W%s" % ("₀₁₂₃₄₅₆"[parent + 1], "₀₁₂₃₄₅₆"[parent + 2])))
    for i, fan in enumerate(fans):
        drawing.polygon(fan, SHADE if i == parent else LIGHT)
    for w in fans[parent]:
        drawing.line(origin, w, MARK, 1, "4 3")
    draw_names(drawing, origin, plane)
    drawing.dot(origin, MARK)
    drawing.text((drawing.at(origin)[0] + 4, drawing.at(origin)[1] - 10), "V", color=MARK)
    drawing.write("collapse.svg")


def draw_insertion():
    ring = [(0.0, 0.0), (3.4, -0.9), (2.2, 0.7), (4.0, 2.7), (1.7, 2.1), (0.2, 3.4), (-0.6, 1.6)]
    fans = [(ring[0], ring[i], ring[i + 1]) for i in range(1, len(ring) - 1)]
    assert all(cross(subtract(b, a), subtract(c, a)) > 0 for a, b, c in fans), "the fan must be positive"
    stored = combine(fans[2], (0.25, 0.45, 0.3))
    seen = kernel(ring)
    place = centroid(seen)
    is_inside = all(cross(subtract(q, p), subtract(stored, p)) > 0 for p, q in zip(ring, ring[1:] + ring[:1]))
    assert not is_inside, "the stored place must lie outside of the kernel"
    middle = centroid(ring)

    drawing = Drawing(3)
    drawing.panel(0, ring, ("Coarse map: the fan of W₀, and the", "place that ρ, σ, τ give"))
    for i, fan in enumerate(fans):
        drawing.polygon(fan, SHADE if i == 2 else LIGHT)
    draw_names(drawing, middle, ring)
    drawing.dot(stored, MARK)

    drawing.panel(1, ring, ("With V there the shaded triangles", "are flipped"))
    edges = list(zip(ring, ring[1:] + ring[:1]))
    flipped = [(w, u) for w, u in edges if cross(subtract(u, w), subtract(stored, w)) <= 0]
    for w, u in [edge for edge in edges if edge not in flipped] + flipped:      # these on top, as they overlap others
        drawing.polygon((stored, w, u), SHADE if (w, u) in flipped else LIGHT, width=1.0)
    drawing.polygon(ring, width=2)
    draw_names(drawing, middle, ring)
    drawing.dot(stored, MARK)

    drawing.panel(2, ring, ("The kernel of the star polygon reaches W₀;", "V goes to its centroid"))
    draw_star(drawing, place, ring)
    drawing.polygon(seen, SHADE, MARK, 1, "4 3")
    for w in ring:
        drawing.line(place, w)
    drawing.polygon(ring, width=2)
    draw_names(drawing, middle, ring)
    drawing.dot(place, MARK)
    drawing.write("insertion.svg")


def draw_nested_iteration():
    drawing = Drawing(3)
    drawing.origin, drawing.scale = (0, 0), 1
    levels = ["n", "n−1", "n−2", "0"]
    lefts, rights, ys = [70 + 70 * i for i in range(4)], [830 - 70 * i for i in range(4)], [34 + 92 * i for i in range(4)]
    for level, left, right, y in zip(levels, lefts, rights, ys):
        for x, what, fill in ((left, "mesh", LIGHT), (right, "map", SHADE)):
            drawing.polygon([(x - 66, 17 - y), (x + 66, 17 - y), (x + 66, -17 - y), (x - 66, -17 - y)], fill)
            drawing.text((x, y + 5), f"{what} of level {level}")
    for i in range(3):
        dash = "5 4" if i == 2 else ""
        drawing.line((lefts[i] + 10, -17 - ys[i]), (lefts[i] + 60, -75 - ys[i]), dash=dash)
        drawing.line((rights[i] - 60, -75 - ys[i]), (rights[i] - 10, -17 - ys[i]), MARK, dash=dash)
        drawing.text((lefts[i] + 112, ys[i] + 50), "collapse group")
        drawing.text((rights[i] - 112, ys[i] + 50), "insert, refine", color=MARK)
    drawing.line((lefts[3] + 66, -ys[3]), (rights[3] - 66, -ys[3]), MARK)
    drawing.text((450, ys[3] - 8), "first map, refine", color=MARK)
    drawing.write("nested_iteration.svg")


def write_montage(name, pictures):
    """Puts SVG files, given with their titles, side by side and renders them."""
    width, height = 240, 300
    parts = []
    for i, (picture, title) in enumerate(pictures):
        parts.append(re.sub("<svg ", f'<svg x="{i * width + 8}" y="6" width="{width - 16}" height="{height - 40}" ', picture.read_text(), count=1))
        parts.append(f'<text x="{(i + 0.5) * width}" y="{height - 12}" text-anchor="middle">{title}</text>')
    montage = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{len(pictures) * width}" height="{height}" font-family="sans-serif" font-size="13">'
               '<rect width="100%" height="100%" fill="white"/>' + "\n".join(parts) + "</svg>\n")
    subprocess.run(["rsvg-convert", "-o", FOLDER / name], input=montage.encode(), check=True)


def draw_methods(program, folder):
    methods = [("mips", "MIPS: angles"), ("symmetric-dirichlet", "symmetric Dirichlet: lengths"), ("mean-value", "mean value, on a circle"),
               ("shape-preserving", "shape preserving, on a circle")]
    for method, _ in methods:
        subprocess.run([program, "--method", method, "--picture", folder / f"{method}.svg", "--quiet"], check=True)
    write_montage("methods.png", [(folder / f"{method}.svg", title) for method, title in methods])


def read_obj(path):
    """The texture coordinates of the vertices, and the triangles."""
    uv, triangles = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["vt"]:
            uv.append((float(words[1]), float(words[2])))
        elif words[:1] == ["f"]:
            triangles.append([int(w.split("/")[0]) - 1 for w in words[1:]])
    return uv, triangles


def border(triangles):
    """The vertices on the border, counter-clockwise."""
    edges = {(t[i], t[(i + 1) % 3]) for t in triangles for i in range(3)}
    following = {v: w for v, w in edges if (w, v) not in edges}
    loop = [min(following)]
    while following[loop[-1]] != loop[0]:
        loop.append(following[loop[-1]])
    return loop


def draw_constraints(program, folder):
    """The face with a free border, with some of its vertices held, and with its border on a circle and on a star."""
    free = folder / "free.obj"
    run = [program, "--method", "symmetric-dirichlet", "--quiet"]
    subprocess.run([*run, "--output", free, "--picture", folder / "free.svg"], check=True)
    uv, triangles = read_obj(free)
    loop = border(triangles)
    center = centroid([uv[v] for v in loop])
    radius = max(math.dist(uv[v], center) for v in loop)

    def place(v, scale):
        angle = math.atan2(uv[v][1] - center[1], uv[v][0] - center[0])
        r = radius * scale(angle)
        return center[0] + r * math.cos(angle), center[1] + r * math.sin(angle)

    nearest = min(range(len(uv)), key=lambda v: math.dist(uv[v], center))
    held = {
        "held": {**{v: uv[v] for v in loop[::8]}, nearest: (center[0] + radius / 8, center[1] + radius / 16)},
        "circle": {v: place(v, lambda angle: 0.9) for v in loop},
        "star": {v: place(v, lambda angle: 0.9 + 0.25 * math.cos(5 * angle)) for v in loop},
    }
    for name, places in held.items():
        file = folder / f"{name}.txt"
        file.write_text("".join(f"{v} {x!r} {y!r}\n" for v, (x, y) in places.items()))
        subprocess.run([*run, "--hold", file, "--picture", folder / f"{name}.svg"], check=True)
    titles = [("free", "free"), ("held", "some vertices held"), ("circle", "border on a circle"), ("star", "border on a star")]
    write_montage("constraints.png", [(folder / f"{name}.svg", title) for name, title in titles])


def draw_steps(paper_figures, folder):
    subprocess.run([paper_figures, folder, "--steps", "40000"], check=True)
    write_montage("steps.png", [(folder / f"{name}_map.svg", name) for name in ("optimal", "hierarchical", "conventional")])


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    draw_collapse()
    draw_insertion()
    draw_nested_iteration()
    if len(sys.argv) == 3:
        with tempfile.TemporaryDirectory() as temporary:
            draw_methods(sys.argv[1], pathlib.Path(temporary))
            draw_constraints(sys.argv[1], pathlib.Path(temporary))
            draw_steps(sys.argv[2], pathlib.Path(temporary))
