#include "corpus/recipe.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "corpus/generate.h"

namespace clers::corpus {
namespace {

using Value = std::variant<Mesh, std::uint64_t, Ends>;
using Arguments = std::vector<Value>;
using Function = std::function<std::optional<Mesh>(const Arguments&)>;

// The argument as a function's parameter of type T, or null.
template <class T>
std::optional<T> as(const Value& value) {
  if constexpr (std::is_integral_v<T>) {
    const auto* number = std::get_if<std::uint64_t>(&value);
    if (!number || *number > std::numeric_limits<T>::max()) return {};
    return static_cast<T>(*number);
  } else {
    const T* same = std::get_if<T>(&value);
    if (!same) return {};
    return *same;
  }
}

template <class... T, std::size_t... I>
std::optional<Mesh> apply(Mesh (*f)(T...), const Arguments& arguments, std::index_sequence<I...>) {
  const std::tuple<std::optional<std::decay_t<T>>...> cast{as<std::decay_t<T>>(arguments[I])...};
  if (!(std::get<I>(cast).has_value() && ...)) return {};
  return f(*std::get<I>(cast)...);
}

template <class... T>
Function takes(Mesh (*f)(T...)) {
  return [f](const Arguments& arguments) -> std::optional<Mesh> {
    if (arguments.size() != sizeof...(T)) return {};
    return apply(f, arguments, std::index_sequence_for<T...>{});
  };
}

Mesh union_of_two(const Mesh& a, const Mesh& b) {
  return disjoint_union(std::array{a, b});
}

// recipe = name [ "(" [ value { "," value } ] ")" ];  value = number | recipe
class Cook {
 public:
  explicit Cook(std::string_view text) : text_(text) {}

  std::optional<Mesh> whole() {
    std::optional<Value> value = this->value();
    skip_spaces();
    if (!value || !text_.empty() || !std::holds_alternative<Mesh>(*value)) return {};
    return std::get<Mesh>(std::move(*value));
  }

 private:
  void skip_spaces() {
    while (!text_.empty() && text_.front() == ' ') text_.remove_prefix(1);
  }

  bool accept(char c) {
    skip_spaces();
    if (text_.empty() || text_.front() != c) return false;
    text_.remove_prefix(1);
    return true;
  }

  std::string_view word() {
    skip_spaces();
    const std::size_t end = text_.find_first_not_of("abcdefghijklmnopqrstuvwxyz_");
    const std::string_view found = text_.substr(0, end);
    text_.remove_prefix(found.size());
    return found;
  }

  std::optional<Value> value() {
    skip_spaces();
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), number);
    if (error == std::errc{}) {
      text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
      return number;
    }
    const std::string_view name = word();
    if (name == "open") return Ends::open;
    if (name == "capped") return Ends::capped;
    if (name == "periodic") return Ends::periodic;
    const Function function = named(name);
    Arguments arguments;
    if (!function || (accept('(') && !parse_arguments(arguments))) return {};
    std::optional<Mesh> mesh = function(arguments);
    if (!mesh) return {};
    return std::move(*mesh);
  }

  bool parse_arguments(Arguments& arguments) {
    if (accept(')')) return true;
    do {
      std::optional<Value> argument = value();
      if (!argument) return false;
      arguments.push_back(std::move(*argument));
    } while (accept(','));
    return accept(')');
  }

  static Function named(std::string_view name) {
    const std::array<std::pair<std::string_view, Function>, 30> functions = {{
        {"single_triangle", takes(single_triangle)},
        {"glued_pair", takes(glued_pair)},
        {"tetrahedron", takes(tetrahedron)},
        {"icosphere", takes(icosphere)},
        {"torus", takes(torus)},
        {"grid", takes(grid)},
        {"cylinder", takes(cylinder)},
        {"moebius_strip", takes(moebius_strip)},
        {"flip_edges", takes(flip_edges)},
        {"punch_holes", takes(punch_holes)},
        {"gyroid", takes(gyroid)},
        {"lattice", takes(lattice)},
        {"shuffle", takes(shuffle)},
        {"reversed", takes(reversed)},
        {"disjoint_union", takes(union_of_two)},
        {"copies", takes(copies)},
        {"doubled", takes(doubled)},
        {"two_sided", takes(two_sided)},
        {"add_fins", takes(add_fins)},
        {"reverse_some", takes(reverse_some)},
        {"isolate", takes(isolate)},
        {"same_triangle", takes(same_triangle)},
        {"all_triples", takes(all_triples)},
        {"pinched_hub", takes(pinched_hub)},
        {"random_soup", takes(random_soup)},
        {"fan", takes(fan)},
        {"book", takes(book)},
        {"chessboard", takes(chessboard)},
        {"strip", takes(strip)},
        {"loose_triangles", takes(loose_triangles)},
    }};
    for (const auto& [known, function] : functions)
      if (known == name) return function;
    return {};
  }

  std::string_view text_;
};

}  // namespace

std::optional<Mesh> cook(std::string_view recipe) {
  std::optional<Mesh> mesh = Cook(recipe).whole();
  if (mesh) mesh->name = recipe;
  return mesh;
}

}  // namespace clers::corpus
