#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the project's own sample shapes, the same bytes every time.

    make_shapes.py [FOLDER]          write them (default: the folder of this script)
    make_shapes.py --check [FOLDER]  compare with the files there; exit status 1 if one differs

Closed shapes have their faces counter-clockwise seen from outside.
"""
import math
import os
import sys

from engineering_shapes import bar_heap, bowl, bracket, clamp, perforated_sheet, rib_cooler


# --- shapes: each function returns (points, faces) -----------------------------------------------
def surface_of_cells(cells, place):
    """The boundary of a set of lattice cells as quads; place() maps lattice corners to points."""
    cells = set(cells)
    numbers, points, faces = {}, [], []

    def number(corner):
        if corner not in numbers:
            numbers[corner] = len(points)
            points.append(place(*corner))
        return numbers[corner]

    for cell in sorted(cells):
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for upper in (0, 1):
                neighbour = list(cell)
                neighbour[axis] += 2 * upper - 1
                if tuple(neighbour) in cells:
                    continue
                ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
                face = []
                for du, dv in ring if upper else reversed(ring):
                    corner = list(cell)
                    corner[axis] += upper
                    corner[u] += du
                    corner[v] += dv
                    face.append(number(tuple(corner)))
                faces.append(face)
    return points, faces


def box_cells(nx, ny, nz):
    return [(i, j, k) for i in range(nx) for j in range(ny) for k in range(nz)]


def triangulated(points, faces):
    return points, [[f[0], f[k], f[k + 1]] for f in faces for k in range(1, len(f) - 1)]


def cube():
    """The cube of side 1 about the origin: 8 points, 6 quads."""
    return surface_of_cells([(0, 0, 0)], lambda i, j, k: (i - 0.5, j - 0.5, k - 0.5))


def arc():
    """An arch, half a ring of rectangular section: a deep concavity and sharp edges; triangles."""
    across, deep, along = 6, 5, 32

    def place(i, j, k):
        radius = 0.5 + 0.5 * i / across
        angle = math.pi * k / along
        return (radius * math.cos(angle), 0.4 * j / deep - 0.2, radius * math.sin(angle))

    return triangulated(*surface_of_cells(box_cells(across, deep, along), place))


def torus():
    """Ring radius 1, tube radius 0.4, about the z axis: 48 x 20 quads."""
    around, section = 48, 20
    points = []
    for i in range(around):
        for j in range(section):
            a, b = 2.0 * math.pi * i / around, 2.0 * math.pi * j / section
            radius = 1.0 + 0.4 * math.cos(b)
            points.append((radius * math.cos(a), radius * math.sin(a), 0.4 * math.sin(b)))
    faces = []
    for i in range(around):
        for j in range(section):
            i1, j1 = (i + 1) % around, (j + 1) % section
            faces.append([i * section + j, i1 * section + j, i1 * section + j1, i * section + j1])
    return points, faces


def genus_two():
    """A plate of 2.2 x 1.2 x 0.4 with two square holes through it: genus 2, sharp edges; quads."""
    holes = {(i, j) for i in (3, 4, 5, 6, 13, 14, 15, 16) for j in range(3, 7)}
    cells = [c for c in box_cells(20, 10, 4) if c[:2] not in holes]
    return surface_of_cells(
        cells, lambda i, j, k: (0.11 * i - 1.1, 0.12 * j - 0.6, 0.1 * k - 0.2))


def disc():
    """The unit disc in the plane z = 0, facing +z: rings of triangles, one boundary of 72 points."""
    rings = 12
    points = [(0.0, 0.0, 0.0)]
    for r in range(1, rings + 1):
        for s in range(6 * r):
            angle = 2.0 * math.pi * s / (6 * r)
            points.append((r / rings * math.cos(angle), r / rings * math.sin(angle), 0.0))
    faces = []
    for r in range(1, rings + 1):
        inner, outer = 1 + 3 * (r - 1) * (r - 2), 1 + 3 * r * (r - 1)
        for sextant in range(6):
            for s in range(r):
                a = outer + sextant * r + s
                b = outer + (sextant * r + s + 1) % (6 * r)
                at = (lambda t: inner + (sextant * (r - 1) + t) % (6 * (r - 1))) if r > 1 else (
                    lambda t: 0)
                faces.append([a, b, at(s)])
                if s + 1 < r:
                    faces.append([b, at(s + 1), at(s)])
    return points, faces


# --- files ---------------------------------------------------------------------------------------
def coordinates(point):
    # Adding 0.0 turns a rounded -0.0 into 0.0; six digits hide the last bits of sine and cosine.
    return " ".join(f"{round(x, 6) + 0.0:g}" for x in point)


def obj_text(title, points, faces):
    lines = [f"# {title}"]
    lines += ["v " + coordinates(p) for p in points]
    lines += ["f " + " ".join(str(v + 1) for v in f) for f in faces]
    return "\n".join(lines) + "\n"


def ply_text(title, points, faces):
    lines = ["ply", "format ascii 1.0", f"comment {title}", f"element vertex {len(points)}",
             "property float x", "property float y", "property float z",
             f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    lines += [coordinates(p) for p in points]
    lines += [" ".join(map(str, [len(f)] + f)) for f in faces]
    return "\n".join(lines) + "\n"


def vtk_text(title, points, faces):
    size = sum(len(f) + 1 for f in faces)
    lines = ["# vtk DataFile Version 3.0", title, "ASCII", "DATASET POLYDATA",
             f"POINTS {len(points)} float"]
    lines += [coordinates(p) for p in points]
    lines += [f"POLYGONS {len(faces)} {size}"]
    lines += [" ".join(map(str, [len(f)] + f)) for f in faces]
    return "\n".join(lines) + "\n"


WRITERS = {".obj": obj_text, ".ply": ply_text, ".vtk": vtk_text}
SHAPES = {"cube.obj": cube, "arc.vtk": arc, "torus.ply": torus, "genus_two.obj": genus_two,
          "disc.vtk": disc, "clamp.obj": clamp, "perforated_sheet.obj": perforated_sheet,
          "rib_cooler.obj": rib_cooler, "bowl.ply": bowl,
          "bar_heap.ply": lambda: triangulated(*bar_heap()), "bracket.vtk": bracket}


def main(arguments):
    check = "--check" in arguments
    folders = [a for a in arguments if a != "--check"]
    folder = folders[0] if folders else os.path.dirname(os.path.abspath(__file__))
    different = []
    for name, shape in SHAPES.items():
        path = os.path.join(folder, name)
        title = f"EvolvingSurfaces sample shape: {os.path.splitext(name)[0]}"
        text = WRITERS[os.path.splitext(name)[1]](title, *shape())
        if check:
            with open(path, encoding="ascii") as file:
                different += [] if file.read() == text else [name]
        else:
            with open(path, "w", encoding="ascii", newline="\n") as file:
                file.write(text)
    if different:
        sys.exit(f"{', '.join(different)}: not what make_shapes.py writes; run it again.")


if __name__ == "__main__":
    main(sys.argv[1:])
