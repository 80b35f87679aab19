# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes that engineers bring, in millimetres: machined parts, sheets, assemblies.

Each function returns (points, faces). A part is made of blocks of a lattice that are bent into
place, some with a round hole: rings of quads between circle and square, as a CAD mesher makes them.
"""
import math
import random


# --- blocks --------------------------------------------------------------------------------------
def square_side(cell, axis, upper, divisions):
    """A side of a block as a grid of points, rows along the axis after next."""
    u, v = (axis + 1) % 3, (axis + 2) % 3
    nu, nv = divisions[u][cell[u]], divisions[v][cell[v]]

    def point(a, b):
        at = [0.0, 0.0, 0.0]
        at[axis], at[u], at[v] = cell[axis] + upper, cell[u] + a / nu, cell[v] + b / nv
        return tuple(at)

    return [[point(a, b) for a in range(nu + 1)] for b in range(nv + 1)]


def rim(grid):
    """The points around a grid, counter-clockwise from its first."""
    return (grid[0][:-1] + [row[-1] for row in grid[:-1]] + grid[-1][:0:-1]
            + [row[0] for row in grid[:0:-1]])


def circle(cell, axis, upper, radius, count):
    """As many points around the middle of a block's side, the first towards its first corner."""
    points = []
    for i in range(count):
        angle = 2.0 * math.pi * i / count - 0.75 * math.pi
        at = [c + 0.5 for c in cell]
        at[axis] = cell[axis] + upper
        at[(axis + 1) % 3] += radius * math.cos(angle)
        at[(axis + 2) % 3] += radius * math.sin(angle)
        points.append(tuple(at))
    return points


def ring(outer, inner):
    n = len(outer)
    return [[outer[i], outer[(i + 1) % n], inner[(i + 1) % n], inner[i]] for i in range(n)]


def side(cell, axis, upper, divisions, hole):
    """Quads of one side of a block, counter-clockwise seen against the axis."""
    grid = square_side(cell, axis, upper, divisions)
    if hole and hole[0] == axis:
        outer = rim(grid)
        return ring(outer, circle(cell, axis, upper, hole[1], len(outer)))
    return [[low[a], low[a + 1], high[a + 1], high[a]]
            for low, high in zip(grid, grid[1:]) for a in range(len(low) - 1)]


def wall(cell, axis, radius, divisions):
    """Quads of a hole's wall, facing the hole's middle."""
    count = len(rim(square_side(cell, axis, 0, divisions)))
    return ring(circle(cell, axis, 1, radius, count), circle(cell, axis, 0, radius, count))


def numbered(quads, place):
    """Points and faces of quads whose corners are lattice points."""
    numbers = {}
    faces = [[numbers.setdefault(corner, len(numbers)) for corner in quad] for quad in quads]
    return [place(*corner) for corner in numbers], faces


def drilled(cells, holes, divisions, place):
    """The surface of blocks of a lattice, with holes through some of them.

    holes: {block: (axis, radius)}, the radius in sides of the block; divisions: for each axis, how
    many quads long each block is; place() maps lattice points, also within a block, to points."""
    cells = set(cells)
    quads = []
    for cell in sorted(cells):
        hole = holes.get(cell)
        for axis in range(3):
            for upper in (0, 1):
                beside = list(cell)
                beside[axis] += 2 * upper - 1
                if tuple(beside) not in cells:
                    faces = side(cell, axis, upper, divisions, hole)
                    quads += faces if upper else [face[::-1] for face in faces]
        quads += wall(cell, *hole, divisions) if hole else []
    return numbered(quads, place)


def between(first, second, width):
    """Places (s, j, k): along two curves in the plane, from one to the other, across the width."""

    def place(s, j, k):
        (x0, y0), (x1, y1) = first(s), second(s)
        return (x0 + j * (x1 - x0), y0 + j * (y1 - y0), width * (k - 0.5))
    return place


def along(*stations):
    """The curve through points at s = 0, 1, 2, ...; a function in their place bends what follows.

    It gets how far it is from its station to the next one, 0 to 1."""

    def curve(s):
        i = min(int(s), len(stations) - 2)
        if callable(stations[i]):
            return stations[i](s - i)
        end = stations[i + 1](0.0) if callable(stations[i + 1]) else stations[i + 1]
        return tuple(a + (s - i) * (b - a) for a, b in zip(stations[i], end))
    return curve


def arc_about(x, y, radius, start, end):
    """Angles in degrees."""
    def point(t):
        angle = math.radians(start + t * (end - start))
        return (x + radius * math.cos(angle), y + radius * math.sin(angle))
    return point


