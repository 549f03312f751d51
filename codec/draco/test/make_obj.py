#!/usr/bin/env python3
"""An OBJ with a seam in its texture, normals, two components, a boundary, and faces of two materials."""

import math

N = 14
for j in range(N + 1):
    for i in range(N):
        a = 2 * math.pi * i / N
        r = 1 + 0.3 * math.sin(3 * a) * math.cos(j)
        print(f"v {r * math.cos(a):.6f} {r * math.sin(a):.6f} {j * 0.37 - 2:.6f}")
for j in range(N + 1):
    for i in range(N + 1):
        print(f"vt {i / N:.6f} {j / N:.6f}")
for i in range(N):
    a = 2 * math.pi * i / N
    print(f"vn {math.cos(a):.6f} {math.sin(a):.6f} 0")
for j in range(N):
    if j == N // 2:
        continue  # two components
    print(f"usemtl {'ab'[j % 2]}")
    for i in range(N):
        def corner(x, y):
            return f"{y * N + x % N + 1}/{y * (N + 1) + x + 1}/{x % N + 1}"
        print("f", corner(i, j), corner(i + 1, j), corner(i + 1, j + 1))
        print("f", corner(i, j), corner(i + 1, j + 1), corner(i, j + 1))
