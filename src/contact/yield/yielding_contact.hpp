#pragma once

#include <array>
#include <vector>

#include "contact/response.hpp"
#include "contact/yield/indentation.hpp"

namespace stoss {

/// A contact of which one body yields: all points move as one place, by the law of an indentation.
///
/// Far from the contact the bodies are elastic, and their modes carry waves away; near it the law holds, which has all
/// of the elasticity of two half-spaces. So what moves the place X = Σ w_i x_i is
///
///   X = δ(P) + (Σ_ij w_i W_ij w_j − 3/(5 E*b)) P,
///
/// with weights w_i of Hertz' pressure on a circle of radius b, 3/(5E*b) what half-spaces give way under it, and W the
/// compliance of the modes that are not kept, which follow at once. b is 1.5 times the widest contact, which modes of
/// shorter waves do not see: they take nothing from a force that varies as slowly (docs/theory/real_contact.md).
/// Friction feels Hertz' pressure on the contact as wide as it is, which is a model where one yields.
class YieldingContact final : public ContactResponse {
 public:
  YieldingContact(const Contact& contact, const ContactGrid& grid, double speed, double step, const Poll& poll);

  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] const std::vector<double>& spread(const std::vector<double>& force) override;
  [[nodiscard]] std::size_t extent() const override { return law_.force() > 0.0 ? force_.size() : 0; }
  [[nodiscard]] double half_width() const override { return law_.radius() / spacing_; }
  [[nodiscard]] bool overflows() const override { return law_.radius() > widest_; }
  [[nodiscard]] double stored_energy() const override { return law_.stored(); }
  [[nodiscard]] std::array<double, 2> dissipated_energy() const override;
  [[nodiscard]] std::array<double, 2> flow_energy() const override;
  [[nodiscard]] double pressed() const override { return law_.deepest(); }
  void press(double before) override { law_.press_before(before); }
  [[nodiscard]] double dent() const override { return law_.dent(); }
  [[nodiscard]] bool has_forgotten() const override { return law_.is_still(); }
  [[nodiscard]] double range() const override { return 0.0; }
  [[nodiscard]] double touch() const override { return 0.0; }
  [[nodiscard]] double start(double stride) const override;

 private:
  std::vector<double> weight_;  // w_i
  double recess_ = 0.0;         // Σ w_i of the recesses
  Indentation law_;
  double spacing_, widest_;
  double first_kick_;
  double first_share_;           // of the first body in what the material takes
  std::array<double, 2> flows_;  // shares of the bodies in what flow takes
  ContactPoints points_;
  std::vector<double> force_, spread_;
};

/// Half-width of the points over that of the contact.
inline constexpr double points_over_yielding_contact = 1.5;

}  // namespace stoss
