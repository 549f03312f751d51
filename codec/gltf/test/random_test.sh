#!/bin/bash
# Random glTFs there and back, and damaged ones: 200 of each, 10,000 with CLERS_LONG.
# usage: random_test.sh PROGRAM
set -u
clers=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
command -v python3 >/dev/null || exit 77
count=200
[ -n "${CLERS_LONG:-}" ] && count=10000
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0

# scenes FOLDER: its glTFs.
scenes() { find "$1" -name '*.glb' -o -name '*.gltf'; }

for ((first = 0; first < count; first += 200)); do
  rm -rf given packed back kept
  mkdir back kept
  "$here/make_gltf.py" given 200 $first
  scenes given | xargs "$clers" encode -q -o packed/ || failed=1
  "$clers" decode -q packed/*.clers -o back/ || failed=1
  "$here/audit.py" --folders given back || failed=1
  # Another level, in the order that was given.
  scenes given | head -n 50 | xargs "$clers" encode -qf -1 --order keep -o packed/ || failed=1
  scenes given | head -n 50 | sed 's/.*\///; s/\..*//; s/.*/packed\/&.clers/' |
    xargs "$clers" decode -q -o kept/ || failed=1
  for scene in $(scenes given | grep 'glb$' | head -n 3); do
    "$clers" verify -q "$scene" "packed/$(basename "$scene" .glb).clers" || failed=1
  done

  # Positions on a grid, off by what is stated at most. NaNs are refused.
  rm -rf lossy
  mkdir lossy
  for scene in $(scenes given | head -n 12); do
    "$clers" encode -qf --order keep --positions q12 "$scene" -o lossy/it.clers 2>errors || continue
    "$clers" decode -qf lossy/it.clers -o "lossy/${scene##*/}" || failed=1
    error=$("$clers" info --json lossy/it.clers | python3 -c 'import json, sys
print(max([a["error"] for m in json.load(sys.stdin)["meshes"] for a in m["attributes"]], default=0))')
    "$here/audit.py" --error "POSITION=$error" "$scene" "lossy/${scene##*/}" >>lossy/audits || failed=1
  done
  grep -v '^1 of 1' lossy/audits
  grep -q '^1 of 1' lossy/audits || failed=1

  # As glTFs with the extension.
  rm -rf some within packed back
  mkdir some within back
  for scene in $(scenes given | sort | head -n 40); do
    "$clers" encode -q "$scene" -o "within/${scene##*/}" || failed=1
    cp "$scene" some
  done
  cp given/*.bin given/*.png some
  scenes within | xargs "$clers" encode -q -o packed/ || failed=1
  "$clers" decode -q packed/*.clers -o back/ || failed=1
  "$here/audit.py" --views --folders some back || failed=1

  rm -rf damaged packed back
  mkdir back
  "$here/make_gltf.py" --mutate damaged 200 $first
  scenes damaged | xargs "$clers" encode -q -o packed/ 2>errors
  status=$?
  # xargs says 123 of a command that failed, and more of one that was killed.
  if [ $status -ne 0 ] && [ $status -ne 123 ]; then
    echo "status $status of encoding damaged glTFs"
    failed=1
  fi
  grep -vE '^clers: .+: .+' errors && failed=1
  grep -E 'internal|terminate|rror: out of' errors && failed=1
  "$clers" decode -q packed/*.clers -o back/ || failed=1
done
exit $failed
