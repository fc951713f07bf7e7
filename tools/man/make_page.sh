#!/usr/bin/env bash
# Makes the man page of a program from its --help and --version, and from what is written by hand.
#   make_page.sh PROGRAM HAND_WRITTEN PAGE     HAND_WRITTEN may be missing
set -euo pipefail
program=$1
hand_written=$2
page=$3

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The help in the layout that help2man knows, GNU's; its first line becomes the page's name.
"$program" --help >"$work/original"
sed -E \
  -e 1d \
  -e 's/^Positionals:$/Arguments:/' \
  -e 's/^  -([[:alnum:]]),--/  -\1, --/' \
  -e 's/ENUM:\{[^}]*\}/WORD/' \
  -e '/^  [^ ]/s/ REQUIRED( |$)/\1/' \
  -e '/^  -/s/ (UINT|INT|FLOAT)(:[A-Z]+)?(=| |$)/ N\3/' \
  -e '/^  -/s/^(  -.* [A-Z]+)=([^ ]+)  +(.*)$/\1  \3 (default: \2)/' \
  -e '/^  -/s/ TEXT( |$)/ ARG\1/' \
  -e '/^  [^ -]/s/^(  [^ ]+) TEXT( \.\.\.)?/\1\2/' \
  "$work/original" >"$work/help"
printf '#!/bin/sh\nif [ "$1" = --version ]; then exec "%s" --version; fi\ncat "%s"\n' \
  "$program" "$work/help" >"$work/${program##*/}"
chmod +x "$work/${program##*/}"

options=(--no-info --section=1 --locale=C.UTF-8 "--manual=stream-recon" "--source=$("$program" --version)")
description=$(head -n 1 "$work/original")
[ -e "$hand_written" ] && options+=("--include=$hand_written")
help2man "${options[@]}" "--name=${description,}" "--output=$work/page" "$work/${program##*/}"

# A date that every formatter reads; the build's own where it has one.
today=$(date -u ${SOURCE_DATE_EPOCH:+-d "@$SOURCE_DATE_EPOCH"} +%F)
sed -E "s/^(\\.TH [^ ]+ \"1\") \"[^\"]*\"/\\1 \"$today\"/" "$work/page" >"$page.begun"
mv "$page.begun" "$page"
