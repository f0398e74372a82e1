#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "stoss/restitution/ladder.hpp"
#include "stoss/table/table_values.hpp"
#include "table/axes.hpp"

namespace stoss {

/// Speeds and ratios of a table.
struct TableRange {
  AxisRange speeds, ratios{1.0, 1.0};
  bool is_mixture = false, alike = false;

  [[nodiscard]] double ratio(double p) const { return is_mixture ? ratios.ratio(p) : 1.0; }

  /// What a message says of a place.
  [[nodiscard]] std::string named(double x, double p) const;
};

/// Contacts of a range, each made once.
class Contacts {
 public:
  Contacts(std::function<RefinableContact(double ratio)> made_of, const TableRange& range)
      : made_of_(std::move(made_of)), range_(range) {}

  [[nodiscard]] const RefinableContact& at(double p);

 private:
  std::function<RefinableContact(double ratio)> made_of_;
  TableRange range_;
  std::map<double, RefinableContact> made_{};  ///< by p
};

/// Computed values at all crossings of x = ln v, z and p = (r − 1)/(r + 1), which grow until they predict what is
/// computed between them. An axis of one place does not count.
///
///   compute what is missing ─→ is a middle missed?  ─no→ may a cell be off by more? ─no→ done
///            ↑                        │ yes                       │ yes
///            └────── halve the intervals of the first axis in which that is so
class AdaptiveGrid {
 public:
  using Place = std::array<double, 3>;
  using Values = std::vector<Estimate>;  ///< of each quantity

  explicit AdaptiveGrid(const TableRange& range, NestedAxis slips = one_place());

  [[nodiscard]] const NestedAxis& axis(std::size_t number) const { return axes_[number]; }

  /// Number of axes that count.
  [[nodiscard]] std::size_t dimensions() const;

  void set(const Place& place, Values values) { values_[place] = std::move(values); }

  [[nodiscard]] const Values& at(const Place& place) const { return values_.at(place); }

  /// Halves intervals until every quantity is accurate enough along each axis.
  /// @param name    what refuses to need more than `most` values
  /// @param compute sets what is missing: for all p in turn, for all x, for all z
  void refine(const char* name, const std::vector<double>& enough, int most,
              const std::function<void(const std::vector<Place>&)>& compute);

  /// A quantity. The interpolation may be off by the sum of its errors along the axes.
  [[nodiscard]] TableValues table(std::size_t quantity) const;

 private:
  using Index = std::array<std::size_t, 3>;
  enum class Told { by_its_middle, by_all_around };

  [[nodiscard]] Place place(const Index& index) const;
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::size_t intervals(std::size_t number) const;
  [[nodiscard]] std::vector<Place> open() const;
  [[nodiscard]] const Doubt& doubt() const;
  bool halve(const std::vector<double>& enough, Told told);

  /// Values of a quantity along an axis through a crossing.
  [[nodiscard]] std::vector<double> line(std::size_t number, Index through, std::size_t quantity) const;

  /// Error of the interpolation of each cell.
  [[nodiscard]] std::vector<double> errors(std::size_t quantity) const;

  TableRange range_;
  std::array<NestedAxis, 3> axes_;
  std::map<Place, Values> values_{};
};

}  // namespace stoss
