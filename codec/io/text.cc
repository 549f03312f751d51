// Tokens of text.
#include "codec/io/text.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace clers::io {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

}  // namespace

std::uint64_t Text::line_of(const char* where) const {
  std::uint64_t line = 1;
  for (const char* p = begin_; p != where; ++p)
    line += *p == '\n' || (*p == '\r' && (p + 1 == end_ || p[1] != '\n'));
  return line;
}

void Comments::add(std::string_view comment) {
  if (seen_ && comment.data() <= seen_) return;
  seen_ = comment.data();
  if (count_++ > 0) lines_ += '\n';
  lines_ += comment;
}

// A comment, a line that goes on, or a byte order mark: files that were joined have some within.
bool Text::skip_odd_blank() {
  if (*at_ == '#') {
    if (!syntax_.comments) return false;
    const char* const from = at_ + 1;
    while (at_ != end_ && !ends_line(*at_)) ++at_;
    if (syntax_.kept) syntax_.kept->add({from, static_cast<std::size_t>(at_ - from)});
    return true;
  }
  if (*at_ == '\\') {
    const char* const next = after_line_end(at_ + 1);
    if (!syntax_.continuations || next == at_ + 1) return false;
    at_ = next;
    return true;
  }
  if (!std::string_view(at_, remaining()).starts_with(byte_order_mark)) return false;
  at_ += byte_order_mark.size();
  return true;
}

// Microsoft's C library wrote -1.#IND00, 1.#QNAN, 1.#INF, also cut short and rounded up as if they
// were digits: 1.#QO, 1.#R. What was cut so short that it may be either, 1.#J and 1.#IO, is no
// number here. AIX wrote NaNQ and NaNS.
bool Text::number_word(const char* from, double& value) {
  const char* end = from;
  while (!ends_token(end)) ++end;
  std::string_view word(from, static_cast<std::size_t>(end - from));
  const bool negative = word.starts_with('-');
  if (negative) word.remove_prefix(1);
  const auto one_of = [&](std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (word.starts_with("1.#")) {
    if (const std::size_t exponent = word.find_first_of("eE"); exponent != word.npos)
      word = word.substr(0, exponent);
    word = word.substr(0, word.find_last_not_of('0') + 1);
    if (one_of({"1.#INF"}))
      value = std::numeric_limits<double>::infinity();
    else if (one_of({"1.#IND", "1.#QNAN", "1.#QNB", "1.#QO", "1.#R", "1.#SNAN", "1.#SNB", "1.#SO",
                     "1.#T"}))
      value = nan;
    else
      return false;
  } else if (one_of({"NaNQ", "NaNS"})) {
    value = nan;
  } else {
    return false;
  }
  if (negative) value = std::copysign(value, -1.0);
  at_ = end;
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
  for (Text text = *this; !text.at_line_end(); ++tokens) text.token();
  return tokens;
}

std::string_view Text::rest_of_line() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
  const char* from = at_;
  while (at_ != end_ && !ends_line(*at_)) ++at_;
  const char* to = at_;
  while (to != from && is_blank(to[-1])) --to;
  return {from, static_cast<std::size_t>(to - from)};
}

std::string_view Text::raw_rest_of_line() {
  const char* from = at_;
  while (at_ != end_ && !ends_line(*at_)) ++at_;
  return {from, static_cast<std::size_t>(at_ - from)};
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
  const std::string found = at_ == end_       ? "the end of the file"
                            : ends_line(*at_) ? "the end of the line"
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
