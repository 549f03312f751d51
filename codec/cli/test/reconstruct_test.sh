#!/bin/bash
# The command reconstruct: points become a mesh that check finds nothing wrong with, and what is left over is said.
# usage: reconstruct_test.sh PROGRAM
. "$(dirname "$0")/harness.sh" "$1"
touch err

# ball N [NOISE]: points on the unit sphere as OBJ.
ball() {
  awk -v n="$1" -v noise="${2:-0}" 'BEGIN {
    srand(7)
    for (i = 0; i < n; i++) {
      z = 1 - (2 * i + 1) / n; r = sqrt(1 - z * z); t = i * 2.399963229728653
      printf "v %.9g %.9g %.9g\n", r * cos(t) + noise * (rand() - 0.5), r * sin(t) + noise * (rand() - 0.5), z + noise * (rand() - 0.5)
    } }'
}
# cloud NORMAL: the points of standard input as PLY, with normals along them or (NORMAL -1) against them, and numbers.
cloud() {
  awk -v sign="$1" '{ line[n++] = $2 " " $3 " " $4 " " sign * $2 " " sign * $3 " " sign * $4 " " n }
    END {
      print "ply\nformat ascii 1.0\nelement vertex " n
      for (i = split("x y z nx ny nz", p, " "); i > 0; i--) names = "property float " p[i] "\n" names
      print names "property int number\nend_header"
      for (i = 0; i < n; i++) print line[i]
    }'
}
number() { sed -n "s/^ *\"$1\": \([-+.e0-9]*\),*$/\1/p" report | head -n 1; }
below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a <= b) }'; }
reconstruct() {
  run reconstruct -f --json "$@"
  cp out report
}
# noted NAME PATTERN: the last run ended well, with a note.
noted() { check "$1: status 0" test "$status" -eq 0; check "$1: noted" grep -q "^clers: .*: note: $2" err; }
# shape FILE: components, boundary curves, genus and defects.
shape() { "$clers" check --json "$1" >report; echo "$(number components) $(number boundary_curves) $(number genus) $(number nonmanifold_edges) $(number nonmanifold_vertices) $(number isolated_vertices)"; }
# volume FILE: of an OBJ.
volume() {
  awk '/^v / { x[++n] = $2; y[n] = $3; z[n] = $4 }
    /^f/ { a = $2 + 0; b = $3 + 0; c = $4 + 0
      s += x[a] * (y[b] * z[c] - z[b] * y[c]) + y[a] * (z[b] * x[c] - x[b] * z[c]) + z[a] * (x[b] * y[c] - y[b] * x[c]) }
    END { print s / 6 }' "$1"
}

ball 1000 >ball.obj
cloud 1 <ball.obj >outwards.ply
cloud -1 <ball.obj >inwards.ply

# ---- Without options
reconstruct ball.obj -o a.obj; ends "points of an OBJ" 0
check "all points of a sphere are used" test "$(number points) $(number vertices) $(number triangles) $(number unused_points)" = "1000 1000 1996 0"
check "the report says what check finds" test "$(number components) $(number boundary_curves) $(number boundary_edges) $(number genus)" = "1 0 0 0"
check "triangles are good: $(number radius_ratio)" below 0.8 "$(number radius_ratio)"
check "it is a closed manifold" test "$(shape a.obj)" = "1 0 0 0 0 0"
check "the outside is outside: $(volume a.obj)" below 4 "$(volume a.obj)"
run reconstruct -f ball.obj -o a.obj
check "a line of result" grep -q '^ball.obj: 1,000 points -> 1,996 triangles on 1,000; 1 component, closed, genus 0; 0 not' err
run reconstruct -q -f ball.obj -o b.obj; silent "-q"
check "the same again" cmp -s a.obj b.obj
"$clers" reconstruct --from obj - --to off -o - <ball.obj >out 2>err; status=$?; ends "reconstruct - -o -" 0
check "standard output has only the mesh" test "$(sed -n 2p out)" = "1000 1996 0"
grid 12 | awk '/^v/ { $4 = 0 } { print }' >grid.obj
reconstruct grid.obj -o a.obj; noted "faces do not count" "288 faces are left out: points alone count"
check "its rim stays open" test "$(shape a.obj)" = "1 1 0 0 0 0"
"$clers" reconstruct -f grid.obj -o a.obj 2>err
check "which is said" grep -q "open along 1 boundary curve of 48 edges" err
mkdir two; run reconstruct ball.obj grid.obj --to ply -o two
check "two outputs" test $status -eq 0 -a -s two/ball.ply -a -s two/grid.ply

