#include "codec/gltf/json.h"

#include <gtest/gtest.h>

#include "codec/gltf/bounds.h"
#include "codec/gltf/places.h"

namespace clers::gltf {
namespace {

std::string again(std::string_view text) {
  const auto json = parse(text);
  return json ? print(*json) : describe(json.error());
}

TEST(Json, KeepsTokens) {
  for (const char* text :
       {"{}", "[]", "null", "[true,false,null]", R"({"b":1,"a":2,"b":3})",
        "[1.0,1.00,1e5,1E+5,-0,-0.0,0.1e-300,123456789012345678901234567890,1.5e300]",
        R"({"":"","\u0001":"\"\\"})", "\"\xc3\xa9\xf0\x9f\x98\x80\"", R"(["2.50",2.50])"})
    EXPECT_EQ(again(text), text);
  EXPECT_EQ(again(" { \"a\" : [ 1 , 2 ] }\n"), R"({"a":[1,2]})");
  EXPECT_EQ(again(R"("\u00e9\/")"), "\"\xc3\xa9/\"");
}

TEST(Json, RefusesWhatIsNone) {
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[1,]"), std::string("{}{}"),
        std::string("01"), std::string("[\"\xff\"]"), std::string("nan"), std::string("{}\0", 3),
        std::string("[\"a\nb\"]"), std::string(R"(["\ud800"])"), std::string("{\"a\" 1}")}) {
    const auto json = parse(text);
    ASSERT_FALSE(json) << text;
    EXPECT_EQ(json.error().code, ErrorCode::malformed);
  }
}

TEST(Json, HasABottom) {
  EXPECT_TRUE(parse(std::string(most_depth, '[') + std::string(most_depth, ']')));
  EXPECT_FALSE(parse(std::string(most_depth + 1, '[') + std::string(most_depth + 1, ']')));
  EXPECT_FALSE(parse(std::string(1 << 20, '[')));
}

TEST(Json, FindsTheLastOfEqualKeys) {
  const auto json = parse(R"({"a":1,"a":2})");
  ASSERT_TRUE(json);
  EXPECT_EQ(json->find("a")->text, "2");
  EXPECT_EQ(json->find("b"), nullptr);
}

TEST(Json, Integers) {
  EXPECT_EQ(integer(Json::number("5")), 5u);
  EXPECT_EQ(integer(Json::number("5.0")), 5u);
  EXPECT_EQ(integer(Json::number("5e2")), 500u);
  for (const char* text : {"-1", "1.5", "1e300", "18446744073709551616"})
    EXPECT_FALSE(integer(Json::number(text))) << text;
  EXPECT_FALSE(integer(Json::string("5")));
}

// What JavaScript and Python print, found with them.
TEST(Numbers, InTheStylesOfOthers) {
  const struct {
    double value;
    const char *script, *python;
  } cases[] = {{0, "0", "0.0"},
               {1, "1", "1.0"},
               {-2.5, "-2.5", "-2.5"},
               {0.1, "0.1", "0.1"},
               {1e-5, "0.00001", "1e-05"},
               {1.25e-7, "1.25e-7", "1.25e-07"},
               {0.000123, "0.000123", "0.000123"},
               {1e16, "10000000000000000", "1e+16"},
               {1e21, "1e+21", "1e+21"},
               {123456789, "123456789", "123456789.0"},
               {0.10000000149011612, "0.10000000149011612", "0.10000000149011612"}};
  for (const auto& c : cases) {
    EXPECT_EQ(text_of(c.value, Style::script), c.script);
    EXPECT_EQ(text_of(c.value, Style::python), c.python);
  }
  EXPECT_EQ(text_of(0.10000000149011612, Style::script_float), "0.1");
  EXPECT_EQ(text_of(3, Style::python_float), "3.0");
  EXPECT_EQ(text_of(1, Style::rapidjson), "1.0");
  EXPECT_EQ(text_of(-0.0, Style::python), "-0.0");
}

TEST(Json, HalfAPairIsAnEscapeAgain) {
  for (const std::string text : {R"({"a":"\ude00"})", R"({"\udc00x":["\udfff\udfff"]})"}) {
    const auto json = parse(text);
    ASSERT_TRUE(json) << describe(json.error());
    EXPECT_EQ(print(*json), text);
  }
  EXPECT_EQ(print(*parse(R"("\ud83d\ude00 \ud7ff")")), "\"\xf0\x9f\x98\x80 \xed\x9f\xbf\"");
}

TEST(Places, FollowEachOther) {
  const char text[] =
      R"({"buffers":[{"byteLength":76}],)"
      R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":6},)"
      R"({"buffer":0,"byteOffset":8,"byteLength":48,"byteStride":16},)"
      R"({"buffer":0,"byteLength":20,"byteOffset":56}],)"
      R"("accessors":[{"bufferView":0,"byteOffset":0,"componentType":5123,"count":3,"type":"SCALAR"},)"
      R"({"bufferView":1,"byteOffset":0,"componentType":5126,"count":3,"type":"VEC3"},)"
      R"({"bufferView":1,"byteOffset":12,"componentType":5121,"count":3,"type":"VEC4"}]})";
  auto json = parse(text);
  ASSERT_TRUE(json);
  shorten_places(*json);
  const std::string shortened = print(*json);
  EXPECT_EQ(shortened.find("\"byteOffset\":1"), shortened.npos);
  EXPECT_NE(shortened.find("\"byteLength\":20"), shortened.npos);  // nothing says how long
  EXPECT_NE(shortened.find("\"byteLength\":null,\"byteStride\""), shortened.npos);
  restore_places(*json);
  EXPECT_EQ(print(*json), text);
}

}  // namespace
}  // namespace clers::gltf
