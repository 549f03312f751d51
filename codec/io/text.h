// Text in memory: a cursor that reads tokens and numbers, and a buffer that numbers are printed to.
#ifndef CLERS_CODEC_IO_TEXT_H
#define CLERS_CODEC_IO_TEXT_H

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "codec/error.h"

namespace clers::io {

inline std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The comments of a text, each once, however often the cursor looks at it.
class Comments {
 public:
  void add(std::string_view comment);
  std::uint64_t count() const { return count_; }
  /// A comment a line; the last line has no end.
  std::string take() { return std::move(lines_); }

 private:
  std::string lines_;
  std::uint64_t count_ = 0;
  const char* seen_ = nullptr;  // up to where
};

/// What counts as blank besides spaces, tabs and byte order marks.
struct Syntax {
  bool comments = false;       ///< '#' where a token could begin, to the end of the line
  bool continuations = false;  ///< '\' before the end of the line
  Comments* kept = nullptr;    ///< where comments go, if anywhere
};

/// A cursor over text, whose lines end in LF, CR LF or CR. Reading a token, an integer or a number
/// first skips blanks, but no line ends: what may go on to the next line calls skip_space() before.
/// A read that fails moves no further than the blanks, so that expected() can say what stands
/// there.
class Text {
 public:
  explicit Text(std::string_view text, Syntax syntax = {})
      : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), syntax_(syntax) {}

  const char* at() const { return at_; }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }

  /// Precondition: bytes <= remaining().
  void skip(std::size_t bytes) { at_ += bytes; }

  /// A pointer into the text -> its line, from 1. Cost: linear in the text; only errors need it.
  std::uint64_t line_of(const char* where) const;

  void skip_blanks() {
    for (;;) {
      while (at_ != end_ && (*at_ == ' ' || *at_ == '\t')) ++at_;
      if (at_ == end_ || (*at_ != '#' && *at_ != '\\' && *at_ != '\xef') || !skip_odd_blank())
        return;
    }
  }
  void skip_space() {
    for (skip_blanks(); at_ != end_ && ends_line(*at_); skip_blanks()) ++at_;
  }
  /// Whether nothing but blanks is left on the line.
  bool at_line_end() {
    skip_blanks();
    return at_ == end_ || ends_line(*at_);
  }
  /// Whether nothing but blanks and line ends is left.
  bool at_end() {
    skip_space();
    return at_ == end_;
  }
  /// Goes to the start of the next line.
  void next_line() {
    while (!at_line_end()) token();
    skip_line_end();
  }
  /// Precondition: at the end of a line, or of the text.
  void skip_line_end() { at_ = after_line_end(at_); }

  /// Whether no token goes on here.
  bool at_token_end() const { return ends_token(at_); }
  /// How many tokens are left on the line.
  std::size_t tokens_on_line() const;

  /// Up to the next blank or line end; empty at the end of the line.
  std::string_view token();
  /// All up to the end of the line, without the blanks around it; comments are no comments here.
  std::string_view rest_of_line();

  /// All up to the end of the line, blanks and all.
  std::string_view raw_rest_of_line();

  /// A whole token that is an integer. What does not fit T is no T.
  template <class T>
  bool integer(T& value) {
    skip_blanks();
    const char* from = at_ + (at_ != end_ && *at_ == '+' && !sign_at(at_ + 1));
    const auto [end, ec] = std::from_chars(from, end_, value);
    if (ec != std::errc() || !ends_token(end)) return false;
    at_ = end;
    return true;
  }
  /// A whole token that is a decimal number, inf, nan, or what old C libraries wrote for these;
  /// rounded to the nearest T, also to zero. What is too large for T is no number.
  template <class T>
  bool number(T& value) {
    skip_blanks();
    const char* from = at_ + (at_ != end_ && *at_ == '+' && !sign_at(at_ + 1));
    const auto [end, ec] = std::from_chars(from, end_, value);
    if (ec == std::errc::result_out_of_range && rounds_to_zero({from, end}))
      value = *from == '-' ? -T(0) : T(0);
    else if (ec != std::errc())
      return false;
    if (ends_token(end)) {
      at_ = end;
      return true;
    }
    double word = 0;
    if (!number_word(from, word)) return false;
    value = static_cast<T>(word);
    return true;
  }
  /// One character, directly at the cursor.
  bool character(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }
  /// Up to 18 digits, directly at the cursor, perhaps after a minus; whatever follows them.
  bool digits(std::int64_t& value) {
    const bool negative = at_ != end_ && *at_ == '-';
    const char* const from = at_ + negative;
    const char* p = from;
    std::int64_t sum = 0;
    for (; digit_at(p) && p - from < 18; ++p) sum = 10 * sum + (*p - '0');
    if (p == from || digit_at(p)) return false;
    value = negative ? -sum : sum;
    at_ = p;
    return true;
  }

  /// malformed: "expected WHAT, found 'the token here'", at the line of the cursor.
  Failure<Error> expected(std::string_view what);
  /// malformed, at the line of `where`.
  Failure<Error> malformed(const char* where, std::string what) const {
    return fail(ErrorCode::malformed, Place::line, line_of(where), std::move(what));
  }

 private:
  bool digit_at(const char* p) const { return p != end_ && *p >= '0' && *p <= '9'; }
  bool sign_at(const char* p) const { return p != end_ && (*p == '+' || *p == '-'); }
  bool ends_token(const char* p) const {
    return p == end_ || *p == ' ' || *p == '\t' || ends_line(*p) ||
           (*p == '\\' && syntax_.continuations && after_line_end(p + 1) != p + 1);
  }
  static bool ends_line(char c) { return c == '\n' || c == '\r'; }
  /// Past the end of a line at p; p if there is none.
  const char* after_line_end(const char* p) const {
    if (p != end_ && *p == '\r') return p + 1 + (p + 1 != end_ && p[1] == '\n');
    return p + (p != end_ && *p == '\n');
  }
  bool skip_odd_blank();
  bool number_word(const char* from, double& value);
  static bool rounds_to_zero(std::string_view number);

  const char* begin_;
  const char* at_;
  const char* end_;
  Syntax syntax_;
};

