#!/bin/bash
# What a loader of others, assimp, finds in the glTFs that clers writes is what it finds in those that were encoded.
# usage: loader_test.sh PROGRAM
set -u
clers=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
command -v assimp >/dev/null && command -v python3 >/dev/null || exit 77
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
mkdir given back
"$here/make_gltf.py" given 40 500
[ -f "${CLERS_CORPUS:-}/MANIFEST.tsv" ] && cp "$CLERS_CORPUS"/*.glb given
find given -name '*.glb' -o -name '*.gltf' | xargs "$clers" encode -q -o packed/ || exit 1
"$clers" decode -q packed/*.clers -o back/ || exit 1

# found FILE: what it says of a file; nothing of one that it cannot read.
found() { assimp info "$1" -r 2>/dev/null | grep -E '^(Nodes|Meshes|Animations|Materials|Vertices|Faces|Bones|Animation Channels|Minimum|Maximum) '; }
# Those of damaged scenes it refuses, and some of extensions: it must be able to read some.
failed=0 read=0
for scene in given/*.gl*; do
  found "$scene" >before
  found "back/${scene##*/}" >after
  [ -s before ] && read=$((read + 1))
  if ! diff before after; then
    echo "FAILED: ${scene##*/}"
    failed=1
  fi
done
echo "assimp reads $read of them"
[ $failed -eq 0 ] && [ $read -gt 10 ]
