// SPDX-License-Identifier: BSD-2-Clause
#include "dis/earth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soarbox::dis {
namespace {

// WGS 84: half the equatorial axis, and the flattening.
constexpr double kEquator_m = 6378137.0, kFlattening = 1 / 298.257223563;
constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);
constexpr double kRadians = std::numbers::pi / 180;

/// Distance from the surface along the normal to the axis of the earth.
double NormalLength(double sine_of_latitude) {
  return kEquator_m / std::sqrt(1 - kEccentricity2 * sine_of_latitude * sine_of_latitude);
}

/// The axes of a body in geocentric coordinates.
struct Axes {
  Vector forward, right, down;
};

Axes AxesOf(const Euler& euler) {
  const double cos_psi = std::cos(euler.psi), sin_psi = std::sin(euler.psi);
  const double cos_theta = std::cos(euler.theta), sin_theta = std::sin(euler.theta);
  const double cos_phi = std::cos(euler.phi), sin_phi = std::sin(euler.phi);
  Axes axes;
  axes.forward = {cos_theta * cos_psi, cos_theta * sin_psi, -sin_theta};
  // Before the roll, a body's right is level; rolling by phi moves right towards down.
  const Vector level_right = {-sin_psi, cos_psi, 0};
  const Vector level_down = Cross(axes.forward, level_right);
  axes.right = level_right * cos_phi + level_down * sin_phi;
  axes.down = level_down * cos_phi - level_right * sin_phi;
  return axes;
}

}  // namespace

Vector ToGeocentric(const Geodetic& place) {
  const double latitude = place.latitude_deg * kRadians, longitude = place.longitude_deg * kRadians;
  const double sine = std::sin(latitude), normal_m = NormalLength(sine);
  const double from_axis_m = (normal_m + place.height_m) * std::cos(latitude);
  return {from_axis_m * std::cos(longitude), from_axis_m * std::sin(longitude),
          (normal_m * (1 - kEccentricity2) + place.height_m) * sine};
}

Geodetic ToGeodetic(const Vector& place) {
  const double from_axis_m = std::hypot(place.x, place.y);
  double latitude = std::atan2(place.z, from_axis_m * (1 - kEccentricity2));
  for (int i = 0; i < 6; ++i) {
    const double sine = std::sin(latitude);
    latitude = std::atan2(place.z + kEccentricity2 * NormalLength(sine) * sine, from_axis_m);
  }
  const double sine = std::sin(latitude), cosine = std::cos(latitude);
  // The height along the normal; the sum is valid for every latitude.
  const double surface_m = kEquator_m * std::sqrt(1 - kEccentricity2 * sine * sine);
  const double height_m = from_axis_m * cosine + place.z * sine - surface_m;
  return {latitude / kRadians, std::atan2(place.y, place.x) / kRadians, height_m};
}

LocalFrame::LocalFrame(const Geodetic& anchor) : anchor_(anchor), origin_(ToGeocentric(anchor)) {
  const double latitude = anchor.latitude_deg * kRadians, longitude = anchor.longitude_deg * kRadians;
  east_ = {-std::sin(longitude), std::cos(longitude), 0};
  up_ = {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
  north_ = Cross(up_, east_);
}

Vector LocalFrame::TurnToEarth(const Vector& local) const {
  return east_ * local.x + up_ * local.y - north_ * local.z;
}

Vector LocalFrame::TurnToLocal(const Vector& geocentric) const {
  return {Dot(geocentric, east_), Dot(geocentric, up_), -Dot(geocentric, north_)};
}

Vector LocalFrame::ToEarth(const Vector& local) const {
  return origin_ + TurnToEarth(local);
}

Vector LocalFrame::ToLocal(const Vector& geocentric) const {
  return TurnToLocal(geocentric - origin_);
}

Euler LocalFrame::ToEuler(const Vector& forward, const Vector& up) const {
  const Vector ahead = TurnToEarth(forward), down = TurnToEarth(up) * -1;
  const Vector right = Cross(down, ahead);
  Euler euler;
  euler.psi = std::atan2(ahead.y, ahead.x);
  euler.theta = std::asin(std::clamp(-ahead.z, -1.0, 1.0));
  euler.phi = std::atan2(right.z, down.z);
  return euler;
}

Vector LocalFrame::ForwardOf(const Euler& euler) const {
  return TurnToLocal(AxesOf(euler).forward);
}

Vector LocalFrame::FromBodyAxes(const Euler& euler, const Vector& in_body) const {
  const Axes axes = AxesOf(euler);
  return TurnToLocal(axes.forward * in_body.x + axes.right * in_body.y + axes.down * in_body.z);
}

}  // namespace soarbox::dis
