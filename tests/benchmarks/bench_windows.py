#!/usr/bin/env python3
"""Runs stream-recon from file to chunked VTK in little memory against CGAL's Delaunay alone.

    bench-windows [--points N] [--rounds N] [--memory SIZE] [--clouds KIND...]

It runs the programs that lie beside it, in the folder of the build. CGAL holds the whole structure in memory and writes nothing. The two take turns, so that other work
on the machine meets both; a line gives the medians of the rounds. The exit code is 1 if the two ever
differ in a tetrahedron or a run exceeds its memory.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile


def run_windows(binaries, cloud, memory):
    report = cloud.with_suffix(".json")
    command = [binaries / "stream-recon", cloud, "-o", cloud.with_suffix(".pvtp")]
    command += ["--memory", memory, "--threads", "2", "--progress", "none", "--report", report]
    subprocess.run(command, check=True)
    return json.loads(report.read_text())


def run_peer(binaries, cloud):
    run = subprocess.run([binaries / "bench-cgal", cloud], check=True, stdout=subprocess.PIPE)
    return json.loads(run.stdout)


def compare(binaries, cloud, rounds, memory):
    pairs = [(run_windows(binaries, cloud, memory), run_peer(binaries, cloud)) for _ in range(rounds)]
    ours = [a for a, _ in pairs]
    ratio = statistics.median(a["seconds"] / b["seconds"] for a, b in pairs)
    seconds = statistics.median(a["seconds"] for a in ours)
    peer_seconds = statistics.median(b["seconds"] for _, b in pairs)
    windows = ours[0]["windows"]
    points = ours[0]["input"]["points"] - ours[0]["input"]["duplicates"]
    same = all(a["delaunay"]["digest"] == b["digest"] for a, b in pairs)
    kept = all(a["peak_rss_bytes"] <= a["memory_budget_bytes"] for a in ours)
    print(
        f"{cloud.stem:8} {seconds:7.1f} {peer_seconds:7.1f} {ratio:6.2f}"
        f" {max(a['peak_rss_bytes'] for a in ours) >> 20:5} {windows['count']:8}"
        f" {windows['guests'] / points:7.2f} {windows['rounds'] / windows['count']:7.1f}"
        f" {windows['queries'] / points:8.1f} {windows['node_visits'] / points:7.0f}"
        f" {windows['search_seconds'] / windows['insert_seconds']:14.2f}  {'yes' if same else 'NO'}",
        flush=True,
    )
    return same and kept


def main():
    parser = argparse.ArgumentParser(prog="bench-windows")
    parser.add_argument("--points", type=int, default=2_000_000)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--memory", default="256M")
    parser.add_argument("--clouds", nargs="+", default=["cube", "folded", "shell", "blob"])
    options = parser.parse_args()
    binaries = pathlib.Path(__file__).resolve().parent
    print(
        "cloud     ours s  CGAL s  ratio   MiB  windows  guests  rounds  queries  visits"
        "  search/insert  same tetrahedra"
    )
    good = True
    with tempfile.TemporaryDirectory() as folder:
        for kind in options.clouds:
            cloud = pathlib.Path(folder) / f"{kind}.ply"
            make = [binaries / "make-cloud", kind, "-n", str(options.points), "-o", cloud]
            subprocess.run(make, check=True, stderr=subprocess.DEVNULL)
            good &= compare(binaries, cloud, options.rounds, options.memory)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