# ---- Normals, and other values
for side in outwards inwards; do
  reconstruct $side.ply -o $side.obj
  check "normals are used" test "$status $(grep -c '"normals": true' report) $(number triangles)" = "0 1 1996"
done
check "normals say which side is outside" below "4 $(volume inwards.obj)" "$(volume outwards.obj) -4"
run reconstruct -f inwards.ply -o a.ply --text
sed '1,/end_header/d' a.ply | awk 'NF == 7 { print $7 }' >after
check "values of points come back, in their order" cmp -s after <(seq 1000)

# ---- Radii
reconstruct ball.obj -o a.ply --radius 0.12; ends "--radius" 0
check "a ball closes it" test "$(shape a.ply)" = "1 0 0 0 0 0"
reconstruct ball.obj -o b.ply --radius 0.072; noted "a small radius" "[0-9]* points are not on the surface"
check "a small one leaves gaps: $(number boundary_curves)" below 2 "$(number boundary_curves)"
reconstruct ball.obj -o b.ply --radius 0.072,0.12; ends "two radii" 0
check "the next one closes them" test "$(shape b.ply)" = "1 0 0 0 0 0"
reconstruct ball.obj -o c.ply --radius 0.12 --radius 0.072; check "in any order" cmp -s b.ply c.ply
reconstruct ball.obj -o b.ply --radius 4%; ends "a radius in %" 0
check "of the diagonal: $(sed -n '/radii/{n;p}' report)" eval 'sed -n "/radii/{n;p}" report | grep -q "0\.13[89]"'
reconstruct inwards.ply -o a.obj --radius 0.12
check "normals count for balls, too" below "$(volume a.obj)" -4

# ---- What scans are like
{ ball 2000 0.02; ball 300; } | awk 'NR % 10' >noisy.obj
reconstruct noisy.obj -o a.ply; ends "noise, and points missing" 0
used=$(number vertices) unused=$(number unused_points)
check "every point is told of: $used + $unused" test $((used + unused)) -eq 2070
check "a manifold: $(shape a.ply)" eval '[[ $(shape a.ply) == *" 0 0 0" ]]'
{ cat ball.obj ball.obj; echo 'v 1 2 3'; } >twice.obj
reconstruct twice.obj -o a.obj; noted "duplicates" "1,000 points are at places of others, and left out"
check "duplicates are told of" test "$(number duplicate_points) $(number triangles)" = "1000 1996"
check "a point far off is left" test "$(number unused_points)" = 1
{ cloud 1 <ball.obj | sed '15s/^[^ ]* /nan /; 16s/^[^ ]* /inf /; 17s/^[^ ]* /1e30 /; 18s/ [^ ]* / 1e120 /'; } | sed 's/float/double/' >nan.ply
reconstruct nan.ply -o a.ply; noted "what is no number" "3 points are at no place that is a number, and left out"
check "what is no number is told of: $(number points_without_place)" test "$(number points_without_place)" = 3
{ cat ball.obj; awk '{ $2 += 5 } { print }' ball.obj; } >two.obj
reconstruct two.obj -o a.ply; ends "two balls" 0
check "stay apart" test "$(shape a.ply)" = "2 0 0 0 0 0"

# ---- Refused
refused() { run reconstruct "$2" -o x.obj "${@:4}"; ends "$1" 3 "$2: $3"; }
printf 'v 0 0 0\nv 1 1 1\nv 2 2 2\nv 3 3 3\n' >line.obj
refused "a line" line.obj "all points are on a line: there is no surface through them"
refused "a line, and a ball" line.obj "no ball of a --radius rests on three points" --radius 2
refused "a ball that falls through" ball.obj "no ball of a --radius rests on three points" --radius 0.01
printf 'v 1 2 3\nv 1 2 3\nv 1 2 3\nv 1 2 3\n' >same.obj
refused "all at one place" same.obj "has points at 1 place, expected three or more"
refused "all at one place, and a ball" same.obj "has points at 1 place, expected three or more" --radius 1%
printf 'v 1 2 3\nv 1 2 4\n' >pair.obj
refused "two points" pair.obj "has points at 2 places, expected three or more"
printf '# nothing\n' >none.obj
refused "no points" none.obj "has points at no place, expected three or more"
run reconstruct ball.obj -o a.ply; ends "an output that exists" 2 "a.ply: exists"
printf '0 0 0\n1 0 0\n0 1 0\n' >a.xyz
run reconstruct a.xyz -o x.obj; ends "a format that is not read" 3 "a.xyz: .*cloud of points"
check "nothing refused leaves an output" test ! -e x.obj
finish
