#!/usr/bin/env python3
"""Reconstructs scanned bodies with every method and prints size and time of each, as Markdown.

    bench-methods --data DIR [--bodies NAME...] [--methods KIND...] [--rounds N] [--memory SIZE]

It runs the programs that lie beside it, in the folder of the build. A body whose data are not in DIR is
skipped with a message; a method that the program refuses, or that fails, is a row that says so. Of
several rounds the run of median time counts. The exit code is 1 if any failed.

Size: samples that are vertices, vertices that are no samples, both as a share of the samples, and how
much of a solid is beyond the gamma shape: triangles whose balls meet at 90 degrees and more.
Time: seconds of the processes, as the report tells them; windows are the Delaunay structure.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

# What slices-to-points makes of the data, or a cloud as it is.
BODIES = {
    "brain": ("volumes/allen_human_brain_labels.nii.gz", ["--label", "any", "--every", "2"]),
    "intestine": ("volumes/abdominal_atlas_labels.nrrd", ["--label", "9", "--roi", ":,:,:92"]),
    "foot bones": ("clouds/vhf_foot_bones.ply", None),
    "skin": ("stacks/vhf_head_ct_png", ["--above", "40", "--spacing", "1,1,1", "--every", "2"]),
}
METHODS = ["gamma", "crust", "hybrid", "solid"]
RIGHT_ANGLE = 90  # of the histogram of angles, whose bins are degrees

# What is known of the thesis' tables: a mouse's intestines by the hybrid.
THESIS_SIZE = "| the thesis, 2007: hybrid | 78 thousand samples | - | - | - | 8 to 16 % | 10 to 25 % | - |"
THESIS_TIME = "| the thesis, 2007: hybrid | - | - | 680 | - | - | 1935 | 337 | - | - | 2968 | - |"
THESIS_BODY = "intestine"

# Columns of times, by the names of the report's stages.
PROCESSES = {
    "order": ["ingest", "order", "index"],
    "spacing": ["spacing"],
    "windows": ["windows"],
    "labels": ["labels"],
    "poles": ["poles"],
    "crust": ["crust"],
    "hybrid": ["hybrid"],
    "surface": ["surface"],
    "write": ["write"],
}


class Failure(Exception):
    pass


def run(command):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode != 0:
        lines = result.stderr.strip().splitlines() or ["no message"]
        raise Failure(f"exit code {result.returncode}: {lines[-1]}")


def make_cloud(binaries, source, how, folder):
    if how is None:
        return source
    cloud = folder / "cloud.pts"
    run([binaries / "slices-to-points", source, *how, "-o", cloud])
    return cloud


def reconstruct(binaries, cloud, method, options, folder):
    """The report of the run of median time, with the size of the file."""
    mesh, report = folder / "mesh.ply", folder / "report.json"
    command = [binaries / "stream-recon", cloud, "-o", mesh, "--surface", method, "--report", report]
    command += ["--memory", options.memory, "--threads", options.threads, "--progress", "none"]
    said = []
    for _ in range(options.rounds):
        run(command)
        said.append({**json.loads(report.read_text()), "file_bytes": mesh.stat().st_size})
    return sorted(said, key=lambda one: one["seconds"])[len(said) // 2]


def size_row(method, said):
    surface = said["surface"]
    samples = said["input"]["points"] - said["input"]["duplicates"]
    used, added = surface["samples_on_surface"], surface["vertices"] - surface["samples_on_surface"]
    beyond = "-"  # triangles of the crust lie between other balls
    if method == "solid":
        beyond = f"{100 * sum(surface['delta_histogram'][RIGHT_ANGLE:]) / surface['triangles']:.1f} %"
    return (
        f"| {method} | {surface['vertices']:,} | {surface['triangles']:,} | {surface['boundary_edges']:,}"
        f" | {100 * used / samples:.2f} % | {100 * added / samples:.1f} % | {beyond}"
        f" | {said['file_bytes'] / 1e6:.1f} |"
    )


def time_row(method, said):
    seconds = {stage["name"]: stage["seconds"] for stage in said["stages"]}
    cells = []
    for stages in PROCESSES.values():
        spent = [seconds.pop(name) for name in stages if name in seconds]
        cells.append(f"{sum(spent):.2f}" if spent else "-")
    if seconds:
        raise Failure(f"stages without a column: {', '.join(seconds)}")
    return (
        f"| {method} | {' | '.join(cells)} | {said['seconds']:.2f} | {said['peak_rss_bytes'] >> 20} |"
    )


def print_table(columns, rows):
    print(f"| {' | '.join(columns)} |")
    print("|" + " --- |" * len(columns))
    print("\n".join(rows), end="\n\n", flush=True)


def compare(name, cloud, binaries, options, folder):
    """Prints the body's two tables. Returns whether all methods did their work"""
    sizes, times, points = [], [], None
    good = True
    for method in options.methods:
        try:
            said = reconstruct(binaries, cloud, method, options, folder)
            rows = size_row(method, said), time_row(method, said)
            points = said["input"]["points"] - said["input"]["duplicates"]
        except Failure as failure:
            rows = [f"| {method} | FAILED: {failure}" + " |" * empty for empty in (7, 11)]
            good = False
        sizes.append(rows[0])
        times.append(rows[1])
    if name == THESIS_BODY:
        sizes.append(THESIS_SIZE)
        times.append(THESIS_TIME)
    print(f"**{name}**" + (f", {points:,} samples\n" if points else "\n"))
    size_columns = ["vertices", "faces", "boundary edges", "samples used", "added", "beyond gamma", "MB"]
    print_table(["method", *size_columns], sizes)
    print_table(["seconds", *PROCESSES, "whole run", "peak MiB"], times)
    return good


def parse_options():
    parser = argparse.ArgumentParser(prog="bench-methods", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=pathlib.Path, required=True, metavar="DIR")
    parser.add_argument("--bodies", nargs="+", choices=BODIES, default=list(BODIES), metavar="NAME",
                        help=", ".join(BODIES))
    parser.add_argument("--methods", nargs="+", default=METHODS, metavar="KIND",
                        help=f"of --surface (default: {' '.join(METHODS)})")
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--memory", default="512M", help="of stream-recon (default: 512M)")
    parser.add_argument("--threads", default="2", help="of stream-recon (default: 2)")
    return parser.parse_args()


def main():
    options = parse_options()
    binaries = pathlib.Path(__file__).resolve().parent
    good = True
    for name in options.bodies:
        file, how = BODIES[name]
        source = options.data / file
        if not source.exists():
            print(f"**{name}** skipped: no {source}\n", flush=True)
            continue
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            cloud = make_cloud(binaries, source, how, folder)
            good &= compare(name, cloud, binaries, options, folder)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
