"""Drawing of places as ROS maps: walls, doors and furniture in metres, written as PGM and YAML."""

import math
import os

RESOLUTION = 0.05  # [m] per cell
FREE, INSIDE, WALL = 254, 205, 0  # grey values: free, inside of furniture (unknown), occupied


class Place:
    """A rectangle of free floor, from (0, 0) to (width, height), and the things that stand on it."""

    def __init__(self, name, width, height, text, outer=0.2):
        self.name, self.text = name, text
        self.width, self.height = width, height
        self.columns, self.rows = round(width / RESOLUTION), round(height / RESOLUTION)
        self.cells = bytearray([FREE]) * (self.columns * self.rows)
        self.points = {}
        if outer > 0.0:
            self.rect(0, 0, width, outer)
            self.rect(0, height - outer, width, height)
            self.rect(0, 0, outer, height)
            self.rect(width - outer, 0, width, height)

    # -- shapes -----------------------------------------------------------------------------------

    def span(self, low, high, most):
        """Cells whose centres lie between two coordinates."""
        first = math.ceil(low / RESOLUTION - 0.5 - 1e-9)
        last = math.ceil(high / RESOLUTION - 0.5 - 1e-9)
        return range(max(0, first), min(most, last))

    def rect(self, x0, y0, x1, y1, value=WALL):
        columns = self.span(min(x0, x1), max(x0, x1), self.columns)
        for j in self.span(min(y0, y1), max(y0, y1), self.rows):
            start = j * self.columns
            for i in columns:
                self.cells[start + i] = value

    def clear(self, x0, y0, x1, y1):
        self.rect(x0, y0, x1, y1, FREE)

    def disc(self, x, y, radius, value=WALL):
        for j in self.span(y - radius, y + radius, self.rows):
            for i in self.span(x - radius, x + radius, self.columns):
                dx, dy = (i + 0.5) * RESOLUTION - x, (j + 0.5) * RESOLUTION - y
                if dx * dx + dy * dy <= radius * radius:
                    self.cells[j * self.columns + i] = value

    def polygon(self, corners, value=WALL):
        """A convex polygon, corners counter-clockwise."""
        xs, ys = [c[0] for c in corners], [c[1] for c in corners]
        edges = list(zip(corners, corners[1:] + corners[:1]))
        for j in self.span(min(ys), max(ys), self.rows):
            for i in self.span(min(xs), max(xs), self.columns):
                x, y = (i + 0.5) * RESOLUTION, (j + 0.5) * RESOLUTION
                if all((bx - ax) * (y - ay) - (by - ay) * (x - ax) >= -1e-9
                       for (ax, ay), (bx, by) in edges):
                    self.cells[j * self.columns + i] = value

    def turned(self, x, y, length, width, angle, value=WALL):
        """A rectangle with this centre; `angle` [rad] is the direction of its length."""
        c, s = math.cos(angle), math.sin(angle)
        self.polygon([(x + c * a - s * b, y + s * a + c * b)
                      for a, b in ((-length / 2, -width / 2), (length / 2, -width / 2),
                                   (length / 2, width / 2), (-length / 2, width / 2))], value)

    # -- building ---------------------------------------------------------------------------------

    def wall(self, x0, y0, x1, y1, thickness=0.15):
        """A wall along an axis."""
        half = thickness / 2
        self.rect(min(x0, x1) - half, min(y0, y1) - half, max(x0, x1) + half, max(y0, y1) + half)

    def door(self, x, y, width, along, thickness=0.3):
        """An opening in a wall that runs along "x" or "y"; its centre becomes a point."""
        a, b = (width / 2, thickness / 2) if along == "x" else (thickness / 2, width / 2)
        self.clear(x - a, y - b, x + a, y + b)

    def glass(self, x0, y0, x1, y1):
        self.wall(x0, y0, x1, y1, 0.1)

    def column(self, x, y, size=0.4):
        self.rect(x - size / 2, y - size / 2, x + size / 2, y + size / 2)

    # -- furniture --------------------------------------------------------------------------------

    def block(self, x0, y0, x1, y1):
        """Solid furniture: an outline that is filled with grey."""
        self.rect(x0, y0, x1, y1)
        edge = RESOLUTION
        if min(abs(x1 - x0), abs(y1 - y0)) > 5 * edge:
            self.rect(min(x0, x1) + edge, min(y0, y1) + edge,
                      max(x0, x1) - edge, max(y0, y1) - edge, INSIDE)

    def turned_block(self, x, y, length, width, angle):
        self.turned(x, y, length, width, angle)
        self.turned(x, y, length - 0.14, width - 0.14, angle, INSIDE)

    def round_table(self, x, y, radius=0.4, chairs=4, turn=0.0, seat=0.17):
        self.disc(x, y, radius)
        self.disc(x, y, radius - 0.06, INSIDE)
        for k in range(chairs):
            a = turn + 2 * math.pi * k / chairs
            self.disc(x + (radius + seat + 0.08) * math.cos(a),
                      y + (radius + seat + 0.08) * math.sin(a), seat)

    def table(self, x, y, length=1.4, width=0.8, chairs=2, along="x"):
        """A table with chairs on both long sides."""
        a, b = (length / 2, width / 2) if along == "x" else (width / 2, length / 2)
        self.block(x - a, y - b, x + a, y + b)
        for k in range(chairs):
            t = (k + 0.5) / chairs * length - length / 2
            for side in (-1, 1):
                s = side * (width / 2 + 0.22)
                cx, cy = (x + t, y + s) if along == "x" else (x + s, y + t)
                self.rect(cx - 0.18, cy - 0.18, cx + 0.18, cy + 0.18)

    def desk(self, x, y, facing):
        """A desk of 1.6 x 0.8 m with a chair on the side `facing` (n, s, e, w)."""
        dx, dy = {"n": (0, 1), "s": (0, -1), "e": (1, 0), "w": (-1, 0)}[facing]
        a, b = (0.8, 0.4) if dy else (0.4, 0.8)
        self.block(x - a, y - b, x + a, y + b)
        self.disc(x + 0.65 * dx, y + 0.65 * dy, 0.22)

    def bed(self, x, y, head):
        """A bed of 2.0 x 0.95 m with a pillow at the end `head` (n, s, e, w)."""
        dx, dy = {"n": (0, 1), "s": (0, -1), "e": (1, 0), "w": (-1, 0)}[head]
        a, b = (0.48, 1.0) if dy else (1.0, 0.48)
        self.block(x - a, y - b, x + a, y + b)
        px, py = x + 0.7 * dx, y + 0.7 * dy
        self.rect(px - (0.35 if dy else 0.2), py - (0.2 if dy else 0.35),
                  px + (0.35 if dy else 0.2), py + (0.2 if dy else 0.35))

    def shelf(self, x0, y0, x1, y1):
        """A shelf with two sides: a block with a partition along its length."""
        self.block(x0, y0, x1, y1)
        if abs(x1 - x0) >= abs(y1 - y0):
            self.rect(x0, (y0 + y1) / 2 - 0.03, x1, (y0 + y1) / 2 + 0.03)
        else:
            self.rect((x0 + x1) / 2 - 0.03, y0, (x0 + x1) / 2 + 0.03, y1)

    def sofa(self, x0, y0, x1, y1, back):
        """A sofa whose back is at the side `back` (n, s, e, w)."""
        self.block(x0, y0, x1, y1)
        d = 0.2
        sides = {"n": (x0, y1 - d, x1, y1), "s": (x0, y0, x1, y0 + d),
                 "e": (x1 - d, y0, x1, y1), "w": (x0, y0, x0 + d, y1)}
        self.rect(*sides[back])

    def plant(self, x, y, radius=0.25):
        self.disc(x, y, radius)
        self.disc(x, y, radius * 0.45, INSIDE)

    def seats(self, x, y, count, along="x", double=False):
        """A row of seats with arm rests; with `double` back to back."""
        pitch, depth = 0.55, 0.5
        for k in range(count):
            t = k * pitch
            for row in range(2 if double else 1):
                r = row * (depth + 0.05)
                x0, y0 = (x + t, y + r) if along == "x" else (x + r, y + t)
                dx, dy = (pitch - 0.1, depth) if along == "x" else (depth, pitch - 0.1)
                self.block(x0, y0, x0 + dx, y0 + dy)
        length = count * pitch - 0.1
        depth = 2 * depth + 0.05 if double else depth
        bar = 0.04
        if along == "x":  # the beam below the seats: people cannot walk between them
            self.rect(x, y + depth / 2 - bar, x + length, y + depth / 2 + bar)
        else:
            self.rect(x + depth / 2 - bar, y, x + depth / 2 + bar, y + length)

    def point(self, name, x, y, heading=0.0):
        """A named free point with a heading, for starts and goals."""
        self.points[name] = (x, y, heading)

    # -- tests ------------------------------------------------------------------------------------

    def is_free(self, x, y, radius):
        for j in self.span(y - radius, y + radius, self.rows):
            for i in self.span(x - radius, x + radius, self.columns):
                dx, dy = (i + 0.5) * RESOLUTION - x, (j + 0.5) * RESOLUTION - y
                if dx * dx + dy * dy <= radius * radius and self.cells[j * self.columns + i] != FREE:
                    return False
        return radius <= x <= self.width - radius and radius <= y <= self.height - radius

    def reachable(self, x, y, radius=0.4, step=0.2):
        """All points of a raster that a disc can reach from here."""
        start = (round(x / step), round(y / step))
        seen, waiting = {start}, [start]
        while waiting:
            i, j = waiting.pop()
            for di, dj in ((1, 0), (-1, 0), (0, 1), (0, -1)):
                next_ = (i + di, j + dj)
                if next_ not in seen and self.is_free(next_[0] * step, next_[1] * step, radius):
                    seen.add(next_)
                    waiting.append(next_)
        return {(round(i * step, 3), round(j * step, 3)) for i, j in seen}

    def check(self):
        """Every point must be free and reachable from the first one."""
        names = list(self.points)
        reach = None
        for name in names:
            x, y, _ = self.points[name]
            assert self.is_free(x, y, 0.4), f"{self.name}: {name} at {x}, {y} is not free"
            if reach is None:
                reach = self.reachable(round(x / 0.2) * 0.2, round(y / 0.2) * 0.2, 0.35)
            near = min(math.hypot(x - a, y - b) for a, b in reach)
            assert near < 0.4, f"{self.name}: {name} at {x}, {y} cannot be reached"

    # -- files ------------------------------------------------------------------------------------

    def write(self, folder):
        os.makedirs(folder, exist_ok=True)
        rows = [bytes(self.cells[j * self.columns:(j + 1) * self.columns])
                for j in reversed(range(self.rows))]
        with open(os.path.join(folder, self.name + ".pgm"), "wb") as file:
            file.write(b"P5\n%d %d\n255\n" % (self.columns, self.rows) + b"".join(rows))
        with open(os.path.join(folder, self.name + ".yaml"), "w", encoding="utf-8") as file:
            file.write(f"# {self.text}\nimage: {self.name}.pgm\nmode: trinary\n"
                       f"resolution: {RESOLUTION}\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
                       "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
