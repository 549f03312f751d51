#!/bin/bash
# Tests the program clers as its users meet it: outputs, exit statuses, messages, and what is left behind.
# usage: cli_test.sh PROGRAM
. "$(dirname "$0")/harness.sh" "$1"

grid 10 >grid.obj
tetrahedron >tetrahedron.obj

# ---- There and back
run encode grid.obj -o grid.clers; ends "encode" 0
check "encode makes a smaller file" test "$(stat -c %s grid.clers)" -lt "$(stat -c %s grid.obj)"
run verify grid.obj grid.clers; ends "verify" 0
check "verify says so" grep -q "same as grid.obj" out
run verify -q grid.obj grid.clers; ends "verify -q" 0
check "verify -q is silent" test ! -s out
# Tori that look alike from everywhere, of two shapes, with fins that all meet at one vertex: whether as
# many of each are the same is a search through all their orders.
tori() {
  awk -v shapes="$1" 'BEGIN {
    print "v 0 0 0"; last = 1
    for (k = split(shapes, columns, " "); k > 0; k--) {
      c = columns[k]; r = 36 / c
      for (v = 0; v < 36; v++) print "v 0 0 0"
      for (i = 0; i < r; i++) for (j = 0; j < c; j++) {
        p = i * c; q = (i + 1) % r * c; n = (j + 1) % c
        print "f", at(p + j), at(p + n), at(q + n); print "f", at(p + j), at(q + n), at(q + j)
        print "f", 1, at(p + j), at(p + n)
      }
      last += 36
    } }
    function at(v) { return last + v + 1 }'
}
tori "9 9 9 9 6 6 6 6" >fours.obj
tori "9 9 9 9 9 6 6 6" >five-three.obj
run encode five-three.obj -o five-three.clers; ends "encode tori at a vertex" 0
run verify five-three.obj five-three.clers; ends "verify tori at a vertex" 0
run verify fours.obj five-three.clers; ends "verify gives up" 6 "neither equal nor different could be shown"
rm five-three.clers
for format in ply obj off; do
  run decode grid.clers -o back.$format
  check "decode to $format" test "$status" -eq 0
  run encode -q back.$format -o again.clers -f; ends "encode $format" 0
  run verify -q grid.obj again.clers; ends "verify through $format" 0
done
run decode -q grid.clers -o back.stl; ends "decode to stl" 0
run decode -q grid.clers -o text.ply --text; ends "decode --text" 0
check "decode --text writes text" grep -q "^format ascii 1.0" text.ply
for level in 1 9; do
  run encode grid.obj --level $level -o level.clers -f; ends "encode --level $level" 0
  run verify grid.obj level.clers; ends "verify level $level" 0
done


# ---- Less exact
run encode --positions q8 grid.obj -o q8.clers
check "encode --positions" test "$status" -eq 0
check "the error is named" grep -q "note: 'position' is off by [0-9.e-]* at most" err
run verify grid.obj q8.clers; ends "verify within the error" 0
check "verify names the error" grep -q "every value bit for bit, but 'position' is off by .* at most, as stated" out
run info q8.clers; check "info names the error" grep -q "position .* off by [0-9.e-]* at most" out
run info --json q8.clers; check "info --json has it" grep -q '"error": [0-9.e-]*[1-9]' out
run decode -q q8.clers -o q8.obj; run verify grid.obj q8.clers; ends "verify again" 0
run encode -q q8.obj -o exact.clers; run verify grid.obj exact.clers
ends "an error that is not stated is a difference" 1 "differs"
run encode --positions q8 --order keep grid.obj -o kept.clers; run verify grid.obj kept.clers
check "the order is kept" grep -q "as stated, in the same order" out
run encode -q --positions lossless grid.obj -o lossless.clers; check "lossless is the default" cmp -s grid.clers lossless.clers
run encode --positions q20 --pieces 50 grid.obj -o pieces.clers; run verify grid.obj pieces.clers; ends "verify pieces on a grid" 0
cp grid.obj removed.obj; run encode --rm --positions step0.1 removed.obj; check "what is not exact is not removed" test -e removed.obj
{ seq 30 | sed 's/.*/v 0.& 0.5 0.1/'; echo 'v 0.5 99 0.1'; echo 'f 1 2 31'; } >far.obj
run encode --positions q8 far.obj; check "a vertex far away is named" grep -q "note: 'position' has values far .* vertex 30: without" err
run encode --attribute position=grid:0,0,-1:0.25 grid.obj -o on.clers; run decode -q on.clers -o on.obj
check "values are on the grid" eval '! grep "^v " on.obj | tr " " "\n" | grep -vE "^(v|-?[0-9]+(\.(25|5|75))?)$"'
rm -f q8.* exact.clers kept.clers lossless.clers pieces.clers removed.* far.* on.*

