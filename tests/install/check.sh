#!/usr/bin/env bash
# Installs the build into an empty prefix, builds the outside program against it, runs it, and
# makes sure that no GPL code is in what is installed.
#   check.sh BUILD_DIR WORK_DIR
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$1
work=$2
rm -rf "$work"
mkdir -p "$work"
prefix=$work/prefix

cmake --install "$build" --prefix "$prefix" >"$work/install.log"
for wanted in bin/stream-recon share/doc/stream_recon/LICENSE share/doc/stream_recon/NOTICE; do
  [ -e "$prefix/$wanted" ] || { echo "not installed: $wanted" >&2; exit 1; }
done
for program in "$prefix"/bin/*; do
  name=${program##*/}
  [ -e "$prefix/share/bash-completion/completions/$name" ] ||
    { echo "$name has no completion" >&2; exit 1; }
  ! command -v help2man >/dev/null || [ -e "$prefix/share/man/man1/$name.1" ] ||
    { echo "$name has no man page" >&2; exit 1; }
done

if grep -rlE 'N4CGAL|CGAL/|tetgen' "$prefix/bin" "$prefix/lib" "$prefix/include"; then
  echo "the files above contain GPL code" >&2
  exit 1
fi
for program in "$prefix"/bin/*; do
  if readelf -d "$program" | grep -E 'NEEDED.*(CGAL|gmp|mpfr)'; then
    echo "$program links a library that only tests may use" >&2
    exit 1
  fi
done

cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$prefix" >"$work/configure.log"
cmake --build "$work/build"
"$prefix/bin/make-cloud" folded -n 20000 -o "$work/cloud.ply"
"$work/build/outside" "$work/cloud.ply" "$work/outside.pvtp"
"$prefix/bin/stream-recon" "$work/cloud.ply" -o "$work/installed.pvtp"
cmp "$work/outside.pvtp" "$work/installed.pvtp" || diff -r "$work/outside" "$work/installed"
