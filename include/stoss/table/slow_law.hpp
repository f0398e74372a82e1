#pragma once

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/table/restitution_function.hpp"

/// Laws of slow impacts, for what lies below the range of a RestitutionFunction. The speed is that of approach, in
/// c = √(E/ρ) of the first body. A law says with its error what it leaves out: that bounds what was computed directly
/// in 95 % of all cases; an infinite error means that the law says nothing there.
namespace stoss {

/// Law of slow impacts of a sphere at a hard wall: 1 − ε² = c(ν)v, the mean of a wave that swings between 0 and twice
/// that (quasistatic::mean_loss_factor), with the swing as error. Takes 10 ns.
///
/// Of a lossy material the loss of Ting's law comes on top, with what viscous_loss adds to Hertz' contact. Takes 0.2
/// ms.
/// @throws InvalidInput for a sphere that is out of range; the law for speeds that lossy_impact refuses
[[nodiscard]] SlowLaw slow_law(const Sphere& sphere);

/// The same of a sphere that relaxes: the loss of Ting's law (quasistatic::relaxing_impact) with what viscous_loss adds
/// to Hertz' contact. Takes 4 to 40 ms.
/// @param relaxation times in the unit of loss times. @throws InvalidInput as above and as validate(Relaxation)
[[nodiscard]] SlowLaw slow_law(const Sphere& sphere, const Relaxation& relaxation);

/// Law of slow impacts of a disk at a hard wall: Rayleigh's estimate for its modes up to a frequency of 30 c/R. Takes
/// 0.1 ms, and the speeds of quasistatic::slow_impact.
///
/// Of a lossy material viscous_loss comes on top; a tenth to a fifth of it is the error that the damping of the modes
/// makes.
/// @throws InvalidInput for a disk that is out of range; the law for speeds that rayleigh refuses
[[nodiscard]] SlowLaw slow_law(const Disk& disk);

/// Law of slow impacts of two equal spheres: that of one at a wall at half the speed.
/// @throws InvalidInput for others, which have no law
/// @param relaxation of both
[[nodiscard]] SlowLaw slow_law(const Sphere& first, const Sphere& second, const Relaxation& relaxation = {});

/// Law of slow impacts of two equal disks: that of one at a wall at half the speed.
/// @throws InvalidInput for others, which have no law
[[nodiscard]] SlowLaw slow_law(const Disk& first, const Disk& second);

/// Law of slow impacts of a sphere on a half-space: what radiates, by half_space_radiation, and what the sphere keeps
/// as vibration, c(ν)v with the share of the sphere in the softness squared. Takes 10 µs.
/// @param rigid whether the sphere does not yield
/// @throws InvalidInput out of range, and for lossy materials, which have no law
[[nodiscard]] SlowLaw slow_law(const Sphere& sphere, const HalfSpace& half_space, bool rigid = false);

}  // namespace stoss
