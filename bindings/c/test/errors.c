/* What is wrong is said, and nothing that is handed in brings a program down. */
#include "bindings/c/test/check.h"

static clers_error error = {.size = sizeof error};

/* Fails with this code, and its text has these words. */
#define CHECK_FAILS(call, expected, words)                                                        \
  do {                                                                                            \
    const clers_code code = (call);                                                               \
    if (code != (expected) || error.code != code || !strstr(error.text, words)) {                 \
      ++failures;                                                                                 \
      printf("%s:%d: FAILED: %s: %s, \"%s\"\n", __FILE__, __LINE__, #call, clers_code_name(code), \
             error.text);                                                                         \
    }                                                                                             \
  } while (0)

static clers_code encode(const clers_mesh* mesh, const clers_encode_options* options) {
  static char bytes[1 << 16];
  size_t size;
  return clers_encode(mesh, 1, options, bytes, sizeof bytes, &size, &error);
}

static void test_encoding(void) {
  clers_encode_options options = {.size = sizeof options};
  clers_attribute two[2];
  clers_mesh mesh;
  size_t size = 77, at;
  uint32_t corner;
  char none[1];
  void* bytes;
  grid g;
  make_grid(&g, 4);

  CHECK_FAILS(encode(NULL, NULL), CLERS_BAD_OPTION, "clers_mesh is NULL");
  mesh = g.mesh;
  mesh.size = 0;
  CHECK_FAILS(encode(&mesh, NULL), CLERS_BAD_OPTION, "size of 0");
  CHECK(clers_bound(&mesh, 1, NULL) == 0);
  options.level = 10;
  CHECK_FAILS(encode(&g.mesh, &options), CLERS_BAD_OPTION, "level 10");
  options.level = 0;
  options.order = 2;
  CHECK_FAILS(encode(&g.mesh, &options), CLERS_BAD_OPTION, "no order 2");
  options.order = 0;
  options.on_duplicate = -1;
  CHECK_FAILS(encode(&g.mesh, &options), CLERS_BAD_OPTION, "no policy for defects -1");
  options.on_duplicate = 0;
  g.position.scalar = 10;
  CHECK_FAILS(encode(&g.mesh, NULL), CLERS_BAD_OPTION, "no scalar 10");
  g.position.scalar = CLERS_FLOAT32;
  g.position.components = 256;
  CHECK_FAILS(encode(&g.mesh, NULL), CLERS_BAD_OPTION, "256 components");
  g.position.components = 3;
  g.position.data_size -= 1;
  CHECK_FAILS(encode(&g.mesh, NULL), CLERS_INCONSISTENT_MESH, "\"position\" has 299 bytes");
  g.position.data_size += 1;
  g.position.precision = 7;
  CHECK_FAILS(encode(&g.mesh, NULL), CLERS_BAD_OPTION, "no precision 7");
  g.position.precision = CLERS_BITS;
  g.position.bits = 31;
  CHECK_FAILS(encode(&g.mesh, NULL), CLERS_BAD_OPTION, "bits");
  g.position.precision = CLERS_LOSSLESS;
  two[0] = two[1] = g.position;
  two[1].precision = CLERS_STEP;
  two[1].amount = 1;
  mesh = g.mesh;
  mesh.attributes = two;
  mesh.attribute_count = 2;
  CHECK_FAILS(encode(&mesh, NULL), CLERS_BAD_OPTION, "two precisions");
  two[1].size = 0;
  CHECK_FAILS(encode(&mesh, NULL), CLERS_BAD_OPTION, "clers_attribute has a size of 0");
  mesh = g.mesh;
  mesh.corners_16 = (const uint16_t*)g.corners;
  CHECK_FAILS(encode(&mesh, NULL), CLERS_BAD_OPTION, "of 16 and of 32 bits");
  mesh = g.mesh;
  mesh.face_count = 5;
  CHECK_FAILS(encode(&mesh, NULL), CLERS_BAD_OPTION, "no sizes of faces");

  /* The element that is wrong is named. */
  corner = g.corners[17];
  g.corners[17] = 25;
  CHECK_FAILS(encode(&g.mesh, NULL), CLERS_INCONSISTENT_MESH,
              "face 5: has vertex 25, expected one below 25");
  CHECK(error.place == CLERS_AT_FACE && error.at == 5);
  g.corners[17] = g.corners[16];
  options.on_degenerate = CLERS_REJECT;
  CHECK_FAILS(encode(&g.mesh, &options), CLERS_DEGENERATE_FACE, "face 5");
  g.corners[17] = corner;
  g.places[3 * 7] = (float)(1e300 * 1e300);
  g.position.precision = CLERS_ERROR;
  g.position.amount = .1;
  CHECK_FAILS(encode(&g.mesh, NULL), CLERS_NOT_ON_GRID, "vertex 7");
  CHECK(error.place == CLERS_AT_VERTEX && error.at == 7);
  g.position.precision = CLERS_LOSSLESS;

  /* Too little memory: how much would do, and that it does. */
  CHECK_FAILS(clers_encode(&g.mesh, 1, NULL, none, 0, &size, &error), CLERS_BUFFER_TOO_SMALL,
              "there is memory for 0");
  CHECK(size == 77 && error.needed > 0);
  at = (size_t)error.needed;
  bytes = room(at);
  CHECK_FAILS(clers_encode(&g.mesh, 1, NULL, bytes, at - 1, &size, &error), CLERS_BUFFER_TOO_SMALL,
              "");
  CHECK_OK(clers_encode(&g.mesh, 1, NULL, bytes, at, &size, &error));
  CHECK(size == at && error.code == CLERS_OK && error.text[0] == 0);
  CHECK_FAILS(clers_encode(&g.mesh, 1, NULL, bytes, at, NULL, &error), CLERS_BAD_OPTION, "");
  CHECK_FAILS(clers_encode(&g.mesh, 1, NULL, NULL, at, &size, &error), CLERS_BAD_OPTION, "");
  CHECK(clers_encode(NULL, 1, NULL, bytes, at, &size, NULL) == CLERS_BAD_OPTION);
  free(bytes);
  free_grid(&g);
}

