/* What goes in comes out: whole, in parts, and as it was asked for. */
#include "bindings/c/test/check.h"

static int same(const void* a, const void* b, size_t size) {
  return memcmp(a, b, size) == 0;
}

/* An interleaved buffer, 16-bit corners, and where everything went. */
static void test_free_order(int32_t level) {
  typedef struct vertex {
    float place[3];
    uint8_t color[4];
  } vertex;
  grid g;
  clers_error error = {.size = sizeof error};
  clers_encode_options options = {.size = sizeof options, .level = level};
  clers_mesh_info info = {.size = sizeof info};
  clers_attribute_info color = {.size = sizeof color};
  clers_decoder* decoder;
  clers_attribute in[2];
  clers_attribute_target out[2];
  clers_target target = {.size = sizeof target};
  size_t size, i, vertices, corners;
  void* bytes;
  make_grid(&g, 9);
  vertices = g.vertices;
  corners = g.mesh.corner_count;
  {
    vertex *given = room(vertices * sizeof *given), *got = room(vertices * sizeof *got);
    uint16_t *corners_in = room(corners * 2), *corners_out = room(corners * 2);
    uint32_t* old_vertices = room(vertices * 4);
    uint32_t *old_faces = room(g.triangles * 4), *first = room(g.triangles * 4);
    for (i = 0; i < vertices; ++i) {
      memcpy(given[i].place, g.places + 3 * i, sizeof given[i].place);
      memset(given[i].color, (int)(i % 5), sizeof given[i].color);
    }
    for (i = 0; i < corners; ++i) corners_in[i] = (uint16_t)g.corners[i];
    in[0] = in[1] = g.position;
    in[0].data = given;
    in[0].data_size = vertices * sizeof *given;
    in[0].stride = sizeof *given;
    in[1].name = "color";
    in[1].scalar = CLERS_UINT8;
    in[1].components = 4;
    in[1].data = given[0].color;
    in[1].data_size = (vertices - 1) * sizeof *given + 4; /* ends with the last value */
    in[1].stride = sizeof *given;
    g.mesh.corners = NULL;
    g.mesh.corners_16 = corners_in;
    g.mesh.attributes = in;
    g.mesh.attribute_count = 2;
    g.mesh.name = "gr\303\274n";
    g.mesh.old_vertices = old_vertices;
    g.mesh.old_faces = old_faces;
    g.mesh.first_corners = first;
    bytes = encoded(&g.mesh, 1, &options, &size);

    CHECK_OK(clers_open(bytes, size, NULL, &decoder, &error));
    CHECK_OK(clers_inspect_mesh(decoder, 0, &info, &error));
    CHECK(strcmp(info.name, "gr\303\274n") == 0);
    CHECK(info.vertex_count == vertices && info.corner_count == corners);
    CHECK(info.face_count == g.triangles && info.triangles_only == 1);
    CHECK(info.attribute_count == 2 && info.piece_count == 1);
    CHECK(info.connectivity_bytes > 0 && info.attribute_bytes > 0 &&
          info.connectivity_bytes + info.attribute_bytes < size);
    CHECK_OK(clers_inspect_attribute(decoder, 0, 1, &color, &error));
    CHECK(strcmp(color.name, "color") == 0 && color.domain == CLERS_VERTEX);
    CHECK(color.scalar == CLERS_UINT8 && color.components == 4 && color.value_size == 4);
    CHECK(color.count == vertices && color.bytes > 0 && color.error == 0);

    for (i = 0; i < 2; ++i) {
      memset(&out[i], 0, sizeof out[i]);
      out[i].size = sizeof out[i];
      out[i].name = in[i].name;
      out[i].scalar = in[i].scalar;
      out[i].components = in[i].components;
      out[i].data = i == 0 ? (void*)got : (void*)got[0].color;
      out[i].data_size = in[i].data_size;
      out[i].stride = sizeof *got;
    }
    target.corners_16 = corners_out;
    target.corner_count = corners;
    target.attributes = out;
    target.attribute_count = 2;
    CHECK_OK(clers_decode(decoder, 0, &target, &error));
    for (i = 0; i < vertices; ++i)
      CHECK(old_vertices[i] < vertices && same(&got[i], &given[old_vertices[i]], sizeof *got));
    for (i = 0; i < corners; ++i) {
      const size_t old = 3 * (size_t)old_faces[i / 3] + (first[i / 3] + i % 3) % 3;
      CHECK(old < corners && old_vertices[corners_out[i]] == corners_in[old]);
    }
    clers_close(decoder);
    free(bytes), free(given), free(got), free(corners_in), free(corners_out);
    free(old_vertices), free(old_faces), free(first);
  }
  free_grid(&g);
}

