#!/usr/bin/env bash
# Our Delaunay kernel against CGAL's, or the whole program in little memory against it, in pairs on
# the same clouds; called by ./dev bench.
#   compare.sh kernel [POINTS] [ROUNDS] [--poles]
#   compare.sh windows [OPTIONS of bench-windows]
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release --log-level=WARNING -DSTREAM_RECON_TESTS=ON \
  -DSTREAM_RECON_BENCHMARKS=ON -DSTREAM_RECON_ORACLE=ON
cmake --build --preset release -j "$(nproc)" --target make-cloud bench-kernel bench-cgal stream-recon
what=${1-kernel}
shift || true
if [ "$what" = windows ]; then exec build/release/bin/bench-windows "$@"; fi
exec python3 "tests/benchmarks/compare_$what.py" build/release/bin "$@"