/* Structs of a later version: taken if what is new is 0, refused if it is not; filled with 0. */
static void test_growth(void) {
  struct {
    clers_encode_options known;
    uint64_t later[3];
  } options;
  struct {
    clers_attribute known;
    uint64_t later[1];
  } attributes[2];
  struct {
    clers_file_info known;
    uint64_t later[2];
  } info;
  clers_decoder* decoder;
  clers_mesh mesh;
  size_t size;
  void* bytes;
  grid g;
  make_grid(&g, 4);
  memset(&options, 0, sizeof options);
  options.known.size = sizeof options;
  memset(attributes, 0, sizeof attributes);
  attributes[0].known = attributes[1].known = g.position;
  attributes[0].known.size = attributes[1].known.size = sizeof attributes[0];
  attributes[1].known.name = "normal";
  mesh = g.mesh;
  mesh.attributes = &attributes[0].known;
  mesh.attribute_count = 2;
  CHECK_OK(encode(&mesh, &options.known));
  attributes[1].later[0] = 1;
  CHECK_FAILS(encode(&mesh, &options.known), CLERS_BAD_OPTION, "does not know");
  attributes[1].later[0] = 0;
  options.later[2] = 1;
  CHECK_FAILS(encode(&mesh, &options.known), CLERS_BAD_OPTION, "does not know");
  attributes[1].known.size = sizeof(clers_attribute);
  CHECK_FAILS(encode(&mesh, NULL), CLERS_BAD_OPTION, "different sizes");

  bytes = encoded(&g.mesh, 1, NULL, &size);
  CHECK_OK(clers_open(bytes, size, NULL, &decoder, &error));
  memset(&info, 0xa5, sizeof info);
  info.known.size = sizeof info;
  CHECK_OK(clers_inspect(decoder, &info.known, &error));
  CHECK(info.known.size == sizeof info && info.known.mesh_count == 1);
  CHECK(info.later[0] == 0 && info.later[1] == 0);
  info.known.size = 8;
  CHECK_FAILS(clers_inspect(decoder, &info.known, &error), CLERS_BAD_OPTION, "size of 8");
  clers_close(decoder);
  free(bytes);
  free_grid(&g);
}

