// <clers.h> is for C++ too, beside the headers of C++.
#include <clers.h>

#include <cstring>

#include <clers/version.h>

int main() {
  clers_error error = {};
  error.size = sizeof error;
  clers_decoder* decoder = nullptr;
  if (clers_open("", 0, nullptr, &decoder, &error) != CLERS_TRUNCATED) return 1;
  return std::strcmp(clers_version(), clers::version);
}
