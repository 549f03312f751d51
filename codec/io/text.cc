#include "codec/io/text.h"

#include <algorithm>

namespace clers::io {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

}  // namespace

std::uint64_t Text::line_of(const char* where) const {
  return 1 + static_cast<std::uint64_t>(std::count(begin_, where, '\n'));
}

bool Text::skip_comment_or_continuation() {
  if (*at_ == '#') {
    if (!syntax_.comments) return false;
    while (at_ != end_ && *at_ != '\n') ++at_;
    return true;
  }
  if (!syntax_.continuations) return false;
  const char* next = at_ + 1;
  if (next != end_ && *next == '\r') ++next;
  if (next == end_ || *next != '\n') return false;
  at_ = next + 1;
  return true;
}

std::string_view Text::token() {
  skip_blanks();
  const char* from = at_;
  while (!ends_token(at_)) ++at_;
  return {from, static_cast<std::size_t>(at_ - from)};
}

std::size_t Text::tokens_on_line() const {
  std::size_t tokens = 0;
  for (Text text = *this; !text.at_line_end(); ++tokens)
    if (text.token().empty()) ++text.at_;
  return tokens;
}

std::string_view Text::rest_of_line() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
  const char* from = at_;
  while (at_ != end_ && *at_ != '\n') ++at_;
  const char* to = at_;
  while (to != from && is_blank(to[-1])) --to;
  return {from, static_cast<std::size_t>(to - from)};
}

// std::from_chars says only that the number is out of range, not on which side. The number is tiny
// when its first digit that counts stands behind the point once the exponent has moved it.
bool Text::rounds_to_zero(std::string_view number) {
  std::int64_t digits_before_point = 0;
  std::int64_t zeros_behind_point = 0;
  bool point = false, significant = false;
  std::size_t i = number.empty() || number[0] != '-' ? 0 : 1;
  for (; i < number.size() && number[i] != 'e' && number[i] != 'E'; ++i) {
    if (number[i] == '.') {
      point = true;
      continue;
    }
    significant = significant || number[i] != '0';
    if (!point && significant) ++digits_before_point;
    if (point && !significant) ++zeros_behind_point;
  }
  std::int64_t exponent = 0;
  if (i < number.size()) {
    const char* from = number.data() + i + 1;
    const char* end = number.data() + number.size();
    if (from != end && *from == '+') ++from;
    if (std::from_chars(from, end, exponent).ec == std::errc::result_out_of_range)
      return *from == '-';
  }
  return exponent < zeros_behind_point - digits_before_point;
}

Failure<Error> Text::expected(std::string_view what) {
  skip_blanks();
  const char* where = at_;
  const std::string found = at_ == end_    ? "the end of the file"
                            : *at_ == '\n' ? "the end of the line"
                                           : quoted(token());
  return malformed(where, "expected " + std::string(what) + ", found " + found);
}

std::string quoted(std::string_view piece) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : piece.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (piece.size() > longest ? "...'" : "'");
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

}  // namespace clers::io