static void test_decoding(void) {
  clers_decode_options limits = {.size = sizeof limits};
  clers_mesh_info info = {.size = sizeof info};
  clers_attribute_info attribute = {.size = sizeof attribute};
  clers_piece_info piece = {.size = sizeof piece};
  clers_target target = {.size = sizeof target};
  clers_attribute_target into = {
      .size = sizeof into, .name = "position", .scalar = CLERS_FLOAT32, .components = 3};
  clers_decoder* decoder;
  clers_attribute twice[2];
  uint32_t corners[96];
  float places[75];
  size_t size;
  void* bytes;
  grid g;
  make_grid(&g, 4);
  twice[0] = twice[1] = g.position;
  g.mesh.attributes = twice;
  g.mesh.attribute_count = 2;
  bytes = encoded(&g.mesh, 1, NULL, &size);

  CHECK_FAILS(clers_open(NULL, 1, NULL, &decoder, &error), CLERS_BAD_OPTION, "no bytes");
  CHECK(decoder == NULL);
  CHECK_FAILS(clers_open(NULL, 0, NULL, &decoder, &error), CLERS_TRUNCATED, "");
  CHECK_FAILS(clers_open(bytes, size, NULL, NULL, &error), CLERS_BAD_OPTION, "no room");
  CHECK_FAILS(clers_open("ply\nformat ascii 1.0\n 0000000000", 32, NULL, &decoder, &error),
              CLERS_NOT_CLERS, "");
  CHECK_OK(clers_open(bytes, size, &limits, &decoder, &error));
  clers_close(decoder);
  limits.max_vertices = 24;
  CHECK_FAILS(clers_open(bytes, size, &limits, &decoder, &error), CLERS_LIMIT, "25");
  CHECK(error.limited == CLERS_LIMITED_BY_VERTICES && error.needed == 25);
  limits.max_vertices = 25;
  limits.max_memory = 100;
  CHECK_FAILS(clers_open(bytes, size, &limits, &decoder, &error), CLERS_LIMIT, "memory");
  CHECK(error.limited == CLERS_LIMITED_BY_MEMORY && error.needed > 100);
  limits.size = 1;
  CHECK_FAILS(clers_open(bytes, size, &limits, &decoder, &error), CLERS_BAD_OPTION, "size of 1");

  CHECK_OK(clers_open(bytes, size, NULL, &decoder, &error));
  CHECK_FAILS(clers_inspect(NULL, NULL, &error), CLERS_BAD_OPTION, "no decoder");
  CHECK_FAILS(clers_inspect(decoder, NULL, &error), CLERS_BAD_OPTION, "is NULL");
  CHECK_FAILS(clers_inspect_mesh(decoder, 1, &info, &error), CLERS_BAD_OPTION,
              "mesh 1, there are 1");
  CHECK_FAILS(clers_inspect_attribute(decoder, 0, 2, &attribute, &error), CLERS_BAD_OPTION,
              "attribute 2, there are 2");
  CHECK_FAILS(clers_inspect_piece(decoder, 1, &piece, &error), CLERS_BAD_OPTION,
              "piece 1, there are 1");
  CHECK_FAILS(clers_decode(decoder, 0, NULL, &error), CLERS_BAD_OPTION, "clers_target is NULL");
  target.corners = corners;
  target.corner_count = 95;
  CHECK_FAILS(clers_decode(decoder, 0, &target, &error), CLERS_BAD_OPTION, "expected 96");
  CHECK_FAILS(clers_decode_piece(decoder, 0, &target, NULL, &error), CLERS_BAD_OPTION,
              "expected 96");
  target.corner_count = 96;
  CHECK_FAILS(clers_decode_piece(decoder, 1, &target, NULL, &error), CLERS_BAD_OPTION, "piece 1");
  target.attributes = &into;
  target.attribute_count = 1;
  into.data = places;
  into.data_size = sizeof places - 1;
  CHECK_FAILS(clers_decode(decoder, 0, &target, &error), CLERS_BAD_OPTION, "expected 25 times 12");
  CHECK_FAILS(clers_decode_piece(decoder, 0, &target, NULL, &error), CLERS_BAD_OPTION,
              "expected 25 times 12");
  into.data_size = sizeof places;
  into.stride = 11;
  CHECK_FAILS(clers_decode(decoder, 0, &target, &error), CLERS_BAD_OPTION, "12");
  CHECK_FAILS(clers_decode_piece(decoder, 0, &target, NULL, &error), CLERS_BAD_OPTION, "12");
  into.stride = 0;
  into.components = 2;
  CHECK_FAILS(clers_decode(decoder, 0, &target, &error), CLERS_BAD_OPTION, "3 float32");
  CHECK_FAILS(clers_decode_piece(decoder, 0, &target, NULL, &error), CLERS_BAD_OPTION, "3 float32");
  into.components = 3;
  into.name = "normal";
  CHECK_FAILS(clers_decode(decoder, 0, &target, &error), CLERS_BAD_OPTION, "\"normal\"");
  CHECK_FAILS(clers_decode_piece(decoder, 0, &target, NULL, &error), CLERS_BAD_OPTION,
              "\"normal\"");
  into.name = "position";
  into.domain = 3;
  CHECK_FAILS(clers_decode(decoder, 0, &target, &error), CLERS_BAD_OPTION, "no domain 3");
  CHECK_OK(clers_decode_attribute(decoder, 0, 0, places, sizeof places, &error));
  CHECK_FAILS(clers_decode_attribute(decoder, 0, 1, places, sizeof places, &error),
              CLERS_UNSUPPORTED, "name and domain of attribute 0");
  CHECK_FAILS(clers_decode_attribute(decoder, 0, 0, places, 12, &error), CLERS_BAD_OPTION,
              "expected 25 times 12");
  clers_close(decoder);
  clers_close(NULL);
  free(bytes);
  free_grid(&g);
}

