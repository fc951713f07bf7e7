#!/usr/bin/env bash
# Everything that continuous integration checks, called by ./dev test. A step that fails does not
# keep the others from running; the summary names it and the exit code is 1.
#   run_all.sh all | quick
set -uo pipefail
cd "$(dirname "$0")/.." || exit
jobs=$(nproc)
summary=()
failed=0

# step NAME COMMAND...: runs it and remembers how it ended.
step() {
  local name=$1 start=$SECONDS result=ok
  shift
  printf '\n== %s\n' "$name"
  "$@" </dev/null || { result=FAILED; failed=1; }
  summary+=("$(printf '%-8s %4d s  %s' "$result" $((SECONDS - start)) "$name")")
}

# build PRESET TARGET OPTIONS...
build() {
  local preset=$1 target=$2
  shift 2
  cmake --preset "$preset" --log-level=WARNING "$@" &&
    cmake --build --preset "$preset" -j "$jobs" --target "$target"
}

release_tests() {
  build release all -DSTREAM_RECON_TESTS=ON -DSTREAM_RECON_BENCHMARKS=ON &&
    ctest --preset release -j "$jobs"
}

# unit_tests PRESET OPTIONS...
unit_tests() { build "$1" all "${@:2}" && ctest --preset "$1" -j "$jobs"; }

parallel_tests() { build tsan parallel_tests && ctest --preset tsan -j "$jobs" -L parallel; }

format() {
  find spatial io engine tools tests -name '*.h' -o -name '*.cpp' | xargs clang-format --dry-run -Werror
}

lint() { run-clang-tidy -quiet -j "$jobs" -p build/release '^(?!.*/tests/).*\.cpp$'; }

step "format" format
step "release: all tests" release_tests
step "demo" tools/demo.sh build/release/bin demo
if [ "${1-all}" = all ]; then
  step "lint" lint
  step "checked: optimized, all asserts" unit_tests checked -DSTREAM_RECON_TOOLS=OFF
  step "asan: addresses, undefined behaviour" unit_tests asan
  step "tsan: threads" parallel_tests
fi

printf '\n== summary\n'
printf '%s\n' "${summary[@]}"
exit $failed