# ---- Pieces and threads
for threads in 1 2 5; do
  run encode --pieces 50 --threads $threads grid.obj -o pieces-$threads.clers; ends "encode --pieces, $threads threads" 0
  run verify --threads $threads grid.obj pieces-$threads.clers; ends "verify pieces, $threads threads" 0
  check "$threads threads: the same bytes" cmp -s pieces-1.clers pieces-$threads.clers
done
run info pieces-1.clers; ends "info on pieces" 0
check "info says how many pieces" grep -q "pieces  *4" out
run info --json pieces-1.clers; check "and in JSON" grep -q '"pieces": 4' out
faces=0
for piece in 0 1 2 3; do
  run decode --piece $piece pieces-1.clers -o piece.obj -f; ends "decode --piece $piece" 0
  faces=$((faces + $(grep -c ^f piece.obj)))
done
check "the pieces are the whole" test $faces = 200
run decode --piece 4 pieces-1.clers -o piece.obj -f; ends "no such piece" 2 "piece 4, there are 4"
run encode --pieces never grid.obj -o never.clers; ends "encode --pieces never" 0
check "never: as without" cmp -s never.clers grid.clers
run encode --pieces 0 grid.obj -o never.clers -f; ends "encode --pieces 0" 2 "a number of faces or never"
check "0: as without" cmp -s never.clers grid.clers
for wrong in -1 x 5x; do
  run encode --pieces $wrong grid.obj -o wrong.clers; ends "--pieces $wrong" 2 "--pieces"
done
run encode --threads 0 grid.obj -o never.clers -f; ends "--threads 0" 0
check "0 threads: as with any" cmp -s never.clers grid.clers
for wrong in -1 x 1025; do
  run encode --threads $wrong grid.obj -o wrong.clers; ends "--threads $wrong" 2 "--threads: expected a number from 0 to 1024"
done

# ---- What most codecs drop: non-manifold edges, duplicate and degenerate faces, polygons, the order
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n' >fan.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\nf 1 2 2\n' >odd.obj
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 7 7 7\nf 3 4 1 2\nf 3 2 5\n' >quad.obj
for mesh in fan odd quad grid; do
  run encode -f $mesh.obj -o any.clers; ends "encode $mesh" 0
  run verify $mesh.obj any.clers; ends "verify $mesh" 0
  run encode -f --order keep $mesh.obj -o any.clers; ends "encode $mesh in order" 0
  run verify $mesh.obj any.clers; ends "verify $mesh in order" 0
  check "$mesh comes back in order" grep -q "in the same order" out
done

