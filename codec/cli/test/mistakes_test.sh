#!/bin/bash
# Ordinary mistakes at the command line and the answers: mistakes.txt is a transcript that must come out again.
# usage: mistakes_test.sh PROGRAM    with UPDATE=1 the transcript is written anew, to be read
. "$(dirname "$0")/harness.sh" "$1"

mkdir bin scans other
ln -s "$clers" bin/clers
PATH=$PWD/bin:$PATH
tetrahedron | tee a.obj a.txt scans/a.obj scans/b.obj >other/a.obj
clers encode -q a.obj
head -c 40 a.clers >damaged.clers
printf 'glTF\2\0\0\0\14\0\0\0' >duck.glb
gzip -c a.obj >a.ply.gz
sed 's/^f 1 3 2/f 1 3 7/' a.obj >bad.obj
sed '1s/.*/v nan 0 0/' a.obj >nan.obj
{ cat a.obj; echo 'l 1 2'; echo 'p 1'; } >lines.obj

grep '^\$ ' "$tests/mistakes.txt" | while IFS= read -r line; do
  echo "$line"
  bash -c "${line#\$ }" 2>&1 </dev/null
  code=$?
  [ $code -eq 0 ] || echo "[status $code]"
done >transcript

if [ -n "${UPDATE:-}" ]; then
  cp transcript "$tests/mistakes.txt"
elif ! diff -u "$tests/mistakes.txt" transcript; then
  echo "FAILED: other answers than in mistakes.txt"
  failed=1
fi
lines=$(grep -c '^\$' transcript)
check "a line of answer each" test "$(wc -l <transcript)" -eq $((3 * lines))
check "no answer is longer than two lines of a terminal" eval '! grep -E "^.{161}" transcript'
check "nothing is made by mistake" test "$(ls | tr '\n' ' ')" = \
  "a.clers a.obj a.ply.gz a.txt bad.obj bin damaged.clers duck.glb lines.obj nan.obj other scans transcript "
finish
