#!/usr/bin/env bash
# Looks at the man page of each program: formatters find no fault, and it tells all that it should.
#   man_check.sh BIN_DIR MAN_DIR
# Exit code 77: there are no pages, or nothing to check them with.
set -uo pipefail
bin=$1
pages=$2
failed=0
complain() {
  echo "$*"
  failed=1
}

compgen -G "$pages/*.1" >/dev/null || { echo "skipped: no pages, help2man was missing"; exit 77; }
command -v man >/dev/null || command -v mandoc >/dev/null ||
  { echo "skipped: neither man nor mandoc is there"; exit 77; }

# faults FILE: what the formatters say about it.
faults() {
  if command -v mandoc >/dev/null; then mandoc -Tlint -Wwarning "$1"; fi
  if command -v man >/dev/null; then
    LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -E UTF-8 -l "$1" 2>&1 >/dev/null
  fi
}

for page in "$pages"/*.1; do
  program=$(basename "$page" .1)
  found=$(faults "$page")
  [[ -z $found ]] || complain "$page: $found"
  for section in NAME SYNOPSIS DESCRIPTION OPTIONS EXAMPLES '"EXIT STATUS"' '"SEE ALSO"'; do
    grep -q "^.SH $section\$" "$page" || complain "$page: no section $section"
  done
  plain=$(sed 's/\\//g' "$page")
  for option in $("$bin/$program" --help | grep -oE '^  (-[a-zA-Z],)?--[a-z-]+' | grep -oE -- '--.*'); do
    [[ $plain == *"$option"* ]] || complain "$page: nothing about $option"
  done
  [[ $plain != *REQUIRED* && $plain != *ENUM* ]] || complain "$page: raw words of the option parser"
done

# A formatter that finds no fault in a bad page would prove nothing.
bad=$(mktemp)
trap 'rm -f "$bad"' EXIT
printf '.TH BAD "1" "2026-01-01"\n.SH NAME\nbad\n.nosuchmacro x\n' >"$bad"
[[ -n $(faults "$bad") ]] || complain "the formatters accept a bad page"
exit $failed