# ---- Standard input and output
"$clers" encode --from obj - -o - <grid.obj >piped.clers 2>err; status=$?; ends "encode - -o -" 0
check "encode - gives the same bytes" cmp -s piped.clers grid.clers
"$clers" decode - --to obj -o - <grid.clers >out 2>err; status=$?
check "decode - -o -" test "$status" -eq 0
check "decode -o - writes a mesh" grep -q "^f " out
"$clers" verify --from obj - grid.clers <grid.obj >out 2>err; status=$?; ends "verify - FILE" 0
"$clers" info - <grid.clers >out 2>err; status=$?; ends "info -" 0
"$clers" check --from obj - <grid.obj >out 2>err; status=$?; ends "check -" 0
run encode - -o x.clers; ends "encode - without --from" 2 "--from"
cp grid.obj misnamed.txt
run encode misnamed.txt -o x.clers; ends "unknown extension" 2 "misnamed.txt: .*--from"
run encode --from obj misnamed.txt -o misnamed.clers; ends "--from overrules the name" 0
printf x | "$clers" verify --from obj - - >out 2>err; status=$?; ends "verify - -" 2 "standard input"

# ---- Several inputs
mkdir in
cp grid.obj in/a.obj; cp tetrahedron.obj in/b.obj
run encode in/a.obj in/b.obj -o packed/; ends "several inputs" 0
check "several outputs" test -f packed/a.clers -a -f packed/b.clers
run decode packed/a.clers packed/b.clers --to off -o restored/
check "decode several" test "$status" -eq 0 -a -f restored/a.off -a -f restored/b.off
run encode in/a.obj in/b.obj -o one.clers; ends "several inputs into one file" 2 "directory"
mkdir other; cp grid.obj other/a.obj
run encode in/a.obj other/a.obj -o clash/; ends "two inputs of one name" 2 "would both become"
check "nothing is done then" test ! -e clash
rm -rf packed
printf 'v 0 0\n' >in/bad.obj
run encode -q in/a.obj in/bad.obj in/b.obj -o packed/; ends "one of several fails" 3 "in/bad.obj: line 1"
check "the others are done" test -f packed/a.clers -a -f packed/b.clers -a ! -e packed/bad.clers

# ---- Existing outputs
cp grid.clers old.clers
run encode tetrahedron.obj -o old.clers; ends "an existing output" 2 "old.clers: exists"
check "is left alone" cmp -s old.clers grid.clers
chmod 640 old.clers
run encode -f tetrahedron.obj -o old.clers; ends "-f" 0
run verify tetrahedron.obj old.clers; ends "-f overwrites" 0
check "-f keeps the permissions" test "$(stat -c %a old.clers)" = 640
ln -s old.clers link.clers
run encode -f grid.obj -o link.clers; ends "-f through a link" 0
check "the link stays" test -L link.clers
check "what it leads to is replaced" cmp -s old.clers grid.clers
(umask 027; "$clers" encode -q grid.obj -o masked.clers)
check "new files obey umask" test "$(stat -c %a masked.clers)" = 640

# ---- Differences
sed 's/^v 3 4 .*/v 3 4 0.3/' grid.obj >moved.obj
run verify moved.obj grid.clers; ends "another position" 1 "grid.clers: differs: "
run verify tetrahedron.obj grid.clers; ends "another mesh" 1 "differs: vertices: 4 and 121"
sed 's/^f 1 12 13$/f 1 13 12/' grid.obj >turned.obj
run verify turned.obj grid.clers; ends "a face turned over" 1 "differs"

# ---- Usage
run; ends "no command" 2 "a command is needed"
run frobnicate; ends "an unknown command" 2 "frobnicate"
run encode; ends "no input" 2 "FILE is required"
run encode --frobnicate grid.obj -o x; ends "an unknown option" 2 "--frobnicate"
run encode --level 10 grid.obj -o x; ends "a level too high" 2 "--level"
run decode --to gif grid.clers -o x; ends "an unknown format" 2 "--to: expected ply, obj, off, stl, glb or gltf, found 'gif'"
run decode --max-memory 3X grid.clers -o x.obj; ends "no size" 2 "3X"
for command in "" encode decode info verify check subdivide adapt simplify reconstruct; do
  run $command --help; ends "clers $command --help" 0
  check "clers $command --help has examples" grep -q "^  clers ${command:-encode} " out
