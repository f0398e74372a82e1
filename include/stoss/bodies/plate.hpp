#pragma once

#include <vector>

#include "stoss/body/body.hpp"

namespace stoss {

/// A layer of a plate, in units in common with the others.
struct Layer {
  double thickness = 1.0;  ///< h; infinite of a block that everything above lies on
  double poisson = 0.0;    ///< ν, −0.95 … 0.4999
  double young = 1.0;      ///< E
  double density = 1.0;    ///< ρ
};

/// An elastic plate as a value, which a sphere meets: infinite sideways, free on both faces, of one material or of
/// layers that stick together. Thickness and material are relative to other bodies, in any consistent units.
struct Plate {
  double thickness = 1.0;  ///< h of the plate, or of its uppermost layer, which is met
  double poisson = 0.0;    ///< ν, −0.95 … 0.4999
  double young = 1.0;      ///< E
  double density = 1.0;    ///< ρ
  double loss_time = 0.0;  ///< η of all layers (docs/theory/loss.md), in the unit of time that goes with the others
  std::vector<Layer> below{};  ///< further layers, downwards

  /// Losses of the layers, from the top down, where these lose energy in different ways; empty: loss_time is of all.
  std::vector<MaterialLoss> losses{};
};

/// An elastic strip, which a disk meets: a plate in the plane.
struct Strip {
  double thickness = 1.0;  ///< h
  double poisson = 0.0;    ///< 2-D ν, −0.95 … 0.995 (plane strain: Material)
  double young = 1.0;      ///< 2-D E
  double density = 1.0;    ///< ρ
  double loss_time = 0.0;  ///< η
};

/// A plate with its waves up to a cutoff, for contacts of limited duration.
///
/// At each wave number k the plate is a sequence of undamped modes, the branches of Rayleigh and Lamb, and of all of
/// them the static answer is known exactly (docs/theory/plates.md). They move the surface as J₀(kr). Sums over k are
/// quadratures, good while the contact lasts; the plate has no translation and takes energy only as waves that run
/// away. Layers that lose energy in different ways have the moduli that they have in a contact of about the duration,
/// and each mode the losses of all by their shares in its energy. Its unit of length is that of the thickness; in
/// addition, c = √(E/ρ) and ρ of the uppermost layer are its units.
/// @param cutoff   highest frequency, above 0
/// @param duration longest contact, in its units of time, above 0
/// @throws InvalidInput outside these ranges, for a thickness, modulus or density that is not positive and finite (a
///         layer below all others may be infinitely thick), losses that are not one for each layer or stand beside
///         a loss_time, and where it would have more modes than are computed
[[nodiscard]] Body plate(const Plate& plate, double cutoff, double duration, const Poll& poll = {});

/// A strip for a disk: as a plate, with the shapes cos kx.
[[nodiscard]] Body strip(const Strip& strip, double cutoff, double duration, const Poll& poll = {});

/// Makes plates at any cutoff, which `RefinableContact` and `contact` adapt to the impact.
/// @throws InvalidInput as above
[[nodiscard]] BodyMaker plate(const Plate& plate);
[[nodiscard]] BodyMaker strip(const Strip& strip);

}  // namespace stoss
