// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

#include "numerics/functions.h"

namespace soarbox::numerics {
namespace {

using Function = double (*)(double, double);

template <double (*F)(double)>
double OfOne(double x, double) {
  return F(x);
}

const std::map<std::string, Function>& Functions() {
  static const std::map<std::string, Function> functions = {
      {"Sin", OfOne<Sin>},     {"Cos", OfOne<Cos>},     {"Tan", OfOne<Tan>},   {"Asin", OfOne<Asin>},
      {"Acos", OfOne<Acos>},   {"Atan", OfOne<Atan>},   {"Sinh", OfOne<Sinh>}, {"Cosh", OfOne<Cosh>},
      {"Tanh", OfOne<Tanh>},   {"Exp", OfOne<Exp>},     {"Log", OfOne<Log>},   {"Log2", OfOne<Log2>},
      {"Log10", OfOne<Log10>}, {"Log1p", OfOne<Log1p>}, {"Atan2", Atan2},      {"Pow", Pow},
      {"Hypot", Hypot}};
  return functions;
}

struct Known {
  const char* function;
  double x, y;
  double result;  ///< The correctly rounded result, computed with 2,000 bits.
};

// clang-format off
constexpr Known kKnown[] = {
    {"Sin", -0x1.c2fcf590aedecp+1, 0, 0x1.7d7cf3ab5a919p-2},
    {"Sin", -0x1.bee9be20d407ap+2, 0, -0x1.49c5fa951a62dp-1},
    {"Sin", 0x1.82646a8f739fcp+1, 0, 0x1.f62523f2c4d6fp-4},
    {"Sin", -0x1.a18aeda73d2dcp+19, 0, 0x1.ff83de3f3e76ap-1},
    {"Sin", 0x1.185402347c830p+16, 0, -0x1.244fc7bbc6a81p-1},
    {"Sin", -0x1.06538aa29bbfep+18, 0, 0x1.21362b42aab69p-2},
    {"Sin", 0x1.4202d0e57a44ap+62, 0, -0x1.b4e9711ea7638p-4},
    {"Sin", 0x1.601b918899d73p+65, 0, -0x1.237d6e38458c9p-1},
    {"Sin", 0x1.a0646d4b76185p+61, 0, 0x1.fdfee2a7cc91cp-1},
    {"Sin", 0x1.ee068b9d0dc15p+1021, 0, -0x1.f823ac6a23dc9p-2},
    {"Sin", 0x1.3e53eae6088cbp+1019, 0, -0x1.fe051de35e21cp-1},
    {"Sin", 0x1.9d5ff45737c47p+1019, 0, -0x1.7d2f163a67149p-4},
    {"Cos", -0x1.8276355a2b560p+0, 0, 0x1.f4dff6bef30b3p-5},
    {"Cos", 0x1.a25ee77a78fbcp+2, 0, 0x1.ef9743c4dff32p-1},
    {"Cos", -0x1.e18892c86875ep+2, 0, 0x1.4bd71bae7733ep-2},
    {"Cos", -0x1.0e464243e0f0cp+19, 0, 0x1.2f8a43769fc1ap-3},
    {"Cos", 0x1.f1c938ef929c8p+17, 0, -0x1.d13d12e5f79f2p-6},
    {"Cos", 0x1.b5373c5137304p+19, 0, 0x1.a54a9142ed5cep-2},
    {"Cos", 0x1.48ba8f99d44a3p+1022, 0, -0x1.87a8421447883p-1},
    {"Cos", 0x1.c3e9d4dd08f3cp+1021, 0, -0x1.ff1329987915cp-1},
    {"Cos", 0x1.160bf373f724cp+1023, 0, -0x1.3ae5f48ddf403p-2},
    {"Tan", -0x1.222fe4c37780dp+3, 0, 0x1.7d4533f2d29c5p-2},
    {"Tan", 0x1.cad6f1d54ed70p+2, 0, 0x1.399a5f41dd743p+0},
    {"Tan", -0x1.0d4cd43cf010ap+2, 0, -0x1.cf8d4bd026b51p+0},
    {"Tan", 0x1.134ed63b2bd78p+27, 0, 0x1.2c0660fc949a6p+1},
    {"Tan", 0x1.c1ada2b6b11eap+26, 0, 0x1.5709469052e35p+2},
    {"Tan", 0x1.2641d3feb65f0p+28, 0, 0x1.5a36affc617cfp-4},
    {"Asin", 0x1.43b6a0d74bdd4p-1, 0, 0x1.5e713344b5cc3p-1},
    {"Asin", -0x1.46efa9f2cf122p-1, 0, -0x1.629da796c32c5p-1},
    {"Asin", 0x1.4e3bf92474e68p-3, 0, 0x1.4fbc6c28e8303p-3},
    {"Acos", 0x1.1c7eaa301850cp-2, 0, 0x1.4a0d46b6ef9f0p+0},
    {"Acos", -0x1.05546fe70eca4p-2, 0, 0x1.d42fe7699339ep+0},
    {"Acos", 0x1.871f66d933900p-4, 0, 0x1.79a432319bd48p+0},
    {"Acos", 0x1.fff3b73ddc0f9p-1, 0, 0x1.c0a0f02eb76a6p-7},
    {"Acos", 0x1.fff3ac8b8e538p-1, 0, 0x1.c16418f89ff03p-7},
    {"Acos", 0x1.fff597a3ba5cbp-1, 0, 0x1.9cf1391c64c72p-7},
    {"Atan", 0x1.151827e6171d0p+0, 0, 0x1.a65f7a2d57918p-1},
    {"Atan", -0x1.bcdf74ab169b0p-2, 0, -0x1.a3ae3cd916d0bp-2},
    {"Atan", -0x1.1d784e669abccp+0, 0, -0x1.adf660c56df6dp-1},
    {"Atan", 0x1.0b617da578234p+14, 0, 0x1.921be0da2f20ap+0},
    {"Atan", -0x1.2498ff7043878p+13, 0, -0x1.9218b56d5ee20p+0},
    {"Atan", -0x1.38dd33856aabep+15, 0, -0x1.921e125306928p+0},
    {"Sinh", 0x1.e24fb424d0f48p-6, 0, 0x1.e26189a9630f7p-6},
    {"Sinh", 0x1.4608509fb5880p-6, 0, 0x1.460dd2d252606p-6},
    {"Sinh", -0x1.a345b3ef3c70dp-6, 0, -0x1.a3516b09bf6e9p-6},
    {"Sinh", 0x1.1dc97bf01e9c8p+2, 0, 0x1.5bc8fb6f18547p+5},
    {"Sinh", 0x1.8304af369f970p+0, 0, 0x1.141def57f9f9ap+1},
    {"Sinh", 0x1.6821ca793792cp+4, 0, 0x1.6336824ffa09ep+31},
    {"Sinh", 0x1.413931158bc58p+8, 0, 0x1.5846298f98a2cp+462},
    {"Sinh", -0x1.28e31ae56ea30p+8, 0, -0x1.3f09fb327ce98p+427},
    {"Sinh", 0x1.501f5529e7b30p+9, 0, 0x1.cb985b1857036p+968},
    {"Cosh", -0x1.8719c3be78fc4p-1, 0, 0x1.4e63efc2e39d9p+0},
    {"Cosh", -0x1.4f5e71ab8a168p-3, 0, 0x1.0370a7be6d3b6p+0},
    {"Cosh", 0x1.074ff3abc87c0p-1, 0, 0x1.229b61a211de2p+0},
    {"Cosh", -0x1.e738be26ad7ecp+8, 0, 0x1.e1ca382482152p+701},
    {"Cosh", -0x1.ee73fe467d400p+3, 0, 0x1.396fe7ec44145p+21},
    {"Cosh", -0x1.428e0f3dd2c5dp+9, 0, 0x1.9ef13f8be5201p+929},
    {"Tanh", 0x1.139ad80fe58c8p-6, 0, 0x1.1394309bd3f3fp-6},
    {"Tanh", 0x1.b17910724b3dcp-6, 0, 0x1.b15f2df6a1bfap-6},
    {"Tanh", 0x1.de9532866d0a8p-8, 0, 0x1.de9305012fb26p-8},
    {"Tanh", 0x1.e09c91c2efc0cp+1, 0, 0x1.ff707846012a8p-1},
    {"Tanh", -0x1.dcce6e13292d4p+0, 0, -0x1.e7e4071e613f7p-1},
    {"Tanh", 0x1.f3f4c5700e9ccp+0, 0, 0x1.ebcd031c94044p-1},
    {"Exp", 0x1.8289fcfe4c288p-3, 0, 0x1.352d92227d8f5p+0},
    {"Exp", 0x1.4740319802398p-3, 0, 0x1.2c5b174e4818cp+0},
    {"Exp", -0x1.66c413b996350p-4, 0, 0x1.d50fe96e4898ap-1},
    {"Exp", 0x1.dbf473d961198p+8, 0, 0x1.93dfe230c9587p+686},
    {"Exp", 0x1.3746da2c9ea3cp+9, 0, 0x1.1d03e3098e80dp+898},
    {"Exp", -0x1.22193f3824200p+5, 0, 0x1.9b6f4ab4dd83ap-53},
    {"Log", 0x1.a90eb28533330p+2, 0, 0x1.e4b201a463c6fp+0},
    {"Log", 0x1.36a0a1d3f1250p-1, 0, -0x1.ffb94b50905bap-2},
    {"Log", 0x1.c0f473e8c4c25p+2, 0, 0x1.f2b2b4c77154ep+0},
    {"Log", 0x1.00c0d8405eb0dp+0, 0, 0x1.811f847162d71p-9},
    {"Log", 0x1.02864f8aad0ddp+0, 0, 0x1.4192817fb1c23p-7},
    {"Log", 0x1.01a5f4089aef1p+0, 0, 0x1.a499c69b75834p-8},
    {"Log", 0x1.b329d40a88d89p+994, 0, 0x1.58c26966d880ep+9},
    {"Log", 0x1.26f2ef1016cebp+995, 0, 0x1.58e95a57b6510p+9},
    {"Log", 0x1.ff346b6cdbce7p+995, 0, 0x1.592fbfb0d05dap+9},
    {"Log2", 0x1.ce16b9680f700p-3, 0, -0x1.12f0ce2365ed4p+1},
    {"Log2", 0x1.277c27dc6fe7ap+2, 0, 0x1.1a7d0af477f1ap+1},
    {"Log2", 0x1.ae342f837e874p+0, 0, 0x1.7f6cc1cfa0796p-1},
    {"Log10", 0x1.2bc3e65dfb548p+0, 0, 0x1.18bec2789c23cp-4},
    {"Log10", 0x1.2dd8bc8ba728ep-1, 0, -0x1.d5fb83f26cc79p-3},
    {"Log10", 0x1.ebab4af6fe9b2p+2, 0, 0x1.c55f550c98f48p-1},
    {"Log1p", -0x1.7b8e3ca17d4f2p-2, 0, -0x1.da328085ce4f9p-2},
    {"Log1p", -0x1.027141cd11b06p-2, 0, -0x1.29d9223a549a9p-2},
    {"Log1p", -0x1.beab862a97108p-4, 0, -0x1.d8f43e230d4e9p-4},
    {"Log1p", 0x1.e6d488a344852p-9, 0, 0x1.e5eda807e8cd3p-9},
    {"Log1p", -0x1.12dec7f25f0bep-8, 0, -0x1.1372c2bb9c327p-8},
    {"Log1p", -0x1.0a6784177f990p-11, 0, -0x1.0a78d94cd52e7p-11},
    {"Log1p", 0x1.05fe4d2926fd1p+29, 0, 0x1.41fd954f99ad7p+4},
    {"Log1p", 0x1.a53af0938837bp+29, 0, 0x1.49969c819c8ebp+4},
    {"Log1p", 0x1.86a9beeeaf992p+29, 0, 0x1.48620afec06abp+4},
    {"Atan2", 0x1.d1e66e5808fe4p+1, -0x1.1b9efc4ef9fdcp+1, 0x1.0f0e8d849f218p+1},
    {"Atan2", -0x1.b1ae8c88a93c0p-1, -0x1.698bbaa587540p+0, -0x1.4cf90310237dbp+1},
    {"Atan2", 0x1.ebc44e3cdee00p+1, 0x1.24f2ae3275ca6p+2, 0x1.65842003c2443p-1},
    {"Atan2", -0x1.bed23cd2b8f28p+1, -0x1.9e70f987cad19p+1, -0x1.28c86b3870a90p+1},
    {"Pow", 0x1.28e7a0495cd7dp+1, -0x1.55546e9e11e5bp+1, 0x1.b275fe35a783fp-4},
    {"Pow", 0x1.36604b327ccbcp+2, 0x1.c84ff574b30e8p-1, 0x1.0566a9dc744bep+2},
    {"Pow", 0x1.5050cfed1be1dp+1, -0x1.3d614dd4588c3p+2, 0x1.103b461b6a27ap-7},
    {"Pow", 0x1.0c2031dac46c4p+2, -0x1.4eb5fa7cdc2a8p+0, 0x1.3ab0112ee8644p-3},
    {"Pow", 0x1.5190d00d105d0p+32, 0x1.21fb906a0a10ep+2, 0x1.bd820ab442e12p+146},
    {"Pow", 0x1.9b90f87b5c1a7p+32, 0x1.3d43b98092c20p-3, 0x1.0b7ee706053bap+5},
    {"Pow", 0x1.701d2cc6175dfp+32, 0x1.c3127c6cbb2a8p+0, 0x1.3cc7444964ebep+57},
    {"Pow", 0x1.01754b21e7392p+29, 0x1.ff66fa0b5b520p+1, 0x1.dcd2d68d7f95ap+115},
    {"Hypot", 0x1.665c67184d424p+1, 0x1.df607aece45b0p+1, 0x1.2b426826b5306p+2},
    {"Hypot", 0x1.7d4710797bc54p+1, -0x1.13828f409e230p+0, 0x1.95665d0d4fe67p+1},
    {"Hypot", -0x1.029d3b81e1b06p+0, -0x1.fb78f712f4d36p+1, 0x1.05d802ae29a86p+2},
    {"Hypot", 0x1.57c8028024428p+0, -0x1.18295120c0512p+2, 0x1.250c3bbc14ee3p+2},
    {"Hypot", -0x1.4ac6897af16e0p+996, -0x1.74c87ab97fec8p+1, 0x1.4ac6897af16e0p+996},
    {"Hypot", -0x1.022ddfa898758p+996, -0x1.9976703fc46c4p+0, 0x1.022ddfa898758p+996},
    {"Hypot", -0x1.5611b57458e19p+996, -0x1.3fd9c772a8459p+2, 0x1.5611b57458e19p+996},
    {"Hypot", -0x1.0a9e46b801e54p+996, -0x1.fe2027e82b0f2p+1, 0x1.0a9e46b801e54p+996},
};
// clang-format on

TEST(Numerics, ResultsAreThoseOfAReferenceOfHigherPrecision) {
  for (const auto& [name, x, y, result] : kKnown)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(Functions().at(name)(x, y)), std::bit_cast<std::uint64_t>(result))
        << name << "(" << x << ", " << y << ")";
}

/// Random numbers that are the same everywhere: a xorshift generator.
class Numbers {
 public:
  double Between(double low, double high) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return low + (high - low) * (static_cast<double>(state_ >> 11) * 0x1p-53);
  }