# --- machined parts ------------------------------------------------------------------------------
def clamp():
    """A pipe clamp: an open ring with two ears and a bolt hole through each of them."""
    width, gap, inside, outside = 18.0, 3.0, 14.0, 19.0
    ear = gap + outside - inside

    def curve(radius, y):
        start = math.degrees(math.asin(y / radius))
        end = arc_about(0.0, 0.0, radius, start, 360.0 - start)
        return along((38.0, y), (20.0, y), end, end(1.0), (20.0, -y), (38.0, -y))

    return drilled([(s, 0, 0) for s in range(5)], {(0, 0, 0): (1, 0.28), (4, 0, 0): (1, 0.28)},
                   ([6, 1, 40, 1, 6], [1], [6]),
                   between(curve(outside, ear), curve(inside, gap), width))


def perforated_sheet():
    """A plate of 40 x 30 x 1 with twelve round holes of diameter 6: genus 12."""
    cells = [(i, j, 0) for i in range(4) for j in range(3)]
    return drilled(cells, {cell: (2, 0.3) for cell in cells}, ([8] * 4, [8] * 3, [1]),
                   lambda i, j, k: (10.0 * i - 20.0, 10.0 * j - 15.0, k - 0.5))


def bracket():
    """An angle of 5 mm sheet with a fillet of radius 10 inside and a round hole in each leg."""
    thick, radius, leg = 5.0, 10.0, 30.0
    bend, end = thick + radius, thick + radius + leg
    fillet = [arc_about(bend, bend, radius, -45.0 * i, -45.0 * (i + 1)) for i in (2, 3)]
    inner = along((end, thick), *fillet, (thick, bend), (thick, end))
    outer = along((end, 0.0), (bend, 0.0), (0.0, 0.0), (0.0, bend), (0.0, end))
    return drilled([(s, 0, 0) for s in range(4)], {(0, 0, 0): (1, 0.25), (3, 0, 0): (1, 0.25)},
                   ([8, 6, 6, 8], [1], [8]), between(inner, outer, leg))


# --- an open sheet -------------------------------------------------------------------------------
def bowl():
    """A sphere of radius 10 without its top: one boundary, of radius 9."""
    around, rings = 48, 20
    lowest, highest = -0.5 * math.pi, math.acos(0.9)
    points = [(0.0, 0.0, -10.0)]
    for r in range(1, rings + 1):
        height = lowest + (highest - lowest) * r / rings
        for s in range(around):
            angle = 2.0 * math.pi * s / around
            points.append((10.0 * math.cos(height) * math.cos(angle),
                           10.0 * math.cos(height) * math.sin(angle), 10.0 * math.sin(height)))
    loops = [list(range(1 + r * around, 1 + (r + 1) * around)) for r in range(rings)]
    faces = [[0, a, b] for a, b in zip(loops[0][1:] + loops[0][:1], loops[0])]
    for low, high in zip(loops, loops[1:]):
        faces += ring(low, high)
    return points, faces


# --- assemblies ----------------------------------------------------------------------------------
def together(parts):
    points, faces = [], []
    for more, polygons in parts:
        faces += [[len(points) + v for v in polygon] for polygon in polygons]
        points += more
    return points, faces


def box(low, high, place=lambda x, y, z: (x, y, z)):
    sides = list(zip(low, high))
    return drilled([(0, 0, 0)], {}, ([1], [1], [1]),
                   lambda *c: place(*(a + t * (b - a) for t, (a, b) in zip(c, sides))))


def rib_cooler():
    """A base with six ribs, each a box of its own that runs into the base and ends at its sides."""
    base = box((0.0, 0.0, 0.0), (36.0, 30.0, 5.0))
    ribs = [box((x, 0.0, 4.0), (x + 2.0, 30.0, 17.0)) for x in [2.0 + 6.0 * i for i in range(6)]]
    return together([base] + ribs)


def turned(middle, around, tilt):
    """Places points by a tilt out of the plane, a turn about the z axis and a shift."""
    ca, sa, ct, st = math.cos(around), math.sin(around), math.cos(tilt), math.sin(tilt)

    def place(x, y, z):
        x, z = ct * x - st * z, st * x + ct * z
        return (middle[0] + ca * x - sa * y, middle[1] + sa * x + ca * y, middle[2] + z)
    return place


def bar_heap():
    """Eighteen square bars of 60 x 10 x 10 thrown on a heap: they run through each other."""
    draw = random.Random(79).random              # the only method whose values no version changes
    bars = []
    for _ in range(18):
        middle = [120.0 * (draw() - 0.5), 120.0 * (draw() - 0.5), 24.0 * draw()]
        place = turned(middle, 2.0 * math.pi * draw(), 0.4 * (draw() - 0.5))
        bars.append(box((-30.0, -5.0, -5.0), (30.0, 5.0, 5.0), place))
    return together(bars)