done
run --version; ends "--version" 0
check "--version" grep -qE '^clers [0-9]+\.[0-9]+\.[0-9]+$' out

# ---- Inputs that are not accepted
run encode missing.obj -o x.clers; ends "a missing input" 3 "missing.obj: No such file"
run decode missing.clers -o x.obj; ends "a missing .clers file" 3 "missing.clers: No such file"
run encode in -o x.clers --from obj; ends "a directory as input" 3 "in: is a directory"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 9\n' >range.obj
run encode range.obj -o x2.clers; ends "an index out of range" 3 "range.obj: line 5: "
run encode --on-nonmanifold reject fan.obj -o x2.clers
ends "a non-manifold edge" 3 "fan.obj: face 0: .*edge of vertices 0 and 1 "
run encode --on-degenerate reject odd.obj -o x2.clers; ends "a degenerate face" 3 "odd.obj: face 2: "
run encode --on-duplicate reject odd.obj -o x2.clers; ends "a duplicate face" 3 "odd.obj: face 1: "
run check --json fan.obj
check "check counts it" grep -q '"nonmanifold_edges": 1,' out
run decode grid.obj -o x.obj; ends "decode of a mesh file" 3 "grid.obj: is no .clers file but a mesh file"
run info grid.obj; ends "info of a mesh file" 3 "clers check"
for n in 0 3 20 60; do
  head -c $n grid.clers >short.clers
  run decode short.clers -o x.obj; ends "the first $n bytes" 3 "short.clers: "
done
{ cat grid.clers; printf x; } >long.clers
run decode long.clers -o x.obj; ends "a byte too many" 3 "long.clers: byte "
check "no failed run leaves an output" test ! -e x.obj -a ! -e x2.clers

# ---- Limits
run decode --max-faces 100 grid.clers -o x.obj; ends "--max-faces" 4 "grid.clers: "
run decode --max-vertices 100 grid.clers -o x.obj; ends "--max-vertices" 4 "grid.clers: "
run decode --max-memory 1K grid.clers -o x.obj; ends "--max-memory" 4 "grid.clers: "
run decode --max-meshes 0 grid.clers -o x.obj; ends "--max-meshes" 4 "grid.clers: "
run verify --max-faces 100 grid.obj grid.clers; ends "verify --max-faces" 4 "grid.clers: "
run decode --max-faces 200 --max-vertices 121 --max-memory 2M grid.clers -o x.off; status_limits=$status
check "limits that suffice" test "$status_limits" -eq 0
grid 400 >big.obj
if ! grep -q __asan_init "$clers"; then  # its shadow memory alone is larger than any limit
  (ulimit -v 24000; "$clers" encode big.obj -o x.clers2 >out 2>err); status=$?
  ends "out of memory" 4 "big.obj: not enough memory"
fi

# ---- Writing fails
run encode grid.obj -o nowhere/x.clers; ends "a missing directory" 5 "nowhere/x.clers: No such file"
run encode grid.obj -o grid.obj/; ends "a file as directory" 5 "grid.obj/: Not a directory"
for command in "encode grid.obj -o /dev/full -f" "encode grid.obj -o -" "info grid.clers" "check grid.obj" \
  "verify grid.obj grid.clers" "help encode" "--help" "--version"; do
  "$clers" $command >/dev/full 2>err </dev/null; status=$?
  ends "a full device: $command" 5 "No space left"