 private:
  std::uint64_t state_ = 88172645463325252ULL;
};

struct Sum {
  std::uint64_t hash = 14695981039346656037ULL;
  void Add(std::uint64_t bits) { hash = (hash ^ bits) * 1099511628211ULL; }
  void Add(double value) { Add(std::bit_cast<std::uint64_t>(value)); }
  void Add(float value) { Add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value))); }
};

TEST(Numerics, CompilersAndProcessorsAgreeToTheBit) {
  Numbers numbers;
  Sum doubles, floats;
  for (int i = 0; i < 100000; ++i) {
    const double angle = numbers.Between(-100, 100), ratio = numbers.Between(-1, 1), size = numbers.Between(0, 50);
    const double wide = angle * 1e20;
    for (const double value : {Sin(angle),  Cos(angle),   Tan(angle),          Sin(wide),        Asin(ratio),
                               Acos(ratio), Atan(angle),  Atan2(angle, ratio), Sinh(angle),      Cosh(angle),
                               Tanh(ratio), Exp(angle),   Log(size),           Log2(size),       Log10(size),
                               Log1p(size), Log1p(ratio), Pow(size, ratio),    Pow(size, angle), Hypot(angle, size)})
      doubles.Add(value);
    const auto a = static_cast<float>(angle), r = static_cast<float>(ratio), s = static_cast<float>(size);
    for (const float value : {Sin(a), Cos(a), Tan(a), Sin(a * 1e20F), Asin(r), Acos(r), Atan(a), Atan2(a, r), Exp(r),
                              Exp(a), Log(s), Pow(s, r)})
      floats.Add(value);
  }
  EXPECT_EQ(doubles.hash, 13904826555283739159ULL);
  EXPECT_EQ(floats.hash, 804262227115399895ULL);
}

