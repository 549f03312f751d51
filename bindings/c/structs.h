// What C code hands in and gets back: structs that grow, arrays of them, errors and no exceptions.
#ifndef CLERS_BINDINGS_C_STRUCTS_H
#define CLERS_BINDINGS_C_STRUCTS_H

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>
#include <span>
#include <stdexcept>
#include <string>

#include "bindings/c/clers.h"
#include "codec/error.h"

namespace clers::internal {

inline Failure<Error> bad_option(std::string what) {
  return fail(ErrorCode::bad_option, std::move(what));
}

/// The least size that a program may say a struct has: that of the first version that had it.
/// Whoever adds fields to one keeps here what it was before.
template <class T>
inline constexpr std::size_t least_size = sizeof(T);

/// Is it a struct, and is nothing set that this library does not know?
template <class T>
Expected<Done> check_struct(const T* given, const char* what) {
  const auto refuse = [&](const std::string& why) { return bad_option(what + why); };
  if (given == nullptr) return refuse(" is NULL");
  const std::size_t size = given->size;
  if (size < least_size<T> || size % alignof(T) != 0)
    return refuse(" has a size of " + std::to_string(size) + ", expected " +
                  std::to_string(sizeof(T)));
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  if (size > sizeof(T) &&
      std::any_of(bytes + sizeof(T), bytes + size, [](unsigned char b) { return b != 0; }))
    return refuse(" asks for what this version of clers does not know");
  return Done{};
}

/// A struct that was checked, with 0 for what it is too small to have.
template <class T>
T copied(const T* given) {
  T value{};
  std::memcpy(static_cast<void*>(&value), given, std::min(given->size, sizeof(T)));
  return value;
}

/// What the caller set in a struct that goes in; defaults if it may be NULL, and is.
template <class T>
Expected<T> taken(const T* given, const char* what) {
  if (auto ok = check_struct(given, what); !ok) return Failure{ok.error()};
  return copied(given);
}
template <class T>
Expected<T> taken_or_default(const T* given, const char* what) {
  if (given == nullptr) return T{};
  return taken(given, what);
}

/// An array of structs, which may be of another size than those that are known here.
template <class T>
class Structs {
 public:
  static Expected<Structs> of(const T* first, std::size_t count, const char* what) {
    if (count == 0) return Structs(nullptr, 0);
    Structs all(first, count);
    for (std::size_t i = 0; i < count; ++i) {
      if (auto ok = check_struct(all.at(i), what); !ok) return Failure{ok.error()};
      if (all.at(i)->size != first->size)
        return bad_option(std::string(what) + "s have different sizes in an array");
    }
    return all;
  }

  std::size_t size() const { return count_; }
  T operator[](std::size_t i) const { return copied(at(i)); }

 private:
  /// Precondition: the first is there, unless i is 0.
  const T* at(std::size_t i) const {
    if (i == 0) return first_;
    const auto* bytes = reinterpret_cast<const unsigned char*>(first_);
    return reinterpret_cast<const T*>(bytes + i * first_->size);
  }
  Structs(const T* first, std::size_t count) : first_(first), count_(count) {}

  const T* first_;
  std::size_t count_;
};

/// Fills in a struct that goes out, as far as it goes; fields that are not known here become 0.
template <class T>
Expected<Done> give(T value, T* out, const char* what) {
  if (out == nullptr) return bad_option(std::string(what) + " is NULL");
  const std::size_t size = out->size;
  if (size < least_size<T>)
    return bad_option(std::string(what) + " has a size of " + std::to_string(size) + ", expected " +
                      std::to_string(sizeof(T)));
  value.size = size;
  std::memset(static_cast<void*>(out), 0, size);
  std::memcpy(static_cast<void*>(out), &value, std::min(size, sizeof(T)));
  return Done{};
}

/// An array of the caller's; NULL is none.
template <class T>
std::span<T> array_of(T* first, std::size_t count) {
  return first == nullptr ? std::span<T>() : std::span<T>(first, count);
}
inline std::span<const std::byte> bytes_of(const void* first, std::size_t size) {
  return array_of(static_cast<const std::byte*>(first), size);
}

/// Says what is wrong, as far as the caller's struct has room. Allocates nothing.
inline clers_code report(clers_error* out, clers_code code, const Error& error, const char* text) {
  if (out == nullptr || out->size < least_size<clers_error>) return code;
  clers_error value{};
  value.code = code;
  value.place = static_cast<std::int32_t>(error.place);
  value.at = error.at;
  value.limited = static_cast<std::int32_t>(error.limited);
  value.needed = error.needed;
  std::size_t length = std::min(std::strlen(text), sizeof value.text - 1);
  if (text[length] != 0)  // no half a character
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xc0) == 0x80) --length;
  std::memcpy(value.text, text, length);
  static_cast<void>(give(value, out, ""));
  return code;
}

/// `work()`, which returns an Expected<Done>, as C sees it: nothing is thrown.
template <class Work>
clers_code guarded_for_c(clers_error* error, const Work& work) noexcept {
  const auto fails = [&](ErrorCode code, const char* text) {
    return report(error, static_cast<clers_code>(code), Error{code, {}, 0, {}, {}, 0}, text);
  };
  try {
    const Expected<Done> done = work();
    if (done) return report(error, CLERS_OK, Error{}, "");
    const std::string text = describe(done.error());
    return report(error, static_cast<clers_code>(done.error().code), done.error(), text.c_str());
  } catch (const std::bad_alloc&) {
    return fails(ErrorCode::out_of_memory, "not enough memory");
  } catch (const std::length_error&) {
    return fails(ErrorCode::out_of_memory, "not enough memory");
  } catch (...) {
    return fails(ErrorCode::internal, "an exception that clers does not know");
  }
}

}  // namespace clers::internal

#endif
