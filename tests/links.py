#!/usr/bin/env python3
"""Proves that every file a document links to, or a comment sends the reader to, is there.

    links.py ROOT           checks the tree, exit code 1 and a line per dead link
    links.py --self-check   proves on a bad tree that the check can fail
"""

import pathlib
import re
import sys
import tempfile

LINK = re.compile(r"\]\(([^)#\s]+)[^)]*\)")
MENTION = re.compile(r"\bdocs/[\w./-]*\w")  # in comments of sources, from the root
FOLDERS = ["docs", "spatial", "io", "engine", "tools", "tests"]


def targets(root, file):
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".md":
        found = [link for link in LINK.findall(text) if "://" not in link]
        return [(link, file.parent / link) for link in found]
    return [(mention, root / mention) for mention in MENTION.findall(text)]


def dead_links(root):
    files = list(root.glob("*.md"))
    for folder in FOLDERS:
        files += [f for f in (root / folder).rglob("*") if f.suffix in {".md", ".h", ".cpp"}]
    return [
        f"{file.relative_to(root)}: {link} is not there"
        for file in sorted(files)
        for link, target in targets(root, file)
        if not target.exists()
    ]


def self_check():
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        (root / "docs").mkdir()
        (root / "io").mkdir()
        (root / "docs/good.md").write_text("[a](../README.md) [b](https://example.org)\n")
        (root / "README.md").write_text("[a](docs/good.md) [b](docs/bad.md)\n")
        (root / "io/file.h").write_text("// See docs/good.md and docs/worse.md.\n")
        found = dead_links(root)
    expected = ["README.md: docs/bad.md is not there", "io/file.h: docs/worse.md is not there"]
    return [] if sorted(found) == expected else [f"links.py: self-check failed, found {found}"]


def main(argument):
    found = self_check() if argument == "--self-check" else dead_links(pathlib.Path(argument))
    print("\n".join(found) or "links: in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
