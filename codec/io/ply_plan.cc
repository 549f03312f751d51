// Which properties make which attribute, and what the properties of an attribute are called.
#include <algorithm>
#include <map>
#include <set>

#include "codec/base/utf8.h"
#include "codec/io/formats.h"
#include "codec/io/ply.h"

namespace clers::io::ply {

namespace {

constexpr std::size_t longest_name = 255;  // of an attribute in a .clers file

bool claim_holds(const Claim& claim, const Element& element) {
  const std::span properties = element.properties;
  if (claim.first >= properties.size()) return false;
  const Property& first = properties[claim.first];
  if (first.count_type) return element.name == "face" && first.meaning == Meaning::value;
  if (properties.size() - claim.first < claim.components) return false;
  const std::span members = properties.subspan(claim.first, claim.components);
  return std::all_of(members.begin(), members.end(),
                     [&](const Property& p) { return !p.count_type && p.type == first.type; });
}

// Names of properties may be any bytes: most likely Latin-1.
std::string as_attribute(std::string_view property) {
  std::string name =
      internal::is_utf8(property) ? std::string(property) : utf8_of_latin_1(property);
  if (name.size() > longest_name) name.resize(longest_name - 8);
  name.resize(internal::first_not_utf8(name));  // what was cut in the middle
  return name;
}

// Gives every attribute of a domain a name of its own.
class Names {
 public:
  std::string unused(Domain domain, const std::string& wanted) {
    std::string name = wanted;
    for (unsigned& n = next_[{domain, wanted}]; !taken_.insert({domain, name}).second;)
      name = wanted.substr(0, longest_name - 12) + '_' + std::to_string(2 + n++);
    return name;
  }

 private:
  std::set<std::pair<Domain, std::string>> taken_;
  std::map<std::pair<Domain, std::string>, unsigned> next_;
};

}  // namespace

bool lies_by_corner(const Element& element, const Property& property) {
  return element.name == "face" && property.count_type && property.meaning == Meaning::value &&
         (property.name == "texcoord" || property.name == "color");
}

std::vector<Entry> plan(const Element& element) {
  const Domain domain = element.name == "vertex" ? Domain::vertex : Domain::face;
  std::map<std::size_t, Entry> entries;  // by first property
  std::vector<bool> taken(element.properties.size());
  const auto take = [&](Entry entry) {
    for (const std::size_t i : entry.members) taken[i] = true;
    const std::size_t first = *std::min_element(entry.members.begin(), entry.members.end());
    entries.emplace(first, std::move(entry));
  };

  for (const Claim& claim : element.claims) {
    if (!claim_holds(claim, element)) continue;
    const bool list = element.properties[claim.first].count_type.has_value();
    Entry entry{
        as_attribute(claim.name), list ? Domain::corner : domain, {claim.first}, claim.components};
    if (!list)
      while (entry.members.size() < claim.components)
        entry.members.push_back(entry.members.back() + 1);
    if (std::none_of(entry.members.begin(), entry.members.end(),
                     [&](std::size_t i) { return taken[i]; }))
      take(std::move(entry));
  }

  std::map<std::string_view, std::size_t> scalars;
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (const Property& p = element.properties[i]; !p.count_type && !taken[i]) scalars[p.name] = i;
  std::set<std::string_view> found;
  for (const Convention& convention : conventions) {
    if (found.contains(convention.attribute)) continue;
    std::vector<std::size_t> members;
    for (const std::string_view name : convention.names())
      if (const auto at = scalars.find(name); at != scalars.end()) members.push_back(at->second);
    if (members.size() != convention.components) continue;
    const auto other_type = [&](std::size_t i) {
      return element.properties[i].type != element.properties[members[0]].type;
    };
    if (convention.attribute != position_name &&
        std::any_of(members.begin(), members.end(), other_type))
      continue;
    found.insert(convention.attribute);
    take({std::string(convention.attribute), domain, std::move(members), 0});
  }

  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (const Property& p = element.properties[i]; p.meaning == Meaning::value && !taken[i])
      take({as_attribute(p.name), lies_by_corner(element, p) ? Domain::corner : domain, {i}, 0});

  // Conventions first: what is called like one of them by chance gets another name.
  Names names;
  std::vector<Entry> plan;
  for (const bool alone : {false, true})
    for (auto& [first, entry] : entries)
      if ((entry.members.size() == 1) == alone)
        entry.attribute = names.unused(entry.domain, entry.attribute);
  for (auto& [first, entry] : entries) plan.push_back(std::move(entry));
  return plan;
}

const Convention* convention_of(std::string_view attribute, std::size_t components) {
  for (const Convention& c : conventions)
    if (c.attribute == attribute && c.components == components) return &c;
  return nullptr;
}

void PropertyNames::add(Line line) {
  by_attribute_.emplace(Key{line.domain, line.attribute}, lines_.size());
  lines_.push_back(std::move(line));
}

namespace {

using Form = PropertyNames::Form;
constexpr struct {
  std::string_view word;
  Domain domain;
  Form form;
} line_starts[] = {
    {"vertex", Domain::vertex, Form::scalars}, {"face", Domain::face, Form::scalars},
    {"corner", Domain::corner, Form::list},    {"vertex-list", Domain::vertex, Form::list},
    {"face-list", Domain::face, Form::list},   {"vertex-lists", Domain::vertex, Form::lists},
    {"face-lists", Domain::face, Form::lists}};
constexpr std::string_view indices_word = "indices";

}  // namespace

std::string PropertyNames::text() const {
  std::string text;
  if (!indices.empty())
    text.append(indices_word).append(" ").append(percent_encoded(indices)).append("\n");
  for (const Line& line : lines_) {
    for (const auto& start : line_starts)
      if (start.domain == line.domain && start.form == line.form) text += start.word;
    text.append(" ").append(percent_encoded(line.attribute));
    for (const std::string& p : line.properties) text.append(" ").append(percent_encoded(p));
    text += '\n';
  }
  if (!text.empty()) text.pop_back();
  return text;
}

PropertyNames PropertyNames::of(const Mesh& mesh) {
  PropertyNames names;
  for_each_line(mesh, properties_key, [&](std::string_view text) {
    Text words(text);
    const auto next = [&] { return percent_decoded(words.token()).value_or(std::string()); };
    const std::string_view word = words.token();
    if (word == indices_word) {
      names.indices = next();
      return;
    }
    for (const auto& start : line_starts) {
      if (start.word != word) continue;
      Line line{start.domain, start.form, next(), {}};
      while (!words.at_line_end()) line.properties.push_back(next());
      names.add(std::move(line));
    }
  });
  return names;
}

const PropertyNames::Line* PropertyNames::find(const Attribute& a) const {
  const auto found = by_attribute_.find(Key{a.domain, a.name});
  return found == by_attribute_.end() ? nullptr : &lines_[found->second];
}

}  // namespace clers::io::ply
