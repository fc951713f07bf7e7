#!/usr/bin/env python3
"""Proves that includes point one way between the layers, and that each package has one door.

    layers.py ROOT          checks the tree, exit code 1 and a line per offence
    layers.py --self-check  proves on bad trees that the check can fail
"""

import pathlib
import re
import sys
import tempfile

LAYERS = ["spatial", "io", "engine", "tools"]  # each may include itself and those before it
SOURCES = {".h", ".cpp"}

# The files that may include a package's headers; a folder name opens it for the whole folder.
DOORS = {
    r"CLI/": ["tools"],
    r"boost/interprocess/": ["io/mapped_file.cpp"],
    r"expat\.h": ["io/xml_reader.cpp"],
    r"flann/": ["spatial/neighbors.cpp"],
    r"(itk|gdcm|jpeglib|tiffio)": ["tools/slices"],
    r"libdeflate\.h": ["io/vtk_xml_blocks.cpp", "io/vtp_codec.cpp"],
    r"lz4": ["io/vtp_codec.cpp"],
    r"nlohmann/": ["io/pts_encoder.cpp", "io/pts_reader.cpp", "engine", "tools"],
    r"png\.h": ["tools"],
    r"spdlog/": ["tools"],
    r"(tbb|oneapi)/": ["engine/parallel.h"],
    r"zlib\.h": ["tools/slices"],
    r"zstd\.h": ["io/block_codec.cpp"],
    r"(CGAL|gmpxx?\.h|mpfr\.h|tetgen)": [],  # GPL, tests only
}

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)


def is_open(path, doors):
    return any(path == door or path.startswith(door + "/") for door in doors)


def offences_of(path, text):
    allowed = LAYERS[: LAYERS.index(path.split("/")[0]) + 1]
    for quote, header in INCLUDE.findall(text):
        for package, doors in DOORS.items():
            if re.match(package, header) and not is_open(path, doors):
                yield f"{path}: includes {header}, whose only door is {doors or 'in tests'}"
        top = header.split("/")[0]
        if quote == '"' and top not in allowed:
            yield f"{path}: includes {header}, but may include only {', '.join(allowed)}"
        if quote == "<" and top in [*LAYERS, "tests"]:
            yield f"{path}: includes <{header}> in angle brackets, which hides it from review"


def offences(root):
    found = []
    for layer in LAYERS:
        for file in sorted((root / layer).rglob("*")):
            if file.suffix in SOURCES:
                path = file.relative_to(root).as_posix()
                found += offences_of(path, file.read_text(encoding="utf-8"))
    return found


def self_check():
    bad = {
        "spatial/upward.cpp": '#include "io/error.h"',
        "io/upward.h": '# include "engine/budget.h"',
        "engine/upward.cpp": '  #include "tools/options.h"',
        "tools/upward.cpp": '#include "tests/clouds.h"',
        "engine/hidden.cpp": "#include <tools/options.h>",
        "engine/order/back_door.cpp": "#include <tbb/parallel_for.h>",
        "io/back_door.cpp": "#include <zstd.h>",
        "tools/gpl.cpp": "#include <CGAL/Delaunay_triangulation_3.h>",
    }
    good = {
        "spatial/point.h": "#include <cmath>",
        "io/block_codec.cpp": '#include <zstd.h>\n#include "spatial/point.h"\n#include "io/error.h"',
        "engine/parallel.h": "#include <tbb/parallel_for.h>",
        "tools/main.cpp": '#include <CLI/CLI.hpp>\n#include "engine/pipeline.h"',
    }
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        for path, text in {**bad, **good}.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text + "\n", encoding="utf-8")
        caught = [line.split(":")[0] for line in offences(root)]
    return [f"layers.py: self-check failed, caught {caught}"] if sorted(caught) != sorted(bad) else []


def main(argument):
    found = self_check() if argument == "--self-check" else offences(pathlib.Path(argument))
    print("\n".join(found) or "layers: in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
