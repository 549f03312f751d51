#include "bench/report.h"

namespace clers::bench {

// bench/report.html, made an array by the build.
extern const char report_template[];
extern const unsigned long report_template_size;

namespace {

// JSON stands in a <script>, which "</" would end.
std::string embedded(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

void put(std::string& page, const std::string& mark, const std::string& text) {
  const std::size_t at = page.find(mark);
  if (at != std::string::npos) page.replace(at, mark.size(), text);
}

}  // namespace

std::string report_page(const std::string& results, const std::string& scaling) {
  std::string page(report_template, report_template_size);
  put(page, "\"@RESULTS@\"", embedded(results));
  put(page, "\"@SCALING@\"", scaling.empty() ? "null" : embedded(scaling));
  return page;
}

}  // namespace clers::bench
