/* clers_bound is enough for what compresses worst: faces at random, noise of every kind, pieces of
   one face. */
#include "bindings/c/test/check.h"

static uint32_t state;
static uint32_t noise(void) {
  return state = state * 1664525u + 1013904223u, state >> 7;
}

/* How much of what was said would have been needed, 0 to 1. */
static double share(uint32_t seed) {
  static const size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  clers_error error = {.size = sizeof error};
  clers_encode_options options = {.size = sizeof options};
  clers_attribute attributes[3];
  clers_mesh mesh = {.size = sizeof mesh};
  uint32_t corners[600], face_sizes[300], indices[600];
  unsigned char data[3][600 * 3 * 8];
  size_t i, k, size, bound, faces;
  void* bytes;
  state = seed;
  for (i = 0; i < 8; ++i) noise();
  options.level = (int32_t)(1 + noise() % 9);
  options.order = (int32_t)(noise() % 2);
  if (noise() % 2) options.piece_faces = 1 + noise() % 20;
  mesh.vertex_count = 1 + noise() % 400;
  mesh.corners = corners;
  mesh.corner_count = 3 * (noise() % 200);
  for (i = 0; i < mesh.corner_count; ++i) corners[i] = noise() % mesh.vertex_count;
  if (noise() % 2) { /* polygons, some of no corner at all */
    for (i = 0, faces = 0; i < mesh.corner_count && faces < 300; ++faces) {
      face_sizes[faces] = noise() % 7;
      if (face_sizes[faces] > mesh.corner_count - i || faces == 299)
        face_sizes[faces] = (uint32_t)(mesh.corner_count - i);
      i += face_sizes[faces];
    }
    mesh.face_sizes = face_sizes;
    mesh.face_count = faces;
  }
  faces = mesh.face_sizes ? mesh.face_count : mesh.corner_count / 3;
  memset(attributes, 0, sizeof attributes);
  mesh.attributes = attributes;
  mesh.attribute_count = noise() % 4;
  for (k = 0; k < mesh.attribute_count; ++k) {
    static const char* names[] = {"position", "normal", "anything"};
    clers_attribute* a = &attributes[k];
    const size_t counts[] = {mesh.vertex_count, mesh.corner_count, faces};
    size_t values;
    a->size = sizeof *a;
    a->name = names[k];
    a->domain = k == 0 ? CLERS_VERTEX : (int32_t)(noise() % 3);
    a->scalar = (int32_t)(noise() % 10);
    a->components = 1 + noise() % 3;
    a->data = data[k];
    values = counts[a->domain];
    if (k == 2 && values > 0 && noise() % 2) {
      a->indices = indices;
      for (i = 0; i < values; ++i) indices[i] = noise() % (uint32_t)values;
    }
    a->data_size = values * sizes[a->scalar] * a->components;
    for (i = 0; i < a->data_size; ++i) data[k][i] = (unsigned char)noise();
    if (a->scalar < CLERS_INT64 && noise() % 3 == 0) {
      a->precision = CLERS_BITS;
      a->bits = 30;
    }
  }
  bound = clers_bound(&mesh, 1, &options);
  CHECK(bound > 0);
  bytes = room(bound);
  CHECK_OK(clers_encode(&mesh, 1, &options, bytes, bound, &size, &error));
  free(bytes);
  return (double)size / (double)bound;
}

int main(void) {
  double most = 0;
  uint32_t seed;
  for (seed = 1; seed <= 300; ++seed) {
    const double used = share(seed);
    if (used > most) most = used;
  }
  printf("at most %.2f of the bound was needed\n", most);
  CHECK(most < .9); /* a change that comes near should be known */
  /* A good mesh does not ask for much more than its arrays. */
  {
    grid g;
    make_grid(&g, 100);
    CHECK(clers_bound(&g.mesh, 1, NULL) <
          2 * (g.position.data_size + g.mesh.corner_count * sizeof(uint32_t)));
    free_grid(&g);
  }
  return failures > 0;
}
