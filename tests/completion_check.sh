#!/usr/bin/env bash
# Sources the completion of each program and looks at what it offers for many command lines.
#   completion_check.sh BIN_DIR COMPLETION_DIR WORK_DIR
set -uo pipefail
bin=$1
completions=$2
work=$3
export PATH=$bin:$PATH
rm -rf "$work"
mkdir -p "$work/folder" "$work/surface"
cd "$work" || exit 1
touch a.ply b.vtk 'with blank.ply' surface.pvtp surface/chunk_000000.vtp notes.pdf
failed=0

programs=()
for file in "$completions"/*; do
  programs+=("${file##*/}")
  # shellcheck disable=SC1090
  source "$file" || failed=1
done

one_line() { paste -sd' ' -; }

# offered WORD...: what is offered for the last word, sorted, one a line.
offered() {
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  COMPREPLY=()
  _stream_recon_complete "$1" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
  printf '%s\n' "${COMPREPLY[@]}" | sort
}

# expect "WANTED ..." WORD...: exactly these are offered, in any order; blanks in names are _.
expect() {
  local wanted got
  wanted=$(printf '%s\n' $1 | sort | one_line)
  shift
  got=$(offered "$@" | tr ' ' _ | one_line)
  [[ $got == "$wanted" ]] && return
  printf '%s\n  wanted: %s\n  got:    %s\n' "$*" "$wanted" "$got"
  failed=1
}

[[ ${#programs[@]} -ge 5 ]] || { echo "only ${#programs[@]} completions"; failed=1; }
for program in "${programs[@]}"; do
  complete -p "$program" >/dev/null || { echo "$program has no completion"; failed=1; }
  # Every option that --help tells of, found in another way than the completion's.
  all=$("$program" --help | grep -oE '^  (-[a-zA-Z],)?--[a-z-]+' | grep -oE -- '--.*' | one_line)
  [[ $all == *--help* && $all == *--version* ]] || { echo "$program: no options found"; failed=1; }
  expect "$all" "$program" --
  for option in $all; do
    expect "$(printf '%s\n' $all | grep -- "^${option%?}" | one_line)" "$program" "${option%?}"
  done
done

expect "auto ply xyz f32 f64 vtk vtp pts" stream-recon --input-format ''
expect "gamma alpha crust hybrid solid none" stream-recon in.ply --surface ''
expect "gamma" stream-recon in.ply --surface g
expect "auto bar json none" stream-recon --progress ''
expect "json" stream-recon --progress = j
expect "512M" stream-recon --memory 5
expect "folder surface" stream-recon --scratch ''
expect "" stream-recon --threads ''
expect "" stream-recon --delta-max ''
expect "a.ply b.vtk with_blank.ply folder surface" stream-recon ''
expect "a.ply" stream-recon b.vtk a
expect "surface surface.pvtp a.ply b.vtk with_blank.ply folder" stream-recon a.ply -o ''
expect "surface/chunk_000000.vtp" stream-recon surface/
expect "--surface --scratch --scratch-limit --spacing" stream-recon --s
expect "--delta-max" stream-recon a.ply -o b.ply --d

expect "a.ply b.vtk with_blank.ply surface surface.pvtp folder" mesh-check ''
expect "--json" mesh-check surface.pvtp --j
expect "closed manifold oriented no-degenerate no-duplicate one-component consistent-ids" \
  mesh-check surface.pvtp --require ''
expect "closed,manifold" mesh-check surface.pvtp --require closed,m
expect "closed,oriented,no-degenerate closed,oriented,no-duplicate" \
  mesh-check --require closed,oriented,no
expect "folder surface" mesh-check --scratch ''
expect "64M" mesh-check --memory 6

expect "surface surface.pvtp" mesh-preview s
expect "a.ply" mesh-preview surface.pvtp -o a
expect "front back left right top bottom" mesh-preview surface.pvtp --view ''
expect "component" mesh-preview surface.pvtp --color c

expect "ply xyz f32 f64 pts" make-cloud cube --format ''
expect "float double" make-cloud cube --scalar ''
expect "folded folds" make-cloud fo
kinds=$(make-cloud --help | sed -n '/^Kinds:/,$p' | awk '/^  / { print $1 }' | one_line)
[[ $kinds == *cube*shell* ]] || { echo "no kinds found"; failed=1; }
expect "$kinds" make-cloud ''
expect "" make-cloud cube -n ''

expect "a.ply" bench-kernel a
expect "--json" bench-kernel a.ply --js

if [[ " ${programs[*]} " == *' slices-to-points '* ]]; then
  expect "ply xyz f32 f64 pts" slices-to-points v.nii --output-format ''
  expect "world index" slices-to-points v.nii --coordinates ''
  expect "" slices-to-points v.nii --dims ''
  expect "float double" slices-to-points v.nii --scalar ''
  expect "" slices-to-points v.nii --iso ''
fi

exit $failed
