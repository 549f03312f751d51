#!/bin/bash
# Where the program writes, what it never touches, and what strangers' files and paths do to it.
# usage: outputs_test.sh PROGRAM
. "$(dirname "$0")/harness.sh" "$1"
grid 10 >grid.obj
tetrahedron >tetrahedron.obj

# ---- Beside the input
run encode grid.obj; ends "encode" 0
check "encode: one line of result" grep -qxE \
  'grid.obj -> grid.clers: 4,094 -> [0-9]+ bytes, [0-9.]+ times smaller, [0-9.]+ s' err
check "encode: nothing else" test "$(wc -l <err)" -eq 1 -a ! -s out
run encode -q -f grid.obj; silent "encode -q"
mv grid.obj kept.obj; run decode grid.clers; ends "decode" 0
check "decode knows the format that was encoded" test -f grid.obj; mv kept.obj grid.obj
run decode --to off grid.clers; ends "decode --to off" 0
check "decode --to off" test -f grid.off
mkdir sub; cp tetrahedron.obj sub/a.b.obj
run encode sub/a.b.obj; check "the last suffix is replaced" test -f sub/a.b.clers
"$clers" decode -q grid.clers -c --to ply >grid.ply
run encode grid.ply -f; ends "encode a ply" 0
run decode -f grid.clers -o two/; ends "decode into a directory" 0
check "a ply comes back as ply" test -f two/grid.ply
"$clers" decode -q grid.clers -c --to ply --text >text.ply
run encode -q text.ply; rm text.ply; run decode -q text.clers
check "a text comes back as text" grep -q '^format ascii' text.ply
cp grid.obj other.obj; run encode other.obj grid.obj -f; ends "several beside themselves" 0
check "several beside themselves" test -f other.clers
for level in 1 5 9; do
  run encode -qf -$level grid.obj -o digit.clers; silent "-$level"
  run encode -qf --level $level grid.obj -o word.clers
  check "-$level is --level $level" cmp -s digit.clers word.clers
done
run encode -q -f -1 -9 grid.obj -o digit.clers
check "the last digit counts" cmp -s digit.clers word.clers

# ---- Pipes
cat grid.obj | "$clers" encode --from obj - 2>err | "$clers" decode - --to obj >out 2>>err; status=$?
ends "a pipe" 0
check "a pipe is silent" test ! -s err
check "a pipe carries the mesh" test "$(grep -c ^f out)" -eq 200
run encode -c grid.obj; ends "-c" 0
check "-c says what it made" grep -q '^grid.obj -> standard output: ' err
cp out stdout.clers
run verify -q grid.obj stdout.clers; silent "what -c wrote"
run encode -c grid.obj other.obj; ends "-c of several" 2 "several inputs cannot go to standard output"
"$clers" decode - <grid.clers >out 2>err; status=$?; ends "decode -" 0
check "decode - gives the format encoded" grep -q ^v out
if command -v script >/dev/null; then
  on_terminal() { script -qec "'$clers' $*" /dev/null >terminal </dev/null; status=$?; }
  on_terminal encode -c grid.obj
  check "binary is not written to a terminal" grep -q "standard output: is a terminal" terminal
  check "which is a mistake of usage" test "$status" -eq 2
  on_terminal encode -qcf grid.obj; check "but with -f" grep -qa CLERS terminal
  on_terminal decode -qc --to off grid.clers; check "text is" grep -q ^OFF terminal
fi

