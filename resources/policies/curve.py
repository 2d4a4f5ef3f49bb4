#!/usr/bin/env python3
"""Draws the training curves of policies: `curve.py A.csv B.csv -o curve.svg`."""

import argparse
import csv
from pathlib import Path

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 640, 260, 48, 16, 16, 40
COLORS = ("#2F6FDE", "#D9822B", "#3C8C4E")


def text(x, y, words, anchor="middle", color="#5A6370"):
    """An SVG text."""
    return f'<text x="{x:.0f}" y="{y:.0f}" text-anchor="{anchor}" fill="{color}">{words}</text>'


def points(rows, longest):
    """Places of the share of successful episodes against the rounds."""
    for index, row in enumerate(rows):
        if row["success"] != "nan":
            x = LEFT + (WIDTH - LEFT - RIGHT) * index / max(1, longest - 1)
            yield x, HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * float(row["success"])


def picture(curves):
    """The SVG of {name: rows}."""
    longest = max(len(rows) for rows in curves.values())
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
             'font-family="sans-serif" font-size="12">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#FFFFFF"/>']
    for percent in range(0, 101, 20):
        y = HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * percent / 100
        parts += [f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#E3E6EA"/>',
                  text(LEFT - 6, y + 4, f"{percent} %", "end")]
    for number in range(0, longest, 5):
        x = LEFT + (WIDTH - LEFT - RIGHT) * number / max(1, longest - 1)
        parts.append(text(x, HEIGHT - BOTTOM + 16, number + 1))
    parts.append(text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 8, "round"))
    for color, (name, rows) in zip(COLORS, curves.items()):
        places = list(points(rows, longest))
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        index = list(curves).index(name)
        first = sum(row["phase"] == "imitation" for row in rows) - 1
        x = LEFT + (WIDTH - LEFT - RIGHT) * (first + 0.5) / max(1, longest - 1)
        parts += [f'<polyline points="{line}" fill="none" stroke="{color}" stroke-width="2"/>',
                  f'<path d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="{color}" '
                  'stroke-dasharray="3 3"/>',
                  text(WIDTH - RIGHT - 8, HEIGHT - BOTTOM - 30 + 16 * index, name, "end", color)]
    return "\n".join([*parts, "</svg>"]) + "\n"


def main():
    """Reads the curves and writes the picture."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("curves", nargs="+", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=Path("curve.svg"))
    options = parser.parse_args()
    curves = {}
    for path in options.curves:
        with path.open(encoding="utf-8", newline="") as file:
            curves[path.stem] = list(csv.DictReader(file))
    options.output.write_text(picture(curves), encoding="utf-8")


if __name__ == "__main__":
    main()
