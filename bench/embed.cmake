# IN -> OUT: a file as a C++ array.
file(READ ${IN} hex HEX)
string(REGEX REPLACE "(................................................................)" "\\1\n" hex "${hex}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," hex "${hex}")
file(WRITE ${OUT} "namespace clers::bench {
extern const char report_template[];
extern const unsigned long report_template_size;
const char report_template[] = {
${hex}};
const unsigned long report_template_size = sizeof report_template;
}  // namespace clers::bench
")
