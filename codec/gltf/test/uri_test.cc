#include "codec/gltf/uri.h"

#include <gtest/gtest.h>

#include <cstring>

namespace clers::gltf {
namespace {

std::vector<std::byte> bytes_of(std::string_view text) {
  std::vector<std::byte> bytes(text.size());
  if (!text.empty()) std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

// RFC 4648, 10.
TEST(Uri, Base64) {
  const std::pair<const char*, const char*> cases[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : cases) {
    EXPECT_EQ(base64(bytes_of(plain)), coded);
    EXPECT_EQ(data_bytes(std::string("data:;base64,") + coded), bytes_of(plain));
  }
  EXPECT_EQ(data_head("data:image/png;base64,AA=="), "data:image/png;base64,");
  for (const char* uri :
       {"data:,x", "data:;base64", "a.png", "data:;base64,!!!!", "data:;base64,A"})
    EXPECT_FALSE(data_bytes(uri)) << uri;
}

TEST(Uri, Paths) {
  EXPECT_EQ(relative_path("a%20b/c.bin"), "a b/c.bin");
  EXPECT_EQ(relative_path("%C3%A9.png"), "\xc3\xa9.png");
  EXPECT_EQ(relative_path("100%.png"), "100%.png");
  for (const char* uri :
       {"", "http://x/y", "file:a", "/etc/passwd", "%2Fetc", "a?b", "a#b", "%ff", "a%00b"})
    EXPECT_FALSE(relative_path(uri)) << uri;
}

TEST(Uri, LeadsDown) {
  for (const char* path : {"a", "a/b.png", "...", "a b"}) EXPECT_TRUE(leads_down(path)) << path;
  for (const char* path : {"", "..", "../a", "a/../b", "./a", "a//b", "a/", "a\\b", "c:a"})
    EXPECT_FALSE(leads_down(path)) << path;
}

}  // namespace
}  // namespace clers::gltf
