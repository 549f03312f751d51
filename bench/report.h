// One self-contained page that draws the results.
#ifndef CLERS_BENCH_REPORT_H
#define CLERS_BENCH_REPORT_H

#include <string>

namespace clers::bench {

/// `results` is what write_json() wrote; `scaling` what the program scaling wrote, or empty.
std::string report_page(const std::string& results, const std::string& scaling);

}  // namespace clers::bench

#endif