// If long double has more bits than double, millions of values are compared with the C library.
#if __LDBL_MANT_DIG__ >= 64
double UnitsOff(double value, long double exact) {
  const auto nearest = static_cast<double>(exact);
  const double unit = std::nextafter(std::abs(nearest), std::numeric_limits<double>::infinity()) - std::abs(nearest);
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) / unit);
}

TEST(Numerics, DoublesAreWithinTheErrorThatIsStated) {
  Numbers numbers;
  std::map<std::string, double> worst;
  const auto note = [&](const char* name, double value, long double exact) {
    worst[name] = std::max(worst[name], UnitsOff(value, exact));
  };
  for (int i = 0; i < 200000; ++i) {
    const double angle = numbers.Between(-30, 30), ratio = numbers.Between(-1, 1), size = numbers.Between(0, 50);
    const long double a = angle, r = ratio, s = size;
    note("sin", Sin(angle), std::sin(a));
    note("cos", Cos(angle), std::cos(a));
    note("tan", Tan(angle), std::tan(a));
    note("asin", Asin(ratio), std::asin(r));
    note("acos", Acos(ratio), std::acos(r));
    note("atan", Atan(angle), std::atan(a));
    note("atan2", Atan2(angle, ratio), std::atan2(a, r));
    note("sinh", Sinh(angle), std::sinh(a));
    note("cosh", Cosh(angle), std::cosh(a));
    note("tanh", Tanh(ratio), std::tanh(r));
    note("exp", Exp(angle), std::exp(a));
    note("log", Log(size), std::log(s));
    note("log2", Log2(size), std::log2(s));
    note("log10", Log10(size), std::log10(s));
    note("log1p", Log1p(ratio), std::log1p(r));
    note("pow", Pow(size, ratio * 10), std::pow(s, static_cast<long double>(ratio * 10)));
    note("hypot", Hypot(angle, ratio), std::hypot(a, r));
  }
  // The reference has an error of up to a thousandth itself.
  for (const auto& [name, units] : worst) EXPECT_LT(units, 0.512) << name;
}

