#!/bin/bash
# The command simplify: what it makes is a smaller mesh of the same topology, with all that it had; and what it is not says a note.
# usage: simplify_test.sh PROGRAM
. "$(dirname "$0")/harness.sh" "$1"
touch err

number() { sed -n "s/^ *\"$1\": \"*\([-+.a-z0-9]*\)\"*,*$/\1/p" report | head -n 1; }
numbers() { for name in "$@"; do number "$name"; done | tr '\n' ' '; }
# below A B: as numbers
below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a <= b) }'; }
# few N: the number that were asked for are left, or one less: an edge inside has two faces
few() { test "$(number triangles)" -le "$1" -a "$(number triangles)" -ge $(($1 - 1)) -a "$(number ended)" = faces; }
# simplify ARGUMENTS...: runs it with --json; its report goes to the file report
simplify() {
  run simplify -f --json "$@"
  cp out report
}
shape() { "$clers" check --json "$1" >report; numbers faces components boundary_curves genus degenerate_faces nonmanifold_edges nonmanifold_vertices; }
done_with() { check "$1: status 0" test "$status" -eq 0; }
noted() { check "$1: notes $2" grep -q "note: .*$2" err; }

grid 20 | awk '/^v/ { $4 = sin($2 / 4) * cos($3 / 4) } { print }' >wave.obj
grid 20 | awk '/^v/ { $4 = 0 } { print }' >flat.obj
# torus SIZE: of quadrilaterals
torus() {
  awk -v n="$1" 'BEGIN { m = n / 2; pi = atan2(0, -1)
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) { a = 2 * pi * i / n; b = 2 * pi * j / m
      print "v", (3 + cos(b)) * cos(a), (3 + cos(b)) * sin(a), sin(b) }
    for (i = 0; i < n; i++) for (j = 0; j < m; j++) { k = (i + 1) % n; l = (j + 1) % m
      print "f", i * m + j + 1, k * m + j + 1, k * m + l + 1, i * m + l + 1 } }'
}
torus 40 >torus.obj

# ---- How many faces
simplify wave.obj -o a.ply; ends "no option" 0
check "half the faces are left" test "$(numbers triangles_before triangles ended)" = "800 400 faces "
check "they are in the file" test "$(shape a.ply)" = "400 1 1 0 0 0 0 "
simplify wave.obj -o a.ply --faces 100; check "--faces N" few 100
check "the error is said" below 0.001 "$(number error)"
check "and the worst triangles" below 0.05 "$(number worst_radius_ratio)"
simplify wave.obj -o a.ply --faces 12.5%; check "--faces P%" few 100
for many in 100% 800 9000; do
  simplify wave.obj -o a.ply --faces $many
  check "--faces $many: nothing is to be done" test "$(numbers triangles error ended)" = "800 0.0 faces "
done
for none in 0 0%; do
  simplify torus.obj -o a.ply --faces $none; done_with "--faces $none"
  check "--faces $none: as few as a torus can have: $(number triangles)" test "$(number triangles)" -le 20 -a "$(number ended)" = smallest
done
check "which is a torus" test "$(shape a.ply | cut -d' ' -f2-)" = "1 0 1 0 0 0 "
run simplify -f torus.obj -o a.ply --faces 1
noted "fewer than there can be" "faces are the fewest that keep components"
noted "quadrilaterals" "800 polygons are cut into triangles"

# ---- How far
simplify wave.obj -o a.ply --error 0.05; ends "--error" 0
check "--error is kept: $(number error)" below "$(number error)" 0.05
check "it is why it ends" test "$(number ended)" = error
fine=$(number triangles)
simplify wave.obj -o a.ply --error 0.2; check "a larger error takes fewer faces" test "$(number triangles)" -lt "$fine"
simplify wave.obj -o a.ply --error 0.1% --faces 10%
noted "both" "faces are the fewest within the error"
simplify flat.obj -o a.obj --error 0; ends "--error 0" 0
check "--error 0 takes out what is flat: $(number triangles)" test "$(number triangles)" -lt 20
check "and nothing else" below "$(number error)" 1e-7
check "its rim stays" test "$(awk '/^v/ && ($2 == 0 || $2 == 20) && ($3 == 0 || $3 == 20)' a.obj | wc -l)" = 4

