// A rule has two grids: of ε_n, and of q.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stoss/table/c_source.hpp"
#include "table/c_grid.hpp"
#include "table/c_text.hpp"
#include "table/rule/c_rule_text.hpp"
#include "table/rule/js_rule_text.hpp"
#include "table/rule/rust_rule_text.hpp"

namespace stoss {
namespace {

/// What a rule takes beyond a table: its functions, and two bodies as arguments.
struct Texts {
  std::string_view function, collide, bodies;
};

std::vector<std::string> comment(const RuleTable& rule, const TableLabel& label, std::string_view bodies) {
  const RuleValues& values = rule.values();
  const bool mixture = values.sliding.ratios.size() > 1;
  return {
      std::string("Collision rule of two round elastic bodies with friction: speed v of approach along the normal, ") +
          "sliding s of the",
      "first body's point of contact over the second's, Coulomb's friction, ratio of the second radius to the first.",
      "",
      "  @name@_restitution(v, s, friction, ratio)  of the normal velocity, error at most " +
          table::at_most(rule.greatest_restitution_error()),
      "  @name@_sliding(v, s, friction, ratio)      s afterwards",
      "  @name@_collide_2d(" + std::string(bodies) +
          ", normal, friction), _3d  changes velocities and spins, with the normal from a to b,",
      "                                             of any length but 0. 1: done. 0: they do not approach, and -1: the",
      "                                             normal has no direction, an argument is not finite, negative, or",
      "                                             none of the table (friction, ratio); then nothing changes",
      "",
      "Velocities are in " + label.unit + ", spins times radii too. Errors, interpolation included, are those of",
      "@name@_restitution_error and @name@_sliding_error, the latter over |v_t| + |spin R| of both + friction v: at",
      "most " + table::at_most(rule.greatest_sliding_error()) + ".",
      "",
      values.friction ? "The friction must be @NAME@_FRICTION; with another one values are not numbers."
                      : "The friction may be any.",
      mixture ? "Ratios go from @NAME@_SMALLEST to @NAME@_GREATEST" +
                    std::string(values.sliding.alike ? "; the inverse is the same pair." : ".")
              : "The ratio does not count.",
      "Speeds go from @NAME@_SLOWEST to @NAME@_FASTEST. Beyond, values are " +
          std::string(rule.beyond() == Beyond::clamp ? "those of the nearer end," : "not numbers,") +
          " errors @infinity@.",
      "",
      "Where s = 0 there is no friction. |s afterwards| <= |s| and restitution <= 1: no collision gains energy.",
      ""};
}

std::string of(const RuleTable& rule, const TableLabel& label, const table::Language& language, const Texts& texts) {
  table::require_c_name(label.name);
  const std::string name = label.name + "_rule";
  const auto& [normal, along, friction] = rule.values();
  const bool mixture = along.ratios.size() > 1;
  const table::CRange range(along.ratios, along.alike, language);
  const std::vector<std::pair<std::string, std::string>> fillings{
      {"place", range.place},
      {"inside", range.inside},
      {"friction", friction ? "!(friction < @NAME@_FRICTION) && !(friction > @NAME@_FRICTION)"
                            : worded("friction >= 0.0 && friction < @infinity@", language)},
      {"ratio", mixture ? worded(" && ratio > 0.0 && ratio < @infinity@", language) : ""},
      {"unused", mixture ? "" : worded("  @unused:ratio@;\n", language)},
      {"outside", rule.beyond() == Beyond::clamp ? range.nearest : "    return;\n"}};
  std::string body = table::c_limits(along.speeds, along.ratios, label.scale, language);
  if (friction) body += worded("@limit:FRICTION@" + table::c_number(*friction) + "@limit_end@\n", language);
  body += "\n";
  body += table::c_look_up({{name + "_restitution", normal, rule.restitution_nodes(), rule.restitution_errors()},
                            {name + "_sliding", along, rule.sliding_nodes(), rule.sliding_errors()}},
                           label.scale, language);
  body += std::string(texts.function) +
          table::c_numbers_of({"speed", "sliding", "friction", "ratio"},
                              {"restitution", "restitution_error", "sliding", "sliding_error"}, language) +
          std::string(texts.collide);
  return table::c_file(name, table::c_description(comment(rule, label, texts.bodies), name, label, language),
                       table::filled(body, name, fillings), language);
}

}  // namespace

std::string c_header(const RuleTable& rule, const TableLabel& label) {
  return of(rule, label, table::language_c(), {table::c_rule_function, table::c_collide_functions, "&a, &b"});
}
std::string rust_module(const RuleTable& rule, const TableLabel& label) {
  return of(rule, label, table::language_rust(),
            {table::rust_rule_function, table::rust_collide_functions, "&mut a, &mut b"});
}
std::string js_module(const RuleTable& rule, const TableLabel& label) {
  return of(rule, label, table::language_js(), {table::js_rule_function, table::js_collide_functions, "a, b"});
}

}  // namespace stoss