# ---- Inputs
run encode -f grid.obj -o grid.obj; ends "onto itself" 2 "grid.obj: is an input"
ln grid.obj hard.obj; ln -s grid.obj soft.obj
run encode -f grid.obj -o hard.obj; ends "onto itself by a hard link" 2 "hard.obj: is an input"
run encode -f grid.obj -o soft.obj; ends "onto itself by a symbolic link" 2 "soft.obj: is an input"
run subdivide -f --scheme loop grid.obj other.obj -o .; ends_status=$status
check "several onto themselves" test "$ends_status" -eq 2 -a "$(grep -c 'is an input' err)" -eq 2
check "inputs stay as they are" test "$(grep -c ^f grid.obj)$(grep -c ^f other.obj)" = 200200
cp grid.obj gone.obj; run encode --rm gone.obj; ends "--rm" 0
check "--rm removes" test ! -e gone.obj -a -f gone.clers
cp grid.obj gone.obj; run encode --rm gone.obj; ends "--rm without an output" 2 "exists"
check "--rm keeps what was not written" test -f gone.obj
run encode --rm -c gone.obj; check "--rm keeps what went to standard output" test -f gone.obj
{ cat grid.obj; echo l 1 2; } >lossy.obj
run encode --rm lossy.obj; check "--rm keeps what was not carried whole" test -f lossy.obj
check "and says so" grep -q 'note: is kept' err
run decode --rm -f gone.clers; check "decode --rm removes" test ! -e gone.clers
run encode -k -f gone.obj; check "-k keeps" test -f gone.obj
run encode -k --rm gone.obj; ends "-k and --rm" 2 "excludes"
run decode --rm --piece 0 grid.clers -o piece.obj; ends "--rm of a piece" 2 "a piece is not all"

# ---- What is not carried
run encode --strict lossy.obj -o x.clers; ends "encode --strict" 3 "lossy.obj: .*line.*--strict"
check "--strict makes nothing" test ! -e x.clers
run encode --strict -q grid.obj -o strict.clers; silent "encode --strict of what is carried whole"
run verify lossy.obj lossy.clers; ends "verify" 0
check "verify names what is missing" grep -qE 'same as lossy.obj, but for .*line.*: 1 mesh, 200 faces' out
run verify --strict lossy.obj lossy.clers; ends "verify --strict" 1 "differs: .*line"
run verify --strict grid.obj strict.clers; ends "verify --strict of what is carried whole" 0

# ---- What is said beside the mesh
{ echo '# made by hand'; cat grid.obj; } >said.obj
run encode --strict -q said.obj; silent "encode --strict of a file with comments"
run verify --strict said.obj said.clers; ends "verify --strict of a file with comments" 0
run info said.clers; check "info has the comment" grep -q 'made by hand' out
run info --json said.clers; check "info --json has it" grep -q '"value": ".*made by hand"' out
run verify grid.obj said.clers; ends "verify, another comment" 0
check "which is said" grep -q "same as grid.obj, but for metadata" out
run verify --strict grid.obj said.clers; ends "verify --strict, another comment" 1 "differs: metadata"

# ---- Several files
run info grid.clers other.clers; ends "info of several" 0
check "info: a heading and a line each" test "$(wc -l <out)" -eq 3
check "info: counts" grep -qE ' 121 +200 .* other.clers$' out
run check grid.obj tetrahedron.obj; ends "check of several" 0
check "check: a heading and a line each" test "$(wc -l <out)" -eq 3
check "check: counts" grep -qE '^ +4 +4 +1 +0 +0 +0  tetrahedron.obj$' out
run info grid.clers missing.clers other.clers; ends "info of several, one missing" 3 "missing.clers"
check "info: the others are told" test "$(wc -l <out)" -eq 3
if command -v python3 >/dev/null; then
  lists() { python3 -c 'import json, sys; print(len(json.load(open("out"))))'; }
  run info --json grid.clers other.clers; check "info --json of several is a list" test "$(lists)" -eq 2
  run check --json grid.obj other.obj; check "check --json of several is a list" test "$(lists)" -eq 2
  run info --json missing.clers other.clers; check "one of them missing" test "$(lists)" -eq 1
fi

# ---- Limits
for limit in --max-faces\ 199 --max-vertices\ 120 --max-memory\ 1k --max-meshes\ 0; do
  for command in "decode -f" info "verify grid.obj"; do
    run $command $limit grid.clers; ends "$command $limit" 4 "; ${limit% *} [0-9]+M? or more allows it"
  done
done
for size in 1g 1G 1GB 1GiB 1048576k 1073741824; do
  run decode -qf --max-memory $size grid.clers -c; check "--max-memory $size" test "$status" -eq 0
done
for size in -1 1e9 1KX KiB B 1iB "" 99999999999999999999 17179869184G; do
  run decode -qf --max-memory "$size" grid.clers -c; ends "--max-memory '$size'" 2 "--max-memory: expected a size"
done