done
"$clers" decode grid.clers --to obj -o - 2>err | true
check "a reader that leaves" test "$(grep -c 'Broken pipe' err)" -eq 0  # it may leave too late
run encode big.obj -o big.clers
"$clers" decode big.clers --to obj -o - 2>err | head -c 1 >/dev/null; status=${PIPESTATUS[0]}
check "a pipe closed early" test "$status" -eq 5 -a ! -s err  # who reads has seen enough
(ulimit -f 1; "$clers" encode -f big.obj -o old.clers >out 2>err); status=$?
ends "a file too large" 5 "old.clers: File too large"
check "leaves the old one" cmp -s old.clers grid.clers
no_leftovers "a failed write"
if [ "$(id -u)" -eq 0 ] && mkdir small && mount -t tmpfs -o size=8k tmpfs small 2>/dev/null; then
  cp grid.clers small/old.clers
  run encode -f big.obj -o small/old.clers; ends "a full disk" 5 "No space left"
  check "leaves the old file" cmp -s small/old.clers grid.clers
  run encode big.obj -o small/new.clers; ends "a full disk" 5 "No space left"
  check "leaves no new file" test ! -e small/new.clers
  no_leftovers "a full disk" small
  umount small
else
  echo "not tested: a full disk (needs root and mount)"
fi

# ---- Killed in the middle
mkdir killed
cp grid.clers killed/old.clers
for signal in KILL TERM INT; do
  for delay in 0.01 0.05 0.1 0.15 0.2 0.25 0.3 0.4; do
    "$clers" encode -f big.obj -o killed/old.clers >out 2>err </dev/null & pid=$!
    sleep $delay
    kill -$signal $pid 2>/dev/null
    wait $pid 2>/dev/null; status=$?
    check "SIG$signal after $delay s: the old file or the new one" \
      eval 'cmp -s killed/old.clers grid.clers || cmp -s killed/old.clers big.clers'
    cp grid.clers killed/old.clers
  done
done
no_leftovers "killed" killed
check "killed: nothing else" test "$(ls -A killed)" = old.clers

# ---- The reports
run info --json grid.clers; ends "info --json" 0
for key in vertices faces triangles components boundary_curves genus nonmanifold_edges \
  nonmanifold_vertices connectivity_bytes position_bytes attribute_bytes metadata_bytes overhead_bytes total_bytes \
  connectivity_bits_per_triangle symbols; do
  check "info --json has $key" grep -q "^  \"$key\": " out
done
number() { sed -n "s/^  \"$1\": \([0-9.]*\),\{0,1\}$/\1/p" out; }
check "vertices" test "$(number vertices)" = 121
check "faces" test "$(number faces)" = 200
check "components" test "$(number components)" = 1
check "boundary curves" test "$(number boundary_curves)" = 1
check "genus" test "$(number genus)" = 0
check "total_bytes is the file's size" test "$(number total_bytes)" = "$(stat -c %s grid.clers)"
check "the bytes add up" test $(($(number connectivity_bytes) + $(number position_bytes) + \
  $(number attribute_bytes) + $(number metadata_bytes) + $(number overhead_bytes))) = "$(number total_bytes)"
run check --json grid.obj; ends "check --json" 0
check "check --json agrees" test "$(number vertices) $(number triangles) $(number boundary_curves)" = "121 200 1"
run check tetrahedron.obj; ends "check" 0
check "check is readable" grep -qE "^  genus +0$" out

