#!/usr/bin/env python3
# Copyright (c) 2026  The Hierarchical Parameterization authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what time_to_energy printed, seconds over triangles, or energy_over_time, energies over seconds. Both axes are
logarithmic.
"""
import csv
import math
import sys

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 760, 480, 70, 270, 30, 50
TIME_COLUMNS = {"method", "run", "threads", "triangles", "seconds", "unit_seconds"}
ENERGY_COLUMNS = {"method", "run", "seconds", "relative_excess"}
USAGE = "usage: draw_curves.py RUN.csv ... > curves.svg"
COLORS = ["#1b6ca8", "#c8553d", "#588157", "#8e5572", "#bc8a2f", "#4a4e69", "#2a9d8f", "#9a031e"]


def read_curves(files):
    """Maps the name of a curve to its points, and returns the names of both axes, too."""
    curves = {}
    axes = set()
    for file in files:
        try:
            axes.add(add_file(curves, file))
        except OSError as error:
            sys.exit(f"error: {file}: {error.strerror}")
        except (ValueError, csv.Error) as error:
            sys.exit(f"error: {file}: {error}")
    if len(axes) > 1:
        sys.exit("error: one picture cannot show runs of both time_to_energy and energy_over_time")
    return curves, axes.pop()


def add_file(curves, file):
    with open(file, newline="") as lines:
        rows = csv.DictReader(lines, restval="")
        columns = set(rows.fieldnames or [])
        if columns >= TIME_COLUMNS:
            add, axes = add_time, ("triangles", "seconds")
        elif columns >= ENERGY_COLUMNS:
            add, axes = add_energy, ("seconds", "energy above the optimum / excess of the optimum")
        else:
            raise ValueError("lacks the columns of time_to_energy and of energy_over_time")
        for row in rows:
            add(curves, row)
    return axes


def add_time(curves, row):
    if row["seconds"]:
        threads = "" if row["threads"] == "1" else f", {row['threads']} threads"
        name = f"{row['method']}, {row['run']}{threads}"
        triangles = positive(row["triangles"])
        curves.setdefault(name, {})[triangles] = positive(row["seconds"])
        curves.setdefault("one direct factorization (the unit)", {})[triangles] = positive(row["unit_seconds"])


def add_energy(curves, row):
    if float(row["relative_excess"]) > 0:
        name = f"{row['method']}, {row['run']}"
        curves.setdefault(name, {})[positive(row["seconds"])] = positive(row["relative_excess"])


def positive(text):
    value = float(text)
    if not 0 < value < math.inf:
        raise ValueError(f"{text} has no place on a logarithmic axis")
    return value


def powers_of_ten(low, high):
    return [10.0 ** k for k in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)]


def label(value):
    return f"{value:,.0f}" if value >= 1 else f"{value:g}"


def draw(curves, x_name, y_name):
    x_ticks = powers_of_ten(min(min(c) for c in curves.values()), max(max(c) for c in curves.values()))
    y_ticks = powers_of_ten(min(min(c.values()) for c in curves.values()),
                            max(max(c.values()) for c in curves.values()))

    def place(value, ticks, begin, end):
        low, high = math.log(ticks[0]), math.log(ticks[-1])
        return begin + (end - begin) * (math.log(value) - low) / ((high - low) or 1)

    def x(value):
        return place(value, x_ticks, LEFT, WIDTH - RIGHT)

    def y(value):
        return place(value, y_ticks, HEIGHT - BOTTOM, TOP)

    yield (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
           'font-family="sans-serif" font-size="12">')
    yield f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    for tick in x_ticks:
        yield f'<path d="M{x(tick):.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>'
        yield f'<text x="{x(tick):.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{label(tick)}</text>'
    for tick in y_ticks:
        yield f'<path d="M{LEFT} {y(tick):.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>'
        yield f'<text x="{LEFT - 8}" y="{y(tick) + 4:.1f}" text-anchor="end">{label(tick)}</text>'
    yield f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 12}" text-anchor="middle">{x_name}</text>'
    yield f'<text x="{LEFT}" y="{TOP - 12}" text-anchor="start">{y_name}</text>'
    for i, (name, curve) in enumerate(curves.items()):
        color = COLORS[i % len(COLORS)]
        points = [(x(t), y(s)) for t, s in sorted(curve.items())]
        yield (f'<polyline points="{" ".join(f"{a:.1f},{b:.1f}" for a, b in points)}" fill="none" '
               f'stroke="{color}" stroke-width="2"/>')
        for a, b in points:
            yield f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3" fill="{color}"/>'
        legend_y = TOP + 12 + 22 * i
        yield f'<path d="M{WIDTH - RIGHT + 16} {legend_y}h20" stroke="{color}" stroke-width="2"/>'
        yield f'<text x="{WIDTH - RIGHT + 42}" y="{legend_y + 4}">{name}</text>'
    yield "</svg>"


def main():
    files = sys.argv[1:]
    if files in (["-h"], ["--help"]):
        print(__doc__ + USAGE)
        return
    if not files or any(file.startswith("-") for file in files):
        sys.exit(USAGE)
    curves, axes = read_curves(files)
    if not curves:
        sys.exit("error: no finished run in " + ", ".join(files))
    print("\n".join(draw(curves, *axes)))


if __name__ == "__main__":
    main()
