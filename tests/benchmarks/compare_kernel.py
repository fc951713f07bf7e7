#!/usr/bin/env python3
"""Runs bench-kernel and bench-cgal in pairs and prints how they compare.

    compare_kernel.py BIN [POINTS] [ROUNDS] [--poles]

With --poles both triangulate the poles of the clouds, weighted, instead of their points.
The two take turns, so that other work on the machine meets both; a line gives the medians of the
rounds. The exit code is 1 if the two ever differ in a tetrahedron.
"""

import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

CLOUDS = ["cube", "folded", "shell"]


def times(program, cloud):
    run = subprocess.run([*program, cloud], check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(run.stdout)


def compare(binaries, cloud, rounds, options):
    pairs = [
        (
            times([binaries / "bench-kernel", "--json", *options], cloud),
            times([binaries / "bench-cgal", *options], cloud),
        )
        for _ in range(rounds)
    ]
    ours, theirs = zip(*pairs)
    ratio = statistics.median(b["seconds"] / a["seconds"] for a, b in pairs)
    ratio_cpu = statistics.median(b["cpu_seconds"] / a["cpu_seconds"] for a, b in pairs)
    seconds = statistics.median(a["seconds"] for a in ours)
    cgal_seconds = statistics.median(b["seconds"] for b in theirs)
    same = all(a["digest"] == b["digest"] for a, b in pairs)
    print(
        f"{cloud.stem:8} {ours[0]['points']:>10} {ours[0]['tetrahedra']:>11} {seconds:>9.2f}"
        f" {cgal_seconds:>9.2f} {ratio:>7.2f} {ratio_cpu:>7.2f} {ours[0]['bytes_per_point']:>9.0f}"
        f" {theirs[0]['bytes_per_point']:>9.0f}  {'yes' if same else 'NO'}",
        flush=True,
    )
    return same


def main(binaries, points="1000000", rounds="3", *options):
    print("cloud        points  tetrahedra    ours s    CGAL s   ratio   (cpu)   bytes/pt      CGAL  same tetrahedra")
    same = True
    with tempfile.TemporaryDirectory() as folder:
        for kind in CLOUDS:
            cloud = pathlib.Path(folder) / f"{kind}.ply"
            make = [pathlib.Path(binaries) / "make-cloud", kind, "-n", points, "-o", cloud]
            subprocess.run(make, check=True, stderr=subprocess.DEVNULL)
            same &= compare(pathlib.Path(binaries), cloud, int(rounds), options)
            cloud.unlink()
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
