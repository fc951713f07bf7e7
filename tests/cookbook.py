#!/usr/bin/env python3
"""Runs the commands of docs/cookbook.md, one recipe a call, as a reader would.

cookbook.py --list DOC                       names the recipes
cookbook.py DOC RECIPE PROGRAMS DATA         runs one: exit 0 done, 77 no sample data, else failed
cookbook.py --self-check                     a wrong recipe must be noticed

A recipe is a second-level heading. Its blocks of `sh` run one after the other in one folder, where
the data lie under the names the recipes use; every command must succeed, and every line of its blocks
of `text` must be part of what was printed. Every file named with -o, --html or --report must be there.
"""
import glob
import os
import re
import subprocess
import sys
import tempfile

SKIPPED = 77
ARCHIVES = {
    "chest_ct_dicom": ("stacks/chest_ct_dicom.tar.zst", ["tar", "--zstd", "-xf"]),
    "ct_head_raw_slices": ("stacks/ct_head_raw_slices.tar.gz", ["tar", "-xzf"]),
}


def recipes(document):
    """Heading -> its blocks, as (language, text), in order."""
    found, name = {}, None
    for part in re.split(r"(?m)^(## .*)$", document):
        if part.startswith("## "):
            name = part[3:].strip()
            continue
        blocks = re.findall(r"(?ms)^```(\w+)\n(.*?)^```$", part)
        if name and blocks:
            found[name] = blocks
    return found


def lay_out(data, folder, blocks):
    """Puts the data that the commands name into the folder."""
    script = "".join(text for _, text in blocks)
    for place in ("clouds", "volumes", "stacks"):
        for name in os.listdir(os.path.join(data, place)):
            if name in script or name.rsplit(".", 1)[0] + ".mhd" in script:
                os.symlink(os.path.join(data, place, name), os.path.join(folder, name))
    for name, (archive, unpack) in ARCHIVES.items():
        if name in script:
            subprocess.run(unpack + [os.path.join(data, archive)], cwd=folder, check=True)


def problems(blocks, folder, programs):
    """What does not come out as the recipe says."""
    script = "set -euo pipefail\n" + "".join(t for language, t in blocks if language == "sh")
    environment = dict(os.environ, PATH=programs + os.pathsep + os.environ["PATH"])
    run = subprocess.run(["bash", "-c", script], cwd=folder, env=environment, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    print(run.stdout)
    found = [] if run.returncode == 0 else [f"a command failed with {run.returncode}"]
    for language, text in blocks:
        if language == "text":
            found += [f"not said: {line}" for line in text.splitlines() if line not in run.stdout]
    for name in re.findall(r"(?:-o|--html|--report) +([\w./]+)", script):
        stem, ending = os.path.splitext(os.path.join(folder, name))
        made = glob.glob(stem + ending) + glob.glob(stem + "_*" + ending)  # of each label
        if not made or not all(os.path.getsize(path) for path in made):
            found.append(f"not there, or empty: {name}")
    return found


def run_recipe(document, name, programs, data):
    blocks = recipes(document)[name]
    with tempfile.TemporaryDirectory() as folder:
        lay_out(data, folder, blocks)
        return problems(blocks, folder, programs)


def self_check():
    good = "## a\n```sh\necho 12 points >out; cat out # -o out\n```\n```text\n12 points\n```\n"
    bad = {
        "a command that fails": good.replace("cat out", "false"),
        "another number": good.replace("12 points\n```\n", "13 points\n```\n"),
        "a file that is not there": good.replace("-o out", "-o other"),
        "a pipe that fails at its beginning": good.replace("cat out", "false | cat"),
    }
    with tempfile.TemporaryDirectory() as folder:
        assert problems(recipes(good)["a"], folder, "/bin") == []
        for what, document in bad.items():
            assert problems(recipes(document)["a"], folder, "/bin"), what
    assert list(recipes("# t\n## none\ntext\n" + good)) == ["a"]


def main():
    if sys.argv[1:] == ["--self-check"]:
        self_check()
        return 0
    if sys.argv[1] == "--list":
        with open(sys.argv[2], encoding="utf-8") as file:
            print("\n".join(recipes(file.read())))
        return 0
    path, name, programs, data = sys.argv[1:]
    if not os.path.isdir(data):
        print("skipped: no sample data beside the project")
        return SKIPPED
    with open(path, encoding="utf-8") as file:
        found = run_recipe(file.read(), name, programs, os.path.abspath(data))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
