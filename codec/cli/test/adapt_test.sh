#!/bin/bash
# The command adapt: what it makes is a mesh of the same topology, as fine as was asked for where.
# usage: adapt_test.sh PROGRAM
. "$(dirname "$0")/harness.sh" "$1"
touch err

# sphere N: a grid of 6 faces of a cube, N x N quadrilaterals each, on the unit sphere; quads or (tri) triangles.
sphere() {
  awk -v n="$1" -v tri="${2:-0}" '
    function vertex(x, y, z,   key, l) {
      key = x " " y " " z
      if (!(key in id)) {
        l = sqrt((x - n) ^ 2 + (y - n) ^ 2 + (z - n) ^ 2)
        printf "v %.9g %.9g %.9g\n", (x - n) / l, (y - n) / l, (z - n) / l
        id[key] = ++count
      }
      return id[key]
    }
    function face(a, b, c, d) {
      if (tri) out[m++] = "f " a " " b " " c "\nf " a " " c " " d
      else out[m++] = "f " a " " b " " c " " d
    }
    BEGIN {
      for (i = 0; i < 2 * n; i += 2) for (j = 0; j < 2 * n; j += 2) {
        face(vertex(i, j, 2 * n), vertex(i + 2, j, 2 * n), vertex(i + 2, j + 2, 2 * n), vertex(i, j + 2, 2 * n))
        face(vertex(i, j + 2, 0), vertex(i + 2, j + 2, 0), vertex(i + 2, j, 0), vertex(i, j, 0))
        face(vertex(2 * n, i, j), vertex(2 * n, i + 2, j), vertex(2 * n, i + 2, j + 2), vertex(2 * n, i, j + 2))
        face(vertex(0, i, j + 2), vertex(0, i + 2, j + 2), vertex(0, i + 2, j), vertex(0, i, j))
        face(vertex(j, 2 * n, i), vertex(j, 2 * n, i + 2), vertex(j + 2, 2 * n, i + 2), vertex(j + 2, 2 * n, i))
        face(vertex(j + 2, 0, i), vertex(j + 2, 0, i + 2), vertex(j, 0, i + 2), vertex(j, 0, i))
      }
      for (i = 0; i < m; i++) print out[i]
    }'
}
number() { sed -n "s/^ *\"$1\": \([-+.e0-9]*\),*$/\1/p" report | head -n 1; }
# below A B: as numbers
below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a <= b) }'; }
# adapt ARGUMENTS...: runs it with --json; its report goes to the file report
adapt() {
  run adapt -f --json "$@"
  cp out report
}
shape() { "$clers" check --json "$1" >report; echo "$(number components) $(number boundary_curves) $(number genus) $(number degenerate_faces) $(number nonmanifold_edges)"; }

sphere 3 >quads.obj
sphere 24 1 >fine.obj
grid 10 >grid.obj
grid 40 | awk '/^v/ { $2 /= 4; $3 /= 4; $4 = ($2 - 5) * ($2 - 5) / 20 } { print }' >bent.obj

# ---- The base
adapt quads.obj -o a.obj --level 0; ends "quadrilaterals" 0
check "quadrilaterals are blocks as they are" test "$(number triangles) $(number vertices)" = "108 56"
adapt quads.obj -o a.obj --level 4; ends "--level" 0
check "each level makes two of one" test "$(number triangles) $(number levels)" = "1728 4"
adapt fine.obj -o a.ply --level 0 --base 100; ends "a coarse base" 0
check "a coarse base is coarse: $(number base_triangles)" test "$(number base_triangles)" -le 100
check "its topology stays" test "$(shape a.ply)" = "1 0 0 0 0"
adapt fine.obj -o a.ply --level 1 --base input; ends "--base input" 0
check "--base input keeps all" test "$(number base_triangles)" = 6912

# ---- Errors and lengths
for error in 0.02 0.005; do
  adapt fine.obj -o a.ply --base 100 --error $error; ends "--error $error" 0
  check "--error $error is kept: $(number error)" below "$(number error)" $error
  check "no vertex is off the surface" test "$(number vertices_off_surface) $(number turned_faces)" = "0 0"
  check "it is a sphere" test "$(shape a.ply)" = "1 0 0 0 0"
  "$clers" check --json a.ply >report
  eval "faces_${error#0.}=$(number faces)"
done
check "a smaller error takes more faces" test "$faces_02" -lt "$faces_005"
adapt fine.obj -o b.ply --base 100 --error 0.25%
adapt fine.obj -o c.ply --base 100 --error 0.00866025403784; check "% is of the diagonal" cmp -s b.ply c.ply
adapt fine.obj -o a.ply --base 100 --edge-length 0.2; ends "--edge-length" 0
check "--edge-length is kept: $(number longest_edge)" below "$(number longest_edge)" 0.2
adapt fine.obj -o a.ply --base 100 --edge-length 0.2 --error 0.001
check "both are kept" below "$(number longest_edge) $(number error)" "0.2 0.001"

