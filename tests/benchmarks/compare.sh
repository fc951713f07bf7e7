#!/usr/bin/env bash
# Our Delaunay kernel against CGAL's, or the whole program in little memory against it, in pairs on
# the same clouds; or the methods of the program side by side on scanned bodies; called by ./dev bench.
#   compare.sh kernel [POINTS] [ROUNDS] [--poles]
#   compare.sh windows [OPTIONS of bench-windows]
#   compare.sh methods [OPTIONS of bench-methods]
set -euo pipefail
cd "$(dirname "$0")/../.."
what=${1-kernel}
shift || true
case $what in
  methods) targets=(stream-recon slices-to-points) ;;
  *) targets=(make-cloud bench-kernel bench-cgal stream-recon) ;;
esac
cmake --preset release --log-level=WARNING -DSTREAM_RECON_TESTS=ON \
  -DSTREAM_RECON_BENCHMARKS=ON -DSTREAM_RECON_ORACLE=ON
cmake --build --preset release -j "$(nproc)" --target "${targets[@]}"
case $what in
  windows) exec build/release/bin/bench-windows "$@" ;;
  methods) exec build/release/bin/bench-methods --data ../shared/data "$@" ;;
  *) exec python3 "tests/benchmarks/compare_$what.py" build/release/bin "$@" ;;
esac