/* Polygons in the order of the input; values of corners by index, some missing. */
static void test_polygons(void) {
  const float places[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, .5f, .5f, 1};
  const uint32_t corners[] = {0, 3, 2, 1, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  const uint32_t sizes[] = {4, 3, 3, 3, 3};
  const int16_t flat[] = {10, 20, 30};
  const uint32_t which[] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 1, 1, 1, CLERS_NONE, CLERS_NONE, 2};
  const double weights[] = {1, 2.5, -3, 4e300, 5};
  clers_error error = {.size = sizeof error};
  clers_encode_options options = {.size = sizeof options, .order = CLERS_ORDER_KEEP};
  clers_attribute in[3];
  clers_mesh meshes[2] = {{.size = sizeof(clers_mesh)}, {.size = sizeof(clers_mesh)}};
  clers_file_info file = {.size = sizeof file};
  clers_decoder* decoder;
  clers_target target = {.size = sizeof target};
  clers_attribute_target out = {.size = sizeof out,
                                .name = "id",
                                .domain = CLERS_CORNER,
                                .scalar = CLERS_INT16,
                                .components = 1};
  uint32_t got_corners[16], got_sizes[5], opposites[16];
  int16_t ids[16];
  double got_weights[5];
  float got_places[15];
  size_t size, i;
  void* bytes;
  memset(in, 0, sizeof in);
  for (i = 0; i < 3; ++i) in[i].size = sizeof in[i], in[i].components = 1;
  in[0].name = "position";
  in[0].scalar = CLERS_FLOAT32;
  in[0].components = 3;
  in[0].data = places;
  in[0].data_size = sizeof places;
  in[1].name = "id";
  in[1].domain = CLERS_CORNER;
  in[1].scalar = CLERS_INT16;
  in[1].data = flat;
  in[1].data_size = sizeof flat;
  in[1].indices = which;
  in[2].name = "weight";
  in[2].domain = CLERS_FACE;
  in[2].scalar = CLERS_FLOAT64;
  in[2].data = weights;
  in[2].data_size = sizeof weights;
  meshes[1].vertex_count = 5;
  meshes[1].corners = corners;
  meshes[1].corner_count = 16;
  meshes[1].face_sizes = sizes;
  meshes[1].face_count = 5;
  meshes[1].attributes = in;
  meshes[1].attribute_count = 3;
  bytes = encoded(meshes, 2, &options, &size); /* the first is empty */

  CHECK_OK(clers_open(bytes, size, NULL, &decoder, &error));
  CHECK_OK(clers_inspect(decoder, &file, &error));
  CHECK(file.mesh_count == 2 && file.piece_count == 2 && file.bytes == size && file.level == 5);
  target.corners = got_corners;
  target.opposites = opposites;
  target.corner_count = 16;
  target.face_sizes = got_sizes;
  target.face_count = 5;
  out.data = ids;
  out.data_size = sizeof ids;
  target.attributes = &out;
  target.attribute_count = 1;
  memset(ids, 0x77, sizeof ids);
  CHECK_OK(clers_decode(decoder, 1, &target, &error));
  CHECK(same(got_corners, corners, sizeof corners) && same(got_sizes, sizes, sizeof sizes));
  for (i = 0; i < 16; ++i) CHECK(ids[i] == (which[i] == CLERS_NONE ? 0x7777 : flat[which[i]]));
  for (i = 0; i < 16; ++i) CHECK(opposites[i] < 16 && opposites[opposites[i]] == i);
  CHECK_OK(clers_decode_attribute(decoder, 1, 0, got_places, sizeof got_places, &error));
  CHECK(same(got_places, places, sizeof places));
  CHECK_OK(clers_decode_attribute(decoder, 1, 2, got_weights, sizeof got_weights, &error));
  CHECK(same(got_weights, weights, sizeof weights));
  memset(got_corners, 0, sizeof got_corners);
  memset(ids, 0x77, sizeof ids);
  target.opposites = NULL;
  CHECK_OK(clers_decode_piece(decoder, 1, &target, NULL, &error));
  CHECK(same(got_corners, corners, sizeof corners) && same(got_sizes, sizes, sizeof sizes));
  for (i = 0; i < 16; ++i) CHECK(ids[i] == (which[i] == CLERS_NONE ? 0x7777 : flat[which[i]]));
  clers_close(decoder);
  free(bytes);
}

