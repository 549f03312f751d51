/* For tests in C: what must hold, and a mesh to try it on. */
#ifndef CLERS_BINDINGS_C_TEST_CHECK_H
#define CLERS_BINDINGS_C_TEST_CHECK_H

#include <clers.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Each program has its own. */
static int failures;

#define CHECK(condition)                                             \
  do {                                                               \
    if (!(condition)) {                                              \
      ++failures;                                                    \
      printf("%s:%d: FAILED: %s\n", __FILE__, __LINE__, #condition); \
    }                                                                \
  } while (0)

/* A call that must succeed; says why it did not. Needs an `error`. */
#define CHECK_OK(call)                                                          \
  do {                                                                          \
    if ((call) != CLERS_OK) {                                                   \
      ++failures;                                                               \
      printf("%s:%d: FAILED: %s: %s\n", __FILE__, __LINE__, #call, error.text); \
      exit(1);                                                                  \
    }                                                                           \
  } while (0)

/* Exactly so many bytes, for tools that watch their ends. */
static void* room(size_t size) {
  void* memory = malloc(size > 0 ? size : 1);
  if (memory == NULL) exit(1);
  memset(memory, 0xa5, size);
  return memory;
}

/* A grid of side * side squares, two triangles each, not quite flat. */
typedef struct grid {
  uint32_t vertices, triangles;
  float* places;
  uint32_t* corners;
  clers_attribute position;
  clers_mesh mesh;
} grid;

/* Not moved or copied after: `mesh` points into it. */
static void make_grid(grid* g, uint32_t side) {
  uint32_t x, y;
  uint32_t* c;
  g->vertices = (side + 1) * (side + 1);
  g->triangles = 2 * side * side;
  g->places = room(g->vertices * 3 * sizeof(float));
  g->corners = c = room(g->triangles * 3 * sizeof(uint32_t));
  for (y = 0; y <= side; ++y)
    for (x = 0; x <= side; ++x) {
      float* p = g->places + 3 * (y * (side + 1) + x);
      p[0] = (float)x;
      p[1] = (float)y;
      p[2] = (float)((x * x + 3 * y * x) % 7) / 3;
    }
  for (y = 0; y < side; ++y)
    for (x = 0; x < side; ++x) {
      const uint32_t v = y * (side + 1) + x, up = v + side + 1;
      const uint32_t of_square[6] = {v, v + 1, up, up, v + 1, up + 1};
      memcpy(c, of_square, sizeof of_square);
      c += 6;
    }
  memset(&g->position, 0, sizeof g->position);
  g->position.size = sizeof g->position;
  g->position.name = "position";
  g->position.scalar = CLERS_FLOAT32;
  g->position.components = 3;
  g->position.data = g->places;
  g->position.data_size = g->vertices * 3 * sizeof(float);
  memset(&g->mesh, 0, sizeof g->mesh);
  g->mesh.size = sizeof g->mesh;
  g->mesh.vertex_count = g->vertices;
  g->mesh.corners = g->corners;
  g->mesh.corner_count = 3 * (size_t)g->triangles;
  g->mesh.attributes = &g->position;
  g->mesh.attribute_count = 1;
}

static void free_grid(grid* g) {
  free(g->places);
  free(g->corners);
}

/* A file of meshes, in memory of its size. */
static void* encoded(const clers_mesh* meshes, size_t count, const clers_encode_options* options,
                     size_t* size) {
  clers_error error = {.size = sizeof error};
  const size_t bound = clers_bound(meshes, count, options);
  void *bytes = room(bound), *exact;
  CHECK(bound > 0);
  CHECK_OK(clers_encode(meshes, count, options, bytes, bound, size, &error));
  CHECK(*size > 0 && *size <= bound);
  exact = room(*size);
  memcpy(exact, bytes, *size);
  free(bytes);
  return exact;
}

#endif