# ---- Paths
ln -s loop loop
run encode grid.obj -o loop; ends "a loop of links" 5 "loop: Too many levels"
run encode grid.obj -o loop/x.clers; ends "in a loop of links" 5 "Too many levels"
run encode grid.obj -o "$(printf 'n%.0s' {1..300}).clers"; ends "a long name" 5 "File name too long"
run encode grid.obj -o "$(printf 'd/%.0s' {1..3000})x.clers"; ends "a long path" 5 "File name too long"
run encode loop; check "a loop as input" test "$status" -eq 2
run encode --from obj loop; ends "a loop as input" 3 "Too many levels"
ln -s new.clers dangling.clers
run encode -q grid.obj -o dangling.clers; silent "through a dangling link"
check "what it leads to is made" test -L dangling.clers -a -f new.clers
ln -s "$PWD/sub/newer.clers" farther; ln -s farther far.clers
run encode -qf grid.obj -o far.clers; silent "through two links, with -f"
check "what they lead to is made" test -f sub/newer.clers
ln -s nowhere/x.clers lost.clers
run encode -f grid.obj -o lost.clers; ends "a link to nowhere" 5 "lost.clers: No such file"
run encode grid.obj -o grid.obj/x.clers; ends "below a file" 5 "grid.obj/x.clers: Not a directory"
run encode grid.obj -o grid.obj/; ends "a file as directory" 5 "grid.obj/: Not a directory"
if [ "$(id -u)" -eq 0 ] && command -v setpriv >/dev/null; then
  mkdir private; chmod 755 .; chmod 700 private
  as_nobody() { setpriv --reuid 65534 --clear-groups "$clers" "$@" >/dev/null 2>err; status=$?; }
  as_nobody encode grid.obj -o private/x.clers; ends "no permission" 5 "private/x.clers: Permission denied"
  as_nobody encode grid.obj -o private/; ends "no permission for the directory" 5 "private/.*: Permission denied"
  as_nobody encode private/x.obj -c; ends "no permission to read" 3 "private/x.obj: Permission denied"
  as_nobody encode --from obj private/x -c; ends "no permission to look" 3 "private/x: Permission denied"
fi
if command -v strace >/dev/null && ! grep -q __asan_init "$clers"; then
  timeout 20 strace -f -o /dev/null -e trace=write -e inject=write:retval=0:when=1 \
    "$clers" encode -c grid.obj >out 2>err; status=$?
  ends "a write of nothing" 5 "standard output: Input/output error"
else
  echo "not tested: a write of nothing (needs strace)"
fi
no_leftovers "outputs"

# ---- Names from strangers
escape=$'\033[2Jm\n\302\233m'
cp grid.obj "$escape.obj"
run encode "$escape.obj"; ends "a name with escapes" 0
check "it is shown, not obeyed" grep -qF '\x1b[2Jm\n\xc2\x9bm.obj -> ' err
run encode "$escape.obj"; ends "a name with escapes exists" 2 'x1b'
run check "$escape.obj"; check "check shows it too" grep -qF '\x1b[2Jm' out
run verify "$escape.obj" "$escape.clers"; check "verify shows it too" grep -qF '\x1b[2Jm' out
run info "$escape.clers" grid.clers; check "info of several shows it too" grep -qF '\x1b[2Jm' out
base64 -d >terminal.clers <<'B64'
Q0xFUlMBBQEIAAAEAAAjAEG8eNxyAxMbWzJKG10wO3B3bmVkBwoiXCD/d27lXwEIAAAEAAAjAEGmTE0NAxMbWzJKG10wO3B3bmVk
BwoiXCD/0diioAABAuwRvTc=
B64
run info terminal.clers
check "a mesh's name with escapes is not obeyed" eval '! LC_ALL=C grep -q $'"'\\033'"' out err'
name=$'caf\303\251 \342\200\256txt'
cp grid.obj "$name.obj"; run check "$name.obj"
check "a name in UTF-8 stays, what turns the writing does not" grep -qF $'caf\303\251 \\xe2\\x80\\xaetxt.obj' out
for broken in $'\300\257' $'\355\240\200' $'\370' $'\303'; do
  run check "$broken.obj"; check "what is no UTF-8 is shown" grep -q '\\x..' err
done
finish
