#include "table/language.hpp"

namespace stoss::table {

const Language& language_c() {
  static const Language language{.comment = "/*",
                                 .line = " *",
                                 .comment_end = " */\n",
                                 .array = "static const @type@ @array@[@size@] = {",
                                 .array_end = "};",
                                 .number = "double",
                                 .whole = "int",
                                 // For the body the macros @NAME@_FUNCTION (how a function begins that may stay unused)
                                 // and @NAME@_INDEX (a double as int), of which nothing remains.
                                 .begin = R"(#ifndef @NAME@_RESTITUTION_TABLE
#define @NAME@_RESTITUTION_TABLE

#include <math.h>

#if defined(__GNUC__)
#define @NAME@_FUNCTION static __inline__ __attribute__((unused))
#elif defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L)
#define @NAME@_FUNCTION static inline
#else
#define @NAME@_FUNCTION static
#endif
#ifdef __cplusplus
#define @NAME@_INDEX(x) static_cast<int>(x)
#else
#define @NAME@_INDEX(x) ((int)(x))
#endif

)",
                                 .end = R"(
#undef @NAME@_FUNCTION
#undef @NAME@_INDEX

#endif
)",
                                 .words = {{"comment", "/* "},
                                           {"more", " * "},
                                           {"done", " */"},
                                           // Functions and their arguments.
                                           {"public", "@NAME@_FUNCTION double @name@_$"},
                                           {"number_function", "@NAME@_FUNCTION double @name@_$"},
                                           {"whole_function", "@NAME@_FUNCTION int @name@_$"},
                                           {"function", "@NAME@_FUNCTION void @name@_$"},
                                           {"gives_number", "\n{"},
                                           {"gives_whole", "\n{"},
                                           {"gives_nothing", "\n{"},
                                           {"number", "double $"},
                                           {"whole", "int $"},
                                           {"numbers", "const double *$"},
                                           {"wholes", "const int *$"},
                                           {"out", "double *$"},
                                           // What they are given.
                                           {"in", "$"},
                                           {"out_of", "$"},
                                           {"from", "$ + "},
                                           {"till", ""},
                                           {"unused", "(void)$"},
                                           // Constants and variables.
                                           {"limit", "#define @NAME@_$ "},
                                           {"limit_end", ""},
                                           {"row", "const double *$"},
                                           {"constant", "const double $"},
                                           {"also_constant", ", $"},
                                           {"variable", "double $"},
                                           {"also_variable", ", $"},
                                           {"flag", "const int $"},
                                           {"later_numbers", "double $"},
                                           {"later_whole", "int $"},
                                           {"weights", "double w[$][3];\n  int k[$]"},
                                           {"found", "double found[$]"},
                                           // Statements.
                                           {"if", "if ("},
                                           {"while", "while ("},
                                           {"then", ") "},
                                           {"end", ""},
                                           {"block", ") {"},
                                           {"next", "++k;"},
                                           {"from_zero", "  if (k < 0) k = 0;\n"},
                                           {"both_nan", "found[0] = found[1] = HUGE_VAL - HUGE_VAL"},
                                           // Functions of numbers.
                                           {"index", "@NAME@_INDEX("},
                                           {"indexed", ")"},
                                           {"absolute", "fabs("},
                                           {"log", "log("},
                                           {"infinity", "HUGE_VAL"}}};
  return language;
}

}  // namespace stoss::table