# ---- Values
cat >colour.ply <<'END'
ply
format ascii 1.0
element vertex 5
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
property int label
element face 4
property list uchar int vertex_indices
property int material
end_header
0 0 0 200 0 0 7
2 0 0 200 0 0 7
2 2 0 200 0 0 7
0 2 0 200 0 0 7
1 1 0 200 0 0 9
3 0 1 4 3
3 1 2 4 3
3 2 3 4 3
3 3 0 4 3
END
run simplify -f colour.ply -o coloured.ply --text --error 0; ends "values" 0
check "colours and labels of vertices go along" test "$(grep -c '^[02] [02] 0 200 0 0 7$' coloured.ply)" -eq 4
check "and those of faces" test "$(grep -c '^3 [0-3] [0-3] [0-3] 3$' coloured.ply)" -eq 2
check "nothing is left out" eval '! grep -q "left out" err'

# A grid with texture coordinates, on two charts that meet at x = 10, and a material each.
awk 'BEGIN { n = 20
  for (i = 0; i <= n; i++) for (j = 0; j <= n; j++) print "v", i, j, 0
  for (c = 0; c < 2; c++) for (i = 0; i <= n; i++) for (j = 0; j <= n; j++) print "vt", i / n + 3 * c, j / n
  for (i = 0; i < n; i++) {
    if (i % 10 == 0) print "usemtl m" i
    for (j = 0; j < n; j++) {
      a = i * (n + 1) + j + 1; b = a + n + 1; t = (i >= 10) * (n + 1) * (n + 1)
      print "f", a "/" a + t, b "/" b + t, b + 1 "/" b + 1 + t
      print "f", a "/" a + t, b + 1 "/" b + 1 + t, a + 1 "/" a + 1 + t
    } } }' >charts.obj
simplify charts.obj -o a.obj --faces 40; done_with "charts"
check "charts: $(number triangles) faces" few 40
# charts FILE: how many corners are off x/20 (+ 3), y/20, and how many faces reach over x = 10 or are of the other material
charts() {
  awk '/^v / { x[++n] = $2; y[n] = $3 } /^vt / { s[++m] = $2; t[m] = $3 } /^usemtl/ { right = $2 == "m10" }
    /^f / { for (i = 2; i <= 4; i++) { split($i, c, "/"); v = c[1]; w = c[2]
        off += (s[w] - 3 * right - x[v] / 20) ^ 2 > 1e-6 || (t[w] - y[v] / 20) ^ 2 > 1e-6
        over += right ? x[v] < 9.95 : x[v] > 10.05 } }
    END { print off + 0, over + 0 }' "$1"
}
check "texture coordinates are where they were, charts and materials do not mix: $(charts a.obj)" test "$(charts a.obj)" = "0 0"
check "a corner of a seam has two" test "$(grep -c '^vt' a.obj)" -gt "$(grep -c '^v ' a.obj)"

# Every face has its own coordinates: nothing of them can go along.
awk 'NR == FNR { if (/^f/) n++; next } FNR == 1 { for (i = 0; i < 3 * n; i++) print "vt", i % 13 / 13, i / 999 }
  /^f/ { print "f", $2 "/" ++k, $3 "/" ++k, $4 "/" ++k; next } { print }' wave.obj wave.obj >atlas.obj
simplify atlas.obj -o a.obj --faces 50%; done_with "seams everywhere"
noted "seams everywhere" 'attribute "texcoord" is left out: it has seams at most edges'
check "seams everywhere keep nothing from going" test "$(number triangles)" -eq 400