/// A piece of a file as an error message shows it: short, in quotes, without control characters.
std::string quoted(std::string_view piece);

/// "1 entry", "2 entries".
std::string counted(std::uint64_t count, std::string_view one, std::string_view many);

/// Bytes under construction.
class Output {
 public:
  Output& operator<<(std::string_view text) {
    append(text.data(), text.size());
    return *this;
  }
  Output& operator<<(char c) {
    *room(1) = c;
    ++size_;
    return *this;
  }
  /// The shortest decimal text that reads back as the same value.
  template <class T>
  void number(T value) {
    constexpr std::size_t longest = 32;
    char* const to = room(longest);
    size_ += static_cast<std::size_t>(std::to_chars(to, to + longest, value).ptr - to);
  }
  void append(const void* data, std::size_t size) {
    if (size > 0) std::memcpy(room(size), data, size);
    size_ += size;
  }
  /// Little endian, whatever the machine.
  template <class T>
  void little(T value) {
    char* const to = room(sizeof value);
    for (std::size_t i = 0; i < sizeof value; ++i)
      to[i] = static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i));
    size_ += sizeof value;
  }

  bool empty() const { return size_ == 0; }
  std::vector<std::byte> take() {
    bytes_.resize(size_);
    size_ = 0;
    return std::move(bytes_);
  }

 private:
  // Where the next bytes go; there is room for that many.
  char* room(std::size_t bytes) {
    if (bytes_.size() - size_ < bytes) bytes_.resize(2 * bytes_.size() + bytes);
    return reinterpret_cast<char*>(bytes_.data()) + size_;
  }

  std::vector<std::byte> bytes_;
  std::size_t size_ = 0;  // of the bytes written
};

}  // namespace clers::io

#endif