/* As far off as is said, and no farther. */
static void test_precisions(void) {
  const double origin[] = {.5, 0, 0};
  const struct {
    int32_t precision, bits;
    double amount;
    const double* origin;
    size_t origin_count;
    double most;
  } asked[] = {{CLERS_BITS, 8, 0, NULL, 0, 9. / 255},
               {CLERS_STEP, 0, .125, NULL, 0, .0625},
               {CLERS_ERROR, 0, .01, NULL, 0, .01},
               {CLERS_GRID, 0, .25, origin, 3, .125}};
  clers_error error = {.size = sizeof error};
  clers_encode_options options = {.size = sizeof options, .order = CLERS_ORDER_KEEP};
  clers_attribute_info info = {.size = sizeof info};
  clers_decoder* decoder;
  size_t size, i, k;
  grid g;
  float* got;
  make_grid(&g, 9);
  got = room(g.position.data_size);
  for (k = 0; k < sizeof asked / sizeof *asked; ++k) {
    void* bytes;
    double largest = 0;
    g.position.precision = asked[k].precision;
    g.position.bits = asked[k].bits;
    g.position.amount = asked[k].amount;
    g.position.origin = asked[k].origin;
    g.position.origin_count = asked[k].origin_count;
    bytes = encoded(&g.mesh, 1, &options, &size);
    CHECK_OK(clers_open(bytes, size, NULL, &decoder, &error));
    CHECK_OK(clers_inspect_attribute(decoder, 0, 0, &info, &error));
    CHECK_OK(clers_decode_attribute(decoder, 0, 0, got, g.position.data_size, &error));
    for (i = 0; i < 3 * (size_t)g.vertices; ++i) {
      const double off = (double)got[i] - (double)g.places[i];
      if (off > largest || -off > largest) largest = off > 0 ? off : -off;
    }
    CHECK(largest > 0 && largest == info.error && info.error <= asked[k].most * 1.0001);
    CHECK(info.measure == CLERS_DIFFERENCE);
    clers_close(decoder);
    free(bytes);
  }
  free(got);
  free_grid(&g);
}

/* Pieces are where the whole mesh has them. */
static void test_pieces(void) {
  clers_error error = {.size = sizeof error};
  clers_encode_options options = {.size = sizeof options, .piece_faces = 40};
  clers_decode_options both = {.size = sizeof both, .threads = 2};
  clers_file_info file = {.size = sizeof file};
  clers_mesh_info info = {.size = sizeof info};
  clers_decoder* decoder;
  clers_target target = {.size = sizeof target};
  clers_attribute_target place = {
      .size = sizeof place, .name = "position", .scalar = CLERS_FLOAT32, .components = 3};
  size_t size, size_by_two, i, k, seen = 0, shared = 0;
  void *bytes, *by_two;
  float* places;
  uint32_t* corners;
  grid g;
  make_grid(&g, 12);
  places = room(g.position.data_size);
  corners = room(g.mesh.corner_count * 4);
  bytes = encoded(&g.mesh, 1, &options, &size);
  options.threads = CLERS_EVERY_CORE;
  by_two = encoded(&g.mesh, 1, &options, &size_by_two);
  CHECK(size == size_by_two && same(bytes, by_two, size));
  free(by_two);
  CHECK_OK(clers_open(bytes, size, &both, &decoder, &error));
  CHECK_OK(clers_inspect(decoder, &file, &error));
  CHECK_OK(clers_inspect_mesh(decoder, 0, &info, &error));
  CHECK(file.piece_count > 5 && info.piece_count == file.piece_count && info.first_piece == 0);
  target.corners = corners;
  target.corner_count = g.mesh.corner_count;
  place.data = places;
  place.data_size = g.position.data_size;
  target.attributes = &place;
  target.attribute_count = 1;
  CHECK_OK(clers_decode(decoder, 0, &target, &error));
  for (k = 0; k < file.piece_count; ++k) {
    clers_piece_info piece = {.size = sizeof piece};
    uint32_t *own_corners, *numbers;
    float* own_places;
    CHECK_OK(clers_inspect_piece(decoder, k, &piece, &error));
    CHECK(piece.mesh == 0 && piece.index == k && piece.triangles_only);
    CHECK(piece.first_face == seen && piece.face_count <= 60);
    own_corners = room((size_t)piece.corner_count * 4);
    numbers = room((size_t)piece.vertex_count * 4);
    own_places = room((size_t)piece.vertex_count * 12);
    target.corners = own_corners;
    target.corner_count = (size_t)piece.corner_count;
    place.data = own_places;
    place.data_size = (size_t)piece.vertex_count * 12;
    CHECK_OK(clers_decode_piece(decoder, k, &target, numbers, &error));
    for (i = 0; i < piece.corner_count; ++i)
      CHECK(own_corners[i] < piece.vertex_count &&
            numbers[own_corners[i]] == corners[3 * piece.first_face + i]);
    for (i = 0; i < piece.vertex_count; ++i) {
      shared += numbers[i] < piece.first_vertex;
      CHECK(numbers[i] < g.vertices && same(own_places + 3 * i, places + 3 * numbers[i], 12));
    }
    seen += (size_t)piece.face_count;
    free(own_corners), free(numbers), free(own_places);
  }
  CHECK(seen == g.triangles && shared > 0);
  clers_close(decoder);
  free(bytes), free(places), free(corners);
  free_grid(&g);
}

int main(void) {
  test_free_order(1);
  test_free_order(0);
  test_free_order(9);
  test_polygons();
  test_precisions();
  test_pieces();
  return failures > 0;
}