# ---- Subdivision
counts() { run check --json "$1"; echo "$(number triangles) $(number vertices) $(number components) $(number boundary_curves) $(number genus)"; }
run subdivide grid.obj -o finer.ply --scheme loop; ends "subdivide" 0
check "subdivide reports" grep -q "^grid.obj: loop, 1 time: 200 -> 800 triangles, 121 -> 441 vertices; 1 component, 1 boundary curve, genus 0$" err
check "loop makes four of one" test "$(counts finer.ply)" = "800 441 1 1 0"
run subdivide -q grid.obj -o finer.off --scheme sqrt3 --times 2; ends "subdivide by sqrt3, twice" 0
check "subdivide -q is silent" test ! -s out -a ! -s err
check "sqrt3 makes nine of one" test "$(counts finer.off)" = "1800 961 1 1 0"
run subdivide -q grid.obj -o finer.obj --scheme 4-8 --times 3; ends "subdivide by 4-8" 0
check "4-8 makes two of one" test "$(counts finer.obj | cut -d' ' -f3-)" = "1 1 0"
cat tetrahedron.obj - >two.obj <<'END'
v 5 0 0
v 6 0 0
v 5 1 0
f 5 6 7
END
run subdivide -q two.obj -o two.ply --scheme loop --times 3; ends "subdivide two components" 0
check "components and boundaries stay" test "$(counts two.ply)" = "320 175 2 1 0"
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n' >square.obj
run subdivide square.obj -o x.obj --scheme loop; ends "subdivide polygons" 3 "square.obj: face 0: has 4 corners"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n' >book.obj
run subdivide book.obj -o x.obj --scheme loop; ends "subdivide a non-manifold edge" 3 "book.obj: .*edge of vertices 0 and 1"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 1 4 5\n' >bow.obj
run subdivide bow.obj -o x.obj --scheme sqrt3; ends "subdivide a non-manifold vertex" 3 "bow.obj: vertex 0: "
printf 'v 0 0 0\nv 1 0 0\nf 1 2 2\n' >thin.obj
run subdivide thin.obj -o x.obj --scheme 4-8; ends "subdivide a degenerate face" 3 "thin.obj: face 0: uses a vertex twice"
run subdivide grid.obj -o x.obj --scheme loop --times 30; ends "subdivide beyond all ids" 4 "grid.obj: would become"
run subdivide grid.obj -o x.obj --scheme loop --times 0; ends "subdivide no times" 2 "--times"
run subdivide grid.obj -o x.obj; ends "subdivide without a scheme" 2 "--scheme is required"
run subdivide grid.obj -o x.obj --scheme catmull; ends "subdivide by an unknown scheme" 2 "--scheme"
run subdivide grid.obj -o finer.ply --scheme loop; ends "subdivide onto an output" 2 "finer.ply: exists"
check "no refused subdivision leaves an output" test ! -e x.obj
"$clers" subdivide --from obj - --to off -o - --scheme loop <grid.obj >out 2>err; status=$?
ends "subdivide - -o -" 0
check "subdivide -o - writes only the mesh" test "$(head -n 1 out)" = OFF
cat >colour.ply <<'END'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
element face 1
property list uchar int vertex_indices
property int material
end_header
0 0 0 255 0 0
1 0 0 255 0 0
0 1 0 0 255 0
9 9 9 1 2 3
3 0 1 2 7
END
run subdivide colour.ply -o coloured.ply --text --scheme loop
check "subdivide carries values of vertices" grep -q "^0.5 0 0 255 0 0$" coloured.ply
check "subdivide notes what it leaves out" test "$(grep -c 'left out' err)" -eq 2

# ---- Progress
if command -v script >/dev/null; then
  # A bar comes after half a second, which a slow input takes on any machine.
  on_terminal() { # ARGUMENTS...
    script -qec "{ sleep 0.7; cat medium.obj; } | '$clers' $*" /dev/null >terminal </dev/null
    status=$?
  }
  grid 150 >medium.obj
  on_terminal encode --from obj - -o medium.clers -f
  check "a terminal sees a bar" grep -q '\[#*\.*\] .*%.*standard input' terminal
  check "that is erased before the result" grep -q $'\r\033\\[Kstandard input -> medium.clers: ' terminal
  on_terminal encode -q --from obj - -o medium.clers -f
  check "-q shows none" test ! -s terminal
  on_terminal subdivide --from obj - -o larger.ply --scheme loop --times 2
  check "a terminal sees how subdivision goes" grep -q '% subdividing .*standard input' terminal
  { sleep 0.7; cat medium.obj; } | "$clers" encode --from obj - -o medium.clers -f >out 2>err
  status=$?; ends "a file sees none" 0
else
  echo "not tested: the progress bar (needs script)"
fi

finish