/* Decodes all that a file says it has, whatever it is. */
static clers_code decode_all(const void* bytes, size_t size) {
  clers_decode_options limits = {.size = sizeof limits, .max_memory = 1 << 24};
  clers_file_info file = {.size = sizeof file};
  clers_decoder* decoder;
  size_t m, k;
  const clers_code opened = clers_open(bytes, size, &limits, &decoder, &error);
  if (opened != CLERS_OK) return opened;
  CHECK_OK(clers_inspect(decoder, &file, &error));
  for (m = 0; m < file.mesh_count; ++m) {
    clers_mesh_info info = {.size = sizeof info};
    clers_target target = {.size = sizeof target};
    CHECK_OK(clers_inspect_mesh(decoder, m, &info, &error));
    target.corner_count = (size_t)info.corner_count;
    target.corners = room(target.corner_count * 4);
    target.face_count = (size_t)info.face_count;
    target.face_sizes = room(target.face_count * 4);
    if (clers_decode(decoder, m, &target, &error) == CLERS_OK)
      for (k = 0; k < info.corner_count; ++k) CHECK(target.corners[k] < info.vertex_count);
    free(target.corners), free(target.face_sizes);
    for (k = 0; k < info.attribute_count; ++k) {
      clers_attribute_info a = {.size = sizeof a};
      void* data;
      CHECK_OK(clers_inspect_attribute(decoder, m, k, &a, &error));
      data = room((size_t)(a.count * a.value_size));
      clers_decode_attribute(decoder, m, k, data, (size_t)(a.count * a.value_size), &error);
      free(data);
    }
  }
  clers_close(decoder);
  return CLERS_OK;
}

/* Every prefix, every byte changed. Checksums find nearly all; fuzz/decode_any goes behind them. */
static void test_hostile_bytes(void) {
  size_t size, at;
  unsigned char *bytes, *copy;
  grid g;
  make_grid(&g, 4);
  bytes = encoded(&g.mesh, 1, NULL, &size);
  CHECK(decode_all(bytes, size) == CLERS_OK);
  for (at = 0; at < size; ++at) {
    copy = room(at);
    memcpy(copy, bytes, at);
    CHECK(decode_all(copy, at) != CLERS_OK);
    free(copy);
    bytes[at] ^= 0x41;
    CHECK(decode_all(bytes, size) != CLERS_OK);
    CHECK(error.code >= CLERS_NOT_CLERS && error.code <= CLERS_LIMIT && error.text[0] != 0);
    bytes[at] ^= 0x41;
  }
  free(bytes);
  free_grid(&g);
}

int main(void) {
  CHECK(strcmp(clers_code_name(CLERS_OK), "ok") == 0);
  CHECK(strcmp(clers_code_name(CLERS_BUFFER_TOO_SMALL), "buffer_too_small") == 0);
  CHECK(strcmp(clers_code_name(CLERS_CORRUPT), "corrupt") == 0);
  CHECK(strcmp(clers_code_name(-1), "unknown") == 0);
  test_encoding();
  test_growth();
  test_decoding();
  test_hostile_bytes();
  return failures > 0;
}
