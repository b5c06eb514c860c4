// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "dis/dis_settings.h"
#include "dis/earth.h"
#include "dis/pdu_codec.h"

namespace soarbox::dis {
namespace {

EntityState Soldier() {
  EntityState state;
  state.id = {1, 7, 12};
  state.force = 2;
  state.type = {3, 1, 225, 1, 2, 3, 4};
  state.alternative = {3, 1, 222, 1, 0, 0, 0};
  state.velocity = {1.5, -2, 0.25};
  state.position = {4286580.123456, 644375.5, 4672290.75};
  state.orientation = {0.5, -0.25, 3};
  state.appearance = 0x00030018;
  state.algorithm = DeadReckoning::kRvw;
  state.acceleration = {0, 0.5, 0};
  state.turn = {0, 0, 0.125};
  state.marking = "red-leader";
  state.capabilities = 5;
  return state;
}

Pdu RoundTrip(Body body) {
  Pdu pdu;
  pdu.exercise = 9;
  pdu.timestamp = 123456;
  pdu.body = std::move(body);
  const std::vector<std::byte> bytes = Encode(pdu);
  EXPECT_EQ(LengthOf(bytes), bytes.size());
  const auto read = Decode(bytes);
  EXPECT_TRUE(std::holds_alternative<Pdu>(read));
  return std::holds_alternative<Pdu>(read) ? std::get<Pdu>(read) : Pdu{};
}

TEST(Pdu, AnEntityStateReadsAsItWasWritten) {
  const EntityState state = Soldier();
  const Pdu read = RoundTrip(state);
  EXPECT_EQ(read.exercise, 9);
  EXPECT_EQ(read.timestamp, 123456u);
  const auto& back = std::get<EntityState>(read.body);
  EXPECT_EQ(back.id, state.id);
  EXPECT_EQ(back.force, state.force);
  EXPECT_EQ(back.type, state.type);
  EXPECT_EQ(back.alternative, state.alternative);
  EXPECT_EQ(back.velocity, state.velocity);
  EXPECT_EQ(back.position, state.position);
  EXPECT_EQ(back.orientation.psi, state.orientation.psi);
  EXPECT_EQ(back.appearance, state.appearance);
  EXPECT_EQ(back.algorithm, state.algorithm);
  EXPECT_EQ(back.acceleration, state.acceleration);
  EXPECT_EQ(back.turn, state.turn);
  EXPECT_EQ(back.marking, state.marking);
  EXPECT_EQ(back.capabilities, state.capabilities);
}

TEST(Pdu, HasTheLengthOfTheStandard) {
  EXPECT_EQ(Encode({.body = EntityState{}}).size(), 144u);
  EXPECT_EQ(Encode({.body = Fire{}}).size(), 96u);
  EXPECT_EQ(Encode({.body = Detonation{}}).size(), 104u);
  EXPECT_EQ(Encode({.body = Collision{}}).size(), 60u);
  Management order;
  EXPECT_EQ(Encode({.body = order}).size(), 32u);
  order.type = PduType::kStartResume;
  EXPECT_EQ(Encode({.body = order}).size(), 44u);
  order.type = PduType::kStopFreeze;
  EXPECT_EQ(Encode({.body = order}).size(), 40u);
}

TEST(Pdu, AShotAndItsHitReadAsTheyWereWritten) {
  Fire fire;
  fire.shooter = {1, 2, 3};
  fire.target = {4, 5, 6};
  fire.event = {1, 2, 77};
  fire.position = {1, 2, 3};
  fire.burst = {{2, 8, 225, 2, 1, 0, 0}, 1000, 100, 3, 600};
  fire.velocity = {10, 20, 30};
  fire.range_m = 42;
  const auto back = std::get<Fire>(RoundTrip(fire).body);
  EXPECT_EQ(back.shooter, fire.shooter);
  EXPECT_EQ(back.target, fire.target);
  EXPECT_EQ(back.event.number, 77);
  EXPECT_EQ(back.burst.munition, fire.burst.munition);
  EXPECT_EQ(back.burst.quantity, 3);
  EXPECT_EQ(back.range_m, 42);
  Detonation hit;
  hit.target = {4, 5, 6};
  hit.position = {-1, 5e6, 7};
  hit.result = 1;
  const auto hit_back = std::get<Detonation>(RoundTrip(hit).body);
  EXPECT_EQ(hit_back.position, hit.position);
  EXPECT_EQ(hit_back.result, 1);
}

TEST(Pdu, TextsOfAnyLengthKeepTheirPlaces) {
  Comment comment;
  comment.from = {1, 2, 3};
  comment.texts = {"", "a", "12345678", "enemy-seen at 3 4"};
  EXPECT_EQ(std::get<Comment>(RoundTrip(comment).body).texts, comment.texts);
}

TEST(Pdu, WhatIsDamagedIsRefusedWithAReason) {
  std::vector<std::byte> bytes = Encode({.body = Soldier()});
  const auto refusal = [](std::span<const std::byte> data) {
    const auto read = Decode(data);
    return std::holds_alternative<Refusal>(read) ? Name(std::get<Refusal>(read)) : std::string_view("taken");
  };
  EXPECT_EQ(refusal(std::span(bytes).first(143)), "too short");
  EXPECT_EQ(refusal(std::span(bytes).first(5)), "too short");
  EXPECT_EQ(refusal({}), "too short");
  std::vector<std::byte> other = bytes;
  other[0] = std::byte{5};
  EXPECT_EQ(refusal(other), "another version");
  other = bytes;
  other[2] = std::byte{67};
  EXPECT_EQ(refusal(other), "another kind");
  other = bytes;
  other[9] = std::byte{100};
  EXPECT_EQ(refusal(other), "wrong length");
  other = bytes;
  for (std::size_t i = 48; i < 56; ++i) other[i] = std::byte{0xFF};  // The position is NaN.
  EXPECT_EQ(refusal(other), "impossible contents");
}

TEST(Pdu, ACommentThatPromisesMoreThanItHasIsRefused) {
  std::vector<std::byte> bytes = Encode({.body = Comment{{1, 1, 1}, {}, {"hello"}}});
  for (std::size_t i = 28; i < 32; ++i) bytes[i] = std::byte{0xFF};
  EXPECT_TRUE(std::holds_alternative<Refusal>(Decode(bytes)));
}

// Expected values from the definition: the equator, a pole, and an arc of known length.
TEST(Earth, KnownPlaces) {
  EXPECT_NEAR(ToGeocentric({0, 0, 0}).x, 6378137.0, 1e-6);
  EXPECT_NEAR(ToGeocentric({0, 90, 10}).y, 6378147.0, 1e-6);
  EXPECT_NEAR(ToGeocentric({90, 0, 0}).z, 6356752.314245, 1e-5);
  // From a published worked example: 34.0 N, 117.333569 W, 251.702 m.
  const Vector place = ToGeocentric({34.0, -117.3335693, 251.702});
  EXPECT_NEAR(std::hypot(place.x, place.y, place.z), 6371645.8, 200);
}

TEST(Earth, APlaceComesBackToATenthOfAMillimetre) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> latitude(-90, 90), longitude(-180, 180), height(-1000, 100'000);
  for (int i = 0; i < 10'000; ++i) {
    const Geodetic place{latitude(random), longitude(random), height(random)};
    const Vector there = ToGeocentric(place);
    const Vector back = ToGeocentric(ToGeodetic(there));
    ASSERT_LT(std::sqrt(Dot(back - there, back - there)), 1e-4);
    ASSERT_NEAR(ToGeodetic(there).height_m, place.height_m, 1e-4);
  }
}

/// The local axes at a place, computed from differences along the meridian, the parallel and the normal, without our
/// formulas.
struct Axes {
  Vector east, north, up;
};
Axes AxesByDifferences(const Geodetic& at) {
  const auto unit = [](const Vector& v) { return v * (1 / std::sqrt(Dot(v, v))); };
  constexpr double kStep = 1e-4;
  const auto between = [&](Geodetic a, Geodetic b) { return unit(ToGeocentric(b) - ToGeocentric(a)); };
  return {between({at.latitude_deg, at.longitude_deg - kStep, at.height_m},
                  {at.latitude_deg, at.longitude_deg + kStep, at.height_m}),
          between({at.latitude_deg - kStep, at.longitude_deg, at.height_m},
                  {at.latitude_deg + kStep, at.longitude_deg, at.height_m}),
          between(at, {at.latitude_deg, at.longitude_deg, at.height_m + 1000})};
}

TEST(LocalFrame, IsRightToACentimetreWithinFiveKilometres) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> latitude(-85, 85), longitude(-180, 180), side(-5000, 5000), up(-50, 500);
  for (int i = 0; i < 1000; ++i) {
    const Geodetic anchor{latitude(random), longitude(random), up(random)};
    const LocalFrame frame(anchor);
    const Vector local{side(random), up(random), side(random)};
    const Vector there = frame.ToEarth(local);
    const Axes axes = AxesByDifferences(anchor);
    const Vector expected = ToGeocentric(anchor) + axes.east * local.x + axes.up * local.y - axes.north * local.z;
    ASSERT_LT(std::sqrt(Dot(there - expected, there - expected)), 0.01);
    const Vector back = frame.ToLocal(there);
    ASSERT_LT(std::sqrt(Dot(back - local, back - local)), 1e-6);
  }
}

TEST(LocalFrame, TheOrientationOfTheStandardLeadsBackToTheDirection) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> latitude(-85, 85), longitude(-180, 180), angle(-3.1, 3.1);
  for (int i = 0; i < 1000; ++i) {
    const LocalFrame frame({latitude(random), longitude(random), 100});
    const double heading = angle(random);
    const Vector forward{std::sin(heading), 0, std::cos(heading)};
    const Euler euler = frame.ToEuler(forward, {0, 1, 0});
    const Vector back = frame.ForwardOf(euler);
    ASSERT_LT(std::sqrt(Dot(back - forward, back - forward)), 1e-9);
    // The body's down axis points down, so the body is upright.
    const Vector down = frame.FromBodyAxes(euler, {0, 0, 1});
    ASSERT_NEAR(down.y, -1, 1e-9);
    // The right of a body that faces z is -x.
    const Vector right = frame.FromBodyAxes(euler, {0, 1, 0});
    ASSERT_NEAR(right.x, -std::cos(heading), 1e-9);
    ASSERT_NEAR(right.z, std::sin(heading), 1e-9);
  }
}