# ---- --max-faces
adapt fine.obj -o a.ply --base 100 --error 0.0001 --max-faces 500; ends_status=$status
check "--max-faces is kept: $(number triangles)" test "$ends_status" -eq 0 -a "$(number triangles)" -le 500
check "it is nearly reached" test "$(number triangles)" -ge 490
check "which is said" grep -q "note: not all was refined: --max-faces 500 allows no more" err
check "in JSON, too" grep -q '"limit_reached": true' report

# ---- Near a place
adapt quads.obj -o a.obj --near 0,0,1,0.1 --level 10; ends "--near" 0
near() { awk '/^v/ { n += $4 > 0.8 } /^v/ { m += $4 < -0.8 } END { print n - m }' a.obj; }
check "it is fine there" test "$(near)" -gt 50
check "and coarse elsewhere: $(number triangles)" test "$(number triangles)" -lt 450
adapt quads.obj -o a.obj --near 0,0,1,0.1 --near 0,0,-1,0.1 --level 10; ends "--near twice" 0
check "it is fine at both places" test "$(near)" -eq 0 -a "$(number triangles)" -gt 450

# ---- Boundaries
adapt bent.obj -o a.obj --base 60 --error 0.01; ends "an open surface" 0
check "it has its rim" test "$(shape a.obj)" = "1 1 0 0 0"
rim() { awk '/^v/ && ($2 < 0 || $2 > 10 || $3 < 0 || $3 > 10) { n++ } /^v (0|10) (0|10) / { c++ } END { print n + 0, c }' "$1"; }
check "which is where it was: $(rim a.obj)" test "$(rim a.obj)" = "0 4"

# ---- Several components, handles
{ cat bent.obj; awk '/^v/ { $3 += 100 } /^f/ { for (i = 2; i < 5; i++) $i += 1681 } { print }' bent.obj; } >two.obj
adapt two.obj -o a.ply --base 40 --edge-length 1; ends "two components" 0
check "both are there" test "$(shape a.ply)" = "2 2 0 0 0"
awk 'BEGIN { n = 24; m = 12; pi = atan2(0, -1)
  for (i = 0; i < n; i++) for (j = 0; j < m; j++) { a = 2 * pi * i / n; b = 2 * pi * j / m
    print "v", (3 + cos(b)) * cos(a), (3 + cos(b)) * sin(a), sin(b) }
  for (i = 0; i < n; i++) for (j = 0; j < m; j++) { k = (i + 1) % n; l = (j + 1) % m
    print "f", i * m + j + 1, k * m + j + 1, k * m + l + 1, i * m + l + 1 } }' >torus.obj
adapt torus.obj -o a.ply --base 150 --error 2%; ends "a torus" 0
check "the torus has its handle" test "$(shape a.ply)" = "1 0 1 0 0"

# ---- Values, formats, frames
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
run adapt -f colour.ply -o coloured.ply --text --level 1
check "values of vertices are carried" grep -q "^0.5 0 0 255 0 0$" coloured.ply
check "what is left out is noted" test "$(grep -c 'left out' err)" -eq 2
"$clers" adapt --from obj - --to off -o - --level 1 <grid.obj >out 2>err; status=$?; ends "adapt - -o -" 0
check "standard output has only the mesh" test "$(head -n 1 out)" = OFF
run adapt quads.obj -o last.ply --level 3 --frames levels; ends "--frames" 0
check "a frame of each level" test "$(ls levels | tr '\n' ' ')" = "frame-0001.ply frame-0002.ply frame-0003.ply frame-0004.ply "
check "the last is the output" cmp -s levels/frame-0004.ply last.ply
run adapt quads.obj -o x.ply --level 3 --frames levels; ends "frames that exist" 2 "frame-0001.ply: exists"
run adapt quads.obj -o x.ply --level 3 --frames quads.obj; ends "a file for a directory" 5 "quads.obj: Not a directory"
run adapt -f quads.obj -o last.off --near 0,0,1,0.5 --near 1,0,0,0.5 --level 6 --frames way; ends "a ball that moves" 0
check "a frame for each half radius" test "$(ls way | wc -l)" -eq 7
check "the output is where it ends" cmp -s way/frame-0007.off last.off
run adapt -q quads.obj -o there.off --near 1,0,0,0.5 --level 6
counts() { sed -n 2p "$1"; }
check "nothing is left of where it was" test "$(counts last.off)" = "$(counts there.off)"
check "-q is silent" test ! -s out -a ! -s err

# ---- Refused
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n' >book.obj
run adapt book.obj -o x.obj --level 1; ends "a non-manifold edge" 3 "book.obj: .*edge of vertices 0 and 1"
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3 4\n' >double.obj
run adapt double.obj -o x.obj --level 1; ends "polygons that run the same way" 3 "double.obj: "
printf 'v 1e200 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >far.obj
run adapt far.obj -o x.obj --level 1; ends "a place too far away" 3 "far.obj: vertex 0: is at .*, expected a number below 1e100"
printf 'v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n' >point.obj
adapt point.obj -o a.obj --level 5 --error 1e-9 --edge-length 1e-9; ends "a mesh at one point" 0
printf '# nothing\n' >empty.obj
run adapt -f empty.obj -o a.obj --level 5; ends "no faces" 0
check "nothing refused leaves an output" test ! -e x.obj
finish
