#!/bin/bash
# .drc files of Draco's own program, at each of its levels, have the triangles and values that its decoder gives.
# usage: drc_test.sh PROGRAM
set -u
clers=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
for tool in draco_encoder draco_decoder python3; do command -v $tool >/dev/null || exit 77; done
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0
fail() { echo "FAILED: $*"; failed=1; }

"$here/make_obj.py" >a.obj
for level in 0 1 2 3 4 5 6 7 8 9 10; do
  for bits in 0 11; do
    draco_encoder -i a.obj -o a.drc -cl $level -qp $bits -qt $bits -qn $bits >/dev/null || fail "draco_encoder $level $bits"
    draco_decoder -i a.drc -o draco.ply >/dev/null || fail "draco_decoder $level $bits"
    "$clers" encode -qf a.drc -o a.clers && "$clers" verify -q a.drc a.clers || fail "encode $level $bits"
    "$clers" decode -qf a.clers -o ours.ply || fail "decode $level $bits"
    "$here/same_triangles.py" draco.ply ours.ply || fail "level $level, $bits bits: other triangles"
  done
done

# Points: sequential and by a tree, in the order of Draco's decoder.
for level in 0 10; do
  draco_encoder -point_cloud -i a.obj -o a.drc -cl $level -qp 12 >/dev/null
  draco_decoder -i a.drc -o draco.ply >/dev/null
  "$clers" encode -qf --order keep a.drc -o a.clers
  "$clers" decode -qf a.clers -o ours.ply
  "$here/same_triangles.py" --points draco.ply ours.ply || fail "points of level $level"
done

"$clers" encode -f a.drc -o a.clers 2>err
grep -q "note: Draco has quantised position, .*normal" err && grep -q 'became a mesh without faces' err || fail "no note"
head -c 100 a.drc >cut.drc
"$clers" encode -f cut.drc 2>err
[ $? -eq 3 ] && grep -q 'cut.drc: byte [0-9]*: Draco cannot decode it' err || fail "a cut file: $(cat err)"
exit $failed