TEST(Numerics, FloatsAreWithinTheErrorThatIsStated) {
  Numbers numbers;
  double worst = 0;
  const auto note = [&](float value, double exact) {
    const auto nearest = static_cast<float>(exact);
    const double unit = std::nextafter(std::abs(nearest), std::numeric_limits<float>::infinity()) - std::abs(nearest);
    worst = std::max(worst, std::abs(value - exact) / unit);
  };
  for (int i = 0; i < 300000; ++i) {
    const auto angle = static_cast<float>(numbers.Between(-300, 300)),
               ratio = static_cast<float>(numbers.Between(-1, 1)), size = static_cast<float>(numbers.Between(0, 50));
    const double a = angle, r = ratio, s = size;
    note(Sin(angle), Sin(a));
    note(Cos(angle), Cos(a));
    note(Tan(angle), Tan(a));
    note(Asin(ratio), Asin(r));
    note(Acos(ratio), Acos(r));
    note(Atan(angle), Atan(a));
    note(Atan2(angle, ratio), Atan2(a, r));
    note(Exp(ratio), Exp(r));
    note(Log(size), Log(s));
    note(Pow(size, ratio), Pow(s, r));
  }
  EXPECT_LT(worst, 0.501);
}
#endif

TEST(Numerics, SpecialValuesAreThoseOfC) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [name, function] : Functions()) {
    EXPECT_TRUE(std::isnan(function(kNan, 2))) << name;
  }
  for (const double x : {kInfinity, -kInfinity}) {
    for (const char* name : {"Sin", "Cos", "Tan", "Asin", "Acos"})
      EXPECT_TRUE(std::isnan(Functions().at(name)(x, 0))) << name;
    EXPECT_EQ(Sinh(x), x);
    EXPECT_EQ(Tanh(x), x > 0 ? 1 : -1);
    EXPECT_EQ(Cosh(x), kInfinity);
    EXPECT_EQ(Exp(x), x > 0 ? kInfinity : 0);
    EXPECT_DOUBLE_EQ(Atan(x), x > 0 ? 1.5707963267948966 : -1.5707963267948966);
  }
  for (const char* name : {"Sin", "Tan", "Asin", "Atan", "Sinh", "Tanh", "Log1p"})
    EXPECT_TRUE(std::signbit(Functions().at(name)(-0.0, 1))) << name;
  EXPECT_EQ(Log(0.0), -kInfinity);
  EXPECT_TRUE(std::isnan(Log(-1.0)));
  EXPECT_EQ(Log(1.0), 0);
  EXPECT_EQ(Log2(8.0), 3);
  EXPECT_EQ(Log10(1000.0), 3);
  EXPECT_EQ(Log(kInfinity), kInfinity);
  EXPECT_EQ(Log1p(-1.0), -kInfinity);
  EXPECT_EQ(Acos(1.0), 0);
  EXPECT_EQ(Exp(0.0), 1);
  EXPECT_EQ(Exp(1000.0), kInfinity);
  EXPECT_EQ(Exp(-1000.0), 0);
  EXPECT_EQ(Exp(-745.0), 0x1p-1074);
  EXPECT_EQ(Pow(kNan, 0.0), 1);
  EXPECT_EQ(Pow(1.0, kNan), 1);
  EXPECT_EQ(Pow(-2.0, 3.0), -8);
  EXPECT_EQ(Pow(-2.0, -2.0), 0.25);
  EXPECT_TRUE(std::isnan(Pow(-2.0, 0.5)));
  EXPECT_EQ(Pow(-0.0, 3.0), 0);
  EXPECT_TRUE(std::signbit(Pow(-0.0, 3.0)));
  EXPECT_EQ(Pow(-0.0, -3.0), -kInfinity);
  EXPECT_EQ(Pow(0.0, -2.0), kInfinity);
  EXPECT_EQ(Pow(-1.0, kInfinity), 1);
  EXPECT_EQ(Pow(0.5, kInfinity), 0);
  EXPECT_EQ(Pow(-kInfinity, 3.0), -kInfinity);
  EXPECT_EQ(Pow(-kInfinity, -2.0), 0);
  EXPECT_EQ(Pow(2.0, 1023.0), 0x1p1023);
  EXPECT_EQ(Pow(2.0, -1074.0), 0x1p-1074);
  EXPECT_EQ(Pow(10.0, 400.0), kInfinity);
  EXPECT_DOUBLE_EQ(Atan2(0.0, -1.0), 3.1415926535897931);
  EXPECT_DOUBLE_EQ(Atan2(-0.0, -1.0), -3.1415926535897931);
  EXPECT_EQ(Atan2(0.0, 0.0), 0);
  EXPECT_EQ(Atan2(1e-300, 1e300), 0);
  EXPECT_DOUBLE_EQ(Atan2(kInfinity, -kInfinity), 2.3561944901923448);
  EXPECT_EQ(Hypot(3.0, 4.0), 5);
  EXPECT_EQ(Hypot(kNan, -kInfinity), kInfinity);
  EXPECT_EQ(Hypot(3e307, 4e307), 5e307);
}

TEST(Numerics, ProgramsCallThemByTheirNamesInC) {
  volatile double x = 0.7;
  volatile float y = 0.7F;
  EXPECT_EQ(std::sin(x), Sin(static_cast<double>(x)));
  EXPECT_EQ(std::sinh(x), Sinh(static_cast<double>(x)));
  EXPECT_EQ(std::atan2(y, y + 1), Atan2(static_cast<float>(y), y + 1));
  // Values for which glibc's functions do not return the nearest double.
  volatile double hard = 0.05;
  EXPECT_EQ(std::tanh(hard), Tanh(0.05));
}

}  // namespace
}  // namespace soarbox::numerics