TEST(LocalFrame, OnTheEquatorNorthIsTheAxisOfTheEarth) {
  const LocalFrame frame({0, 0, 0});
  // -z is north, x east, y away from the centre.
  const Vector north = frame.TurnToEarth({0, 0, -1});
  EXPECT_NEAR(north.z, 1, 1e-12);
  EXPECT_NEAR(frame.TurnToEarth({1, 0, 0}).y, 1, 1e-12);
  EXPECT_NEAR(frame.TurnToEarth({0, 1, 0}).x, 1, 1e-12);
  // A body facing east there has psi = 90 degrees; level, with the right side to the south.
  const Euler east = frame.ToEuler({1, 0, 0}, {0, 1, 0});
  EXPECT_NEAR(east.psi, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(east.theta, 0, 1e-12);
}

TEST(Settings, TypesArePatterns) {
  const auto pattern = ParseTypePattern("3.1.*.1");
  ASSERT_TRUE(pattern);
  EXPECT_TRUE(pattern->Fits({3, 1, 225, 1, 9, 9, 9}));
  EXPECT_FALSE(pattern->Fits({3, 1, 225, 2, 0, 0, 0}));
  EXPECT_FALSE(ParseTypePattern("3.1.x"));
  EXPECT_FALSE(ParseTypePattern("300"));
  EXPECT_FALSE(ParseTypePattern("1.1.1.1.1.1.1.1"));
  EXPECT_FALSE(ParseTypePattern(""));
}

TEST(Settings, TheOptionNamesWhatIsWrong) {
  const auto good = ParseOption("239.1.2.3:3001,5,6,7", {});
  ASSERT_TRUE(good);
  EXPECT_EQ(good->address, "239.1.2.3");
  EXPECT_EQ(good->port, 3001);
  EXPECT_EQ(good->site, 5);
  EXPECT_EQ(good->application, 6);
  EXPECT_EQ(good->exercise, 7);
  for (const char* wrong : {"", "host", ":3000", "1.2.3.4:0", "1.2.3.4:x", "1.2.3.4:3000,", "1.2.3.4:3000,0",
                            "1.2.3.4:3000,1,2,300", "1.2.3.4:3000,1,2,3,4"})
    EXPECT_FALSE(ParseOption(wrong, {})) << wrong;
}

}  // namespace
}  // namespace soarbox::dis
