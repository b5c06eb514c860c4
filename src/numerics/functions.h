// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::numerics {

/// Mathematical functions that IEEE 754 does not define exactly, with the same bits on every machine.
///
/// C libraries differ from each other. Those of glibc for doubles also differ between processors with and without fused
/// multiply-add. c_library.cpp defines these functions under their C names (sin, sinf, ...), so that std::sin, Lua,
/// Bullet and Recast use them in all our programs.
///
/// Error: doubles 0.51 units in the last place (0.52 for Pow, if |y * log(x)| < 100), floats 0.501; numerics_test
/// compares millions of values with a reference of higher precision. Results below the smallest normal number may be
/// rounded twice. Special values (infinite, NaN, zeros with signs) are those of C's Annex F. errno and floating-point
/// flags are not set.
double Sin(double x);
double Cos(double x);
double Tan(double x);
double Asin(double x);
double Acos(double x);
double Atan(double x);
double Atan2(double y, double x);
double Sinh(double x);
double Cosh(double x);
double Tanh(double x);
double Exp(double x);
double Log(double x);
double Log2(double x);
double Log10(double x);
double Log1p(double x);
double Pow(double x, double y);
double Hypot(double x, double y);

float Sin(float x);
float Cos(float x);
float Tan(float x);
float Asin(float x);
float Acos(float x);
float Atan(float x);
float Atan2(float y, float x);
float Exp(float x);
float Log(float x);
float Pow(float x, float y);

}  // namespace soarbox::numerics