# ---- What is no manifold
printf 'v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nv 2 2 2\nv 3 3 3\nf 1 2 3\nf 2 1 4\nf 1 2 5\nf 3 3 1\n' >book.obj
simplify book.obj -o a.obj --faces 100%; done_with "a book"
noted "a book" "2 vertices are doubled"
noted "a book" "1 face without area, on a vertex twice, is left out"
noted "a book" "1 isolated vertex is left out"
check "a book is cut: $(numbers vertices_doubled faces_left_out triangles components)" test "$(numbers vertices_doubled faces_left_out triangles components)" = "2 1 3 2 "
check "what comes out is a manifold" test "$(shape a.obj)" = "3 2 2 0 0 0 0 "
{ tetrahedron; echo 'f 1 2 3'; } >double.obj
simplify double.obj -o a.obj --faces 100%; noted "a face twice" "1 face that repeats another one is left out"
{ tetrahedron | sed 's/^f 1 3 2/f 1 2 3/'; } >turned.obj
simplify turned.obj -o a.obj --faces 0; noted "a face turned" "1 face is turned around"
check "it closes a tetrahedron" test "$(shape a.obj)" = "4 1 0 0 0 0 0 "
{ tetrahedron; printf 'v -1 0 0\nv 0 -1 0\nv 0 0 -1\nf 1 5 6\nf 1 6 7\nf 1 7 5\nf 5 7 6\n'; } >hourglass.obj
simplify hourglass.obj -o a.obj --faces 1; done_with "an hourglass"
noted "an hourglass" "1 vertex is doubled"
check "both its parts stay" test "$(shape a.obj)" = "8 2 0 0 0 0 0 "
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 0 0 -1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 5 2\nf 1 2 6\nf 2 5 6\nf 5 1 6\n' >hinge.obj
simplify hinge.obj -o a.obj --faces 99; noted "an edge of four faces" "1 edge of more than two faces is taken for several edges"
awk 'BEGIN { n = 30; for (i = 0; i < n; i++) { a = 6.2831853 * i / n
    for (s = -1; s < 2; s++) print "v", (2 + s * cos(a / 2) / 2) * cos(a), (2 + s * cos(a / 2) / 2) * sin(a), s * sin(a / 2) / 2 }
  for (i = 0; i < n; i++) for (s = 0; s < 2; s++) { k = i * 3 + s + 1; l = i < n - 1 ? k + 3 : 3 - s; m = i < n - 1 ? k + 4 : 2 - s
    print "f", k, l, m; print "f", k, m, k + 1 } }' >moebius.obj
simplify moebius.obj -o a.obj --faces 20; done_with "one side"
noted "one side" "vertices are doubled"
check "a strip is left of it" test "$(shape a.obj | cut -d' ' -f2-)" = "1 1 0 0 0 0 "

# ---- Extremes
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >one.obj
for faces in 0 1 50%; do
  simplify one.obj -o a.obj --faces $faces; ends "one triangle, --faces $faces" 0
  check "one triangle stays one" test "$(shape a.obj)" = "1 1 1 0 0 0 0 "
done
printf '# nothing\n' >empty.obj
simplify empty.obj -o a.obj; ends "no faces" 0
check "nothing is left" test "$(shape a.obj)" = "0 0 0 0 0 0 0 "
printf 'v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 3 2\nf 1 2 4\nf 2 3 5\nf 3 1 5\nf 2 5 4\nf 1 4 5\n' >point.obj
simplify point.obj -o a.obj --faces 0; ends "a mesh at one point" 0
check "it stays closed" test "$(shape a.obj | cut -d' ' -f2-)" = "1 0 0 0 0 0 "
printf 'v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >nan.obj
run simplify nan.obj -o x.obj; ends "a place that is none" 3 "nan.obj: vertex 0: is at nan, expected a number below 1e100"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\n' >unused.obj
run simplify -f unused.obj -o a.obj; done_with "but of an isolated vertex"
awk '/^v/ { for (i = 2; i < 5; i++) $i = $i * 1e60 } { print }' wave.obj >huge.obj
simplify huge.obj -o a.obj --faces 100; check "a huge mesh" few 100
check "nothing refused leaves an output" test ! -e x.obj

# ---- Files
"$clers" simplify --from obj - --to off -o - <wave.obj >out 2>err; status=$?; ends "simplify - -o -" 0
check "standard output has only the mesh" test "$(head -n 1 out)" = OFF
run simplify -q -f wave.obj -o a.stl; check "-q is silent" test ! -s out -a ! -s err
check "the result is said" eval '"$clers" simplify -f wave.obj -o a.ply 2>&1 | grep -q "^wave.obj: 800 -> 400 triangles, 441 -> [0-9]* vertices; error .* % of the diagonal), 5 % of the radius ratios below .*; 1 component, 1 boundary curve, genus 0$"'
run simplify wave.obj -o a.ply; ends "an output that exists" 2 "a.ply: exists"
run simplify -f wave.obj -o a.ply; cp a.ply b.ply; run simplify -f wave.obj -o a.ply
check "twice the same" cmp -s a.ply b.ply
finish
