#include "codec/io/obj_states.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <set>

#include "codec/io/formats.h"

namespace clers::io {

namespace {

std::uint32_t number_at(const Attribute& a, std::size_t i) {
  std::uint32_t number;
  std::memcpy(&number, a.data.data() + i * sizeof number, sizeof number);
  return number;
}

void append_number(Attribute& a, std::uint32_t number) {
  const auto* bytes = reinterpret_cast<const std::byte*>(&number);
  a.data.insert(a.data.end(), bytes, bytes + sizeof number);
}

}  // namespace

std::size_t obj_state_of(std::string_view keyword) {
  std::size_t i = 0;
  while (i < obj_states.size() && obj_states[i].keyword != keyword) ++i;
  return i;
}

void ObjNames::begin(std::string name, std::size_t face) {
  const auto [at, fresh] =
      numbers_.try_emplace(std::move(name), static_cast<std::uint32_t>(names_.size()));
  if (fresh) names_.push_back(at->first);
  if (!runs_.empty() && runs_.back().face == face) runs_.pop_back();
  runs_.push_back({face, at->second});
}

void ObjNames::add_to(Mesh& mesh, const ObjState& state, std::size_t faces) const {
  std::string lines;
  for (const std::string& name : names_) lines.append(lines.empty() ? "" : "\n").append(name);
  if (names_[0].empty() && names_.size() > 1) lines.insert(0, "\n");
  set_metadata(mesh, state.key, std::move(lines));
  const std::size_t without = std::min(runs_[0].face, faces);
  if (without == faces) return;
  Attribute a{std::string(state.attribute), Domain::face, Scalar::uint32, 1, {}};
  if (without > 0) {
    a.indices.assign(faces, no_value);
    for (std::uint32_t i = 0; i < names_.size(); ++i) append_number(a, i);
  }
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    const std::size_t end = r + 1 < runs_.size() ? runs_[r + 1].face : faces;
    for (std::size_t f = runs_[r].face; f < end; ++f)
      if (without > 0)
        a.indices[f] = runs_[r].name;
      else
        append_number(a, runs_[r].name);
  }
  mesh.attributes.push_back(std::move(a));
}

ObjFaces::ObjFaces(const Mesh& mesh) {
  current_.fill(no_value);
  for (std::size_t i = 0; i < obj_states.size(); ++i) {
    if (!metadata(mesh, obj_states[i].key)) continue;
    for_each_line(mesh, obj_states[i].key,
                  [&](std::string_view line) { names_[i].emplace_back(line); });
    used_[i].resize(names_[i].size());
    const Attribute* a = find(mesh, obj_states[i].attribute, Domain::face);
    if (!a || a->scalar != Scalar::uint32 || a->components != 1) continue;
    bool named = true;
    for (std::size_t v = 0; v < a->value_count(); ++v) named &= number_at(*a, v) < names_[i].size();
    if (named) attributes_[i] = a;
  }
  put_together(mesh.face_count());
}

bool ObjFaces::says(const Attribute& a) const {
  return std::find(attributes_.begin(), attributes_.end(), &a) != attributes_.end();
}

ObjFaces::Numbers ObjFaces::of(std::size_t f) const {
  Numbers numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Attribute* a = attributes_[i];
    const std::size_t value = !a || a->indices.empty() ? f : a->indices[f];
    numbers[i] = !a || value == no_value ? no_value : number_at(*a, value);
  }
  return numbers;
}

unsigned ObjFaces::said(const Numbers& numbers) {
  return static_cast<unsigned>(
      std::count_if(numbers.begin(), numbers.end(), [](auto n) { return n != no_value; }));
}

// No statement takes a name back: faces with fewer of them come first.
void ObjFaces::put_together(std::size_t faces) {
  if (std::all_of(attributes_.begin(), attributes_.end(), [](auto* a) { return !a; })) return;
  std::set<Numbers> met;
  Numbers last{};
  bool together = true;
  for (std::size_t f = 0; f < faces && together; ++f) {
    const Numbers now = of(f);
    if (f > 0 && now == last) continue;
    together = met.insert(now).second;
    for (std::size_t i = 0; f > 0 && i < now.size(); ++i)
      together &= now[i] != no_value || last[i] == no_value;
    last = now;
  }
  if (together) return;
  order_.resize(faces);
  std::iota(order_.begin(), order_.end(), 0u);
  std::stable_sort(order_.begin(), order_.end(), [&](std::uint32_t f, std::uint32_t g) {
    const Numbers of_f = of(f), of_g = of(g);
    const unsigned said_f = said(of_f), said_g = said(of_g);
    return said_f != said_g ? said_f < said_g : of_f < of_g;
  });
}

void ObjFaces::say(Output& out, std::size_t state, std::uint32_t number) {
  const std::string& name = names_[state][number];
  out << obj_states[state].keyword << (name.empty() ? "" : " ") << name << '\n';
  used_[state][number] = true;
}

void ObjFaces::begin(Output& out, std::size_t f) {
  const Numbers now = of(f);
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] != current_[i]) say(out, i, now[i]);
  current_ = now;
}

void ObjFaces::end(Output& out) {
  for (std::size_t i = 0; i < names_.size(); ++i)
    for (std::uint32_t n = 0; n < names_[i].size(); ++n)
      if (!used_[i][n]) say(out, i, n);
}

}  // namespace clers::io
