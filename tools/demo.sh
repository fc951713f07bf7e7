#!/usr/bin/env bash
# Reconstructs a brain from its MRI volume: slices -> points -> surface -> picture.
#   demo.sh BIN OUT [VOLUME]
# BIN holds the programs, OUT takes the results. Without VOLUME it is ch2bet.nii.gz of Debian's
# package mricron-data.
set -euo pipefail
bin=$1
out=$2
volume=${3-/usr/share/mricron/templates/ch2bet.nii.gz}

iso=60          # between cerebrospinal fluid (about 40) and grey matter (about 80)
delta_max=120   # degrees; 90 is Attali's gamma-regular shape, more closes most of its holes
view=60,25      # the left side, from a little in front and above
size=1200x900

if [ ! -r "$volume" ]; then
  echo "demo: $volume is not there; install the package mricron-data or name another volume" >&2
  exit 65
fi
mkdir -p "$out"
"$bin/slices-to-points" "$volume" --iso "$iso" -o "$out/brain_points.ply"
"$bin/stream-recon" "$out/brain_points.ply" --surface gamma --delta-max "$delta_max" --memory 1G \
  --progress none --report "$out/brain.json" -o "$out/brain.pvtp"
"$bin/mesh-preview" "$out/brain.pvtp" --view "$view" --size "$size" -o "$out/brain.png"

cat <<END
made of $volume:
  $out/brain_points.ply  the points where the volume crosses $iso
  $out/brain.pvtp        the surface through them; open it in ParaView
  $out/brain.json        the report: counts, digests, memory, seconds
  $out/brain.png         the surface, shaded
END
