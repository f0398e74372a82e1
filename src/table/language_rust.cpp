#include "table/language.hpp"

namespace stoss::table {

// What a program leaves unused, and names that the user chose, are no reason to warn.
const Language& language_rust() {
  static const Language language{.comment = "//",
                                 .line = "//",
                                 .comment_end = "\n",
                                 .array = "#[allow(non_upper_case_globals)]\nstatic @array@: [@type@; @size@] = [",
                                 .array_end = "];",
                                 .number = "f64",
                                 .whole = "usize",
                                 .begin = "",
                                 .end = "",
                                 .words = {{"comment", "// "},
                                           {"more", "// "},
                                           {"done", ""},
                                           {"public", "#[allow(dead_code, non_snake_case)]\npub fn @name@_$"},
                                           {"number_function", "#[allow(non_snake_case)]\nfn @name@_$"},
                                           {"whole_function", "#[allow(non_snake_case)]\nfn @name@_$"},
                                           {"function", "#[allow(non_snake_case, unused_mut)]\nfn @name@_$"},
                                           {"gives_number", " -> f64 {"},
                                           {"gives_whole", " -> usize {"},
                                           {"gives_nothing", " {"},
                                           {"number", "$: f64"},
                                           {"whole", "$: usize"},
                                           {"numbers", "$: &[f64]"},
                                           {"wholes", "$: &[usize]"},
                                           {"out", "$: &mut [f64]"},
                                           {"in", "&$"},
                                           {"out_of", "&mut $"},
                                           {"from", "&$["},
                                           {"till", "..]"},
                                           {"unused", "let _ = $"},
                                           {"limit", "#[allow(dead_code)]\npub const @NAME@_$: f64 = "},
                                           {"limit_end", ";"},
                                           {"row", "let $"},
                                           {"constant", "let $"},
                                           {"also_constant", ";\n  let $"},
                                           {"variable", "let mut $"},
                                           {"also_variable", ";\n  let mut $"},
                                           {"flag", "let $"},
                                           {"later_numbers", "let ($)"},
                                           {"later_whole", "let mut $"},
                                           {"weights", "let mut w = [[0.0; 3]; $];\n  let mut k = [0; $]"},
                                           {"found", "let mut found = [0.0; $]"},
                                           {"if", "if "},
                                           {"while", "while "},
                                           {"then", " { "},
                                           {"end", " }"},
                                           {"block", " {"},
                                           {"next", "k += 1;"},
                                           {"from_zero", ""},  // which the conversion takes for what is below
                                           {"both_nan", "found[0] = f64::NAN;\n    found[1] = f64::NAN"},
                                           {"index", "("},
                                           {"indexed", ") as usize"},
                                           {"absolute", "f64::abs("},
                                           {"log", "f64::ln("},
                                           {"infinity", "f64::INFINITY"}}};
  return language;
}

}  // namespace stoss::table
