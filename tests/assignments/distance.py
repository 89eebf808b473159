#!/usr/bin/env python3
"""Prints how far two cloths are from each other: python3 measure/distance.py out/one/final.obj out/two/final.obj

The distance of each vertex of one mesh from the same vertex of the other: their root mean square,
and the largest.
"""
import math
import pathlib
import sys


def vertices(text):
    """The places of the vertices of an OBJ file, m."""
    return [
        tuple(map(float, line.split()[1:4])) for line in text.splitlines() if line.startswith("v ")
    ]


def distances(a, b):
    """|a_i − b_i| for every vertex i, m."""
    if len(a) != len(b) or not a:
        raise ValueError(
            f"the meshes have different numbers of vertices, {len(a)} and {len(b)}, or none"
        )
    return [math.dist(p, q) for p, q in zip(a, b)]


def rms(values):
    """The root mean square."""
    return math.sqrt(sum(value * value for value in values) / len(values))


def main():
    if len(sys.argv) != 3:
        print(__doc__.split("\n")[0], file=sys.stderr)
        return 2
    try:
        apart = distances(*(vertices(pathlib.Path(name).read_text()) for name in sys.argv[1:]))
    except (OSError, ValueError) as error:
        print(f"distance.py: {error}", file=sys.stderr)
        return 2
    print(f"root mean square {1000 * rms(apart):.4g} mm, largest {1000 * max(apart):.4g} mm")
    return 0


if __name__ == "__main__":
    sys.exit(main())
