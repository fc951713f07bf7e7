#!/usr/bin/env bash
# Our Delaunay kernel against CGAL's, in pairs on the same clouds; called by ./dev bench.
#   compare.sh [POINTS] [ROUNDS]
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release --log-level=WARNING -DSTREAM_RECON_TESTS=ON \
  -DSTREAM_RECON_BENCHMARKS=ON -DSTREAM_RECON_ORACLE=ON
cmake --build --preset release -j "$(nproc)" --target make-cloud bench-kernel bench-cgal
exec python3 tests/benchmarks/compare_kernel.py build/release/bin "${1-1000000}" "${2-3}"
