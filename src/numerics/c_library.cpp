// SPDX-License-Identifier: BSD-2-Clause
//
// The functions under their C names. A program that links this file uses them itself and exports them to the shared
// libraries that it loads, because the C library comes later in the search order. No header of the C library is
// included, because declarations differ between systems.
#include "numerics/functions.h"

#define SOARBOX_C extern "C" __attribute__((visibility("default")))

namespace numerics = soarbox::numerics;

SOARBOX_C double sin(double x) noexcept {
  return numerics::Sin(x);
}
SOARBOX_C double cos(double x) noexcept {
  return numerics::Cos(x);
}
SOARBOX_C double tan(double x) noexcept {
  return numerics::Tan(x);
}
SOARBOX_C double asin(double x) noexcept {
  return numerics::Asin(x);
}
SOARBOX_C double acos(double x) noexcept {
  return numerics::Acos(x);
}
SOARBOX_C double atan(double x) noexcept {
  return numerics::Atan(x);
}
SOARBOX_C double atan2(double y, double x) noexcept {
  return numerics::Atan2(y, x);
}
SOARBOX_C double sinh(double x) noexcept {
  return numerics::Sinh(x);
}
SOARBOX_C double cosh(double x) noexcept {
  return numerics::Cosh(x);
}
SOARBOX_C double tanh(double x) noexcept {
  return numerics::Tanh(x);
}
SOARBOX_C double exp(double x) noexcept {
  return numerics::Exp(x);
}
SOARBOX_C double exp2(double x) noexcept {
  return numerics::Pow(2.0, x);
}
SOARBOX_C double log(double x) noexcept {
  return numerics::Log(x);
}
SOARBOX_C double log2(double x) noexcept {
  return numerics::Log2(x);
}
SOARBOX_C double log10(double x) noexcept {
  return numerics::Log10(x);
}
SOARBOX_C double log1p(double x) noexcept {
  return numerics::Log1p(x);
}
SOARBOX_C double pow(double x, double y) noexcept {
  return numerics::Pow(x, y);
}
SOARBOX_C double hypot(double x, double y) noexcept {
  return numerics::Hypot(x, y);
}
// Compilers combine a sine and a cosine of the same angle.
SOARBOX_C void sincos(double x, double* sine, double* cosine) noexcept {
  *sine = numerics::Sin(x);
  *cosine = numerics::Cos(x);
}

SOARBOX_C float sinf(float x) noexcept {
  return numerics::Sin(x);
}
SOARBOX_C float cosf(float x) noexcept {
  return numerics::Cos(x);
}
SOARBOX_C float tanf(float x) noexcept {
  return numerics::Tan(x);
}
SOARBOX_C float asinf(float x) noexcept {
  return numerics::Asin(x);
}
SOARBOX_C float acosf(float x) noexcept {
  return numerics::Acos(x);
}
SOARBOX_C float atanf(float x) noexcept {
  return numerics::Atan(x);
}
SOARBOX_C float atan2f(float y, float x) noexcept {
  return numerics::Atan2(y, x);
}
SOARBOX_C float sinhf(float x) noexcept {
  return static_cast<float>(numerics::Sinh(static_cast<double>(x)));
}
SOARBOX_C float coshf(float x) noexcept {
  return static_cast<float>(numerics::Cosh(static_cast<double>(x)));
}
SOARBOX_C float tanhf(float x) noexcept {
  return static_cast<float>(numerics::Tanh(static_cast<double>(x)));
}
SOARBOX_C float expf(float x) noexcept {
  return numerics::Exp(x);
}
SOARBOX_C float exp2f(float x) noexcept {
  return numerics::Pow(2.0F, x);
}
SOARBOX_C float logf(float x) noexcept {
  return numerics::Log(x);
}
SOARBOX_C float log2f(float x) noexcept {
  return static_cast<float>(numerics::Log2(static_cast<double>(x)));
}
SOARBOX_C float log10f(float x) noexcept {
  return static_cast<float>(numerics::Log10(static_cast<double>(x)));
}
SOARBOX_C float log1pf(float x) noexcept {
  return static_cast<float>(numerics::Log1p(static_cast<double>(x)));
}
SOARBOX_C float powf(float x, float y) noexcept {
  return numerics::Pow(x, y);
}
SOARBOX_C float hypotf(float x, float y) noexcept {
  return static_cast<float>(numerics::Hypot(x, y));
}
SOARBOX_C void sincosf(float x, float* sine, float* cosine) noexcept {
  *sine = numerics::Sin(x);
  *cosine = numerics::Cos(x);
}

#undef SOARBOX_C
