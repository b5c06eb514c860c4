// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "picture/drawing.h"
#include "picture/gif.h"
#include "picture/jpeg_reader.h"
#include "picture/png.h"
#include "picture/png_reader.h"
#include "picture/stroke_font.h"

namespace soarbox::picture {
namespace {

/// An image with many colours, whose pixels are not predictable from neighbours.
Image Colourful(int width, int height, unsigned shift = 0) {
  Image image(width, height);
  unsigned state = 1;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    state = state * 1664525 + 1013904223;
    image.rgb[i] = static_cast<std::uint8_t>(i % 7 < 5 ? (i * 3 + shift) & 0xff : state >> 24);
  }
  return image;
}

std::uint32_t NumberAt(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return number;
}

/// Decodes a PNG written by PngOf; checks the checksums of its chunks.
Image ReadPng(const std::string& file) {
  EXPECT_EQ(file.substr(0, 8), "\x89PNG\r\n\x1a\n");
  std::string packed;
  Image image;
  for (std::size_t at = 8; at < file.size();) {
    const std::uint32_t size = NumberAt(file, at);
    const std::string kind = file.substr(at + 4, 4), content = file.substr(at + 8, size);
    const std::string summed = kind + content;
    EXPECT_EQ(crc32(0, reinterpret_cast<const Bytef*>(summed.data()), static_cast<uInt>(summed.size())),
              NumberAt(file, at + 8 + size));
    if (kind == "IHDR") image = Image(static_cast<int>(NumberAt(content, 0)), static_cast<int>(NumberAt(content, 4)));
    if (kind == "IDAT") packed += content;
    at += size + 12;
  }
  const std::size_t row = 3 * static_cast<std::size_t>(image.width);
  std::string rows((row + 1) * static_cast<std::size_t>(image.height), '\0');
  uLongf size = rows.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                       packed.size()),
            Z_OK);
  EXPECT_EQ(size, rows.size());
  const auto at = [&](std::size_t y, std::size_t i) { return static_cast<int>(image.rgb[y * row + i]); };
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    EXPECT_EQ(rows[y * (row + 1)], 4);
    for (std::size_t i = 0; i < row; ++i) {
      const int a = i >= 3 ? at(y, i - 3) : 0, b = y > 0 ? at(y - 1, i) : 0, c = i >= 3 && y > 0 ? at(y - 1, i - 3) : 0;
      const int guess = a + b - c, da = std::abs(guess - a), db = std::abs(guess - b), dc = std::abs(guess - c);
      const int predicted = da <= db && da <= dc ? a : db <= dc ? b : c;
      image.rgb[y * row + i] =
          static_cast<std::uint8_t>(predicted + static_cast<unsigned char>(rows[y * (row + 1) + 1 + i]));
    }
  }
  return image;
}

/// Decodes the pictures of a GIF, as a reader of the format draws them.
std::vector<Image> ReadGif(const std::string& file, int width, int height) {
  std::vector<Image> pictures;
  const auto byte = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(file.at(at))); };
  Image shown(width, height, {0, 0, 0, 1});
  std::size_t at = 13;
  int transparent = -1;
  while (byte(at) != ';') {
    if (byte(at) == 0x21) {
      const bool is_control = byte(at + 1) == 0xf9;
      if (is_control) transparent = (byte(at + 3) & 1) != 0 ? static_cast<int>(byte(at + 6)) : -1;
      at += 2;
      while (byte(at) != 0) at += byte(at) + 1;
      ++at;
      continue;
    }
    EXPECT_EQ(byte(at), 0x2cu);
    const std::size_t palette = at + 10;
    std::size_t blocks = palette + 256 * 3 + 1;
    std::string packed;
    for (; byte(blocks) != 0; blocks += byte(blocks) + 1) packed += file.substr(blocks + 1, byte(blocks));
    at = blocks + 1;
    std::vector<std::string> table;
    std::size_t bit = 0, pixel = 0;
    unsigned bits = 9;
    std::string before;
    while (true) {
      unsigned code = 0;
      for (unsigned i = 0; i < bits; ++i, ++bit)
        code |= (static_cast<unsigned>(static_cast<unsigned char>(packed.at(bit / 8))) >> (bit % 8) & 1) << i;
      if (code == 257) break;
      if (code == 256) {
        table.clear();
        for (int i = 0; i < 258; ++i) table.emplace_back(1, static_cast<char>(i));
        bits = 9;
        before.clear();
        continue;
      }
      std::string entry = code < table.size() ? table[code] : before + before[0];
      if (!before.empty() && table.size() < 4096) table.push_back(before + entry[0]);
      if (table.size() == 1u << bits && bits < 12) ++bits;
      for (const char c : entry) {
        const auto number = static_cast<unsigned char>(c);
        if (number != transparent)
          for (std::size_t i = 0; i < 3; ++i)
            shown.rgb.at(3 * pixel + i) = static_cast<std::uint8_t>(byte(palette + std::size_t{3} * number + i));
        ++pixel;
      }
      before = std::move(entry);
    }
    EXPECT_EQ(pixel, static_cast<std::size_t>(width * height));
    pictures.push_back(shown);
  }
  return pictures;
}

int FarthestApart(const Image& a, const Image& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) most = std::max(most, std::abs(a.rgb[i] - b.rgb[i]));
  return most;
}

TEST(Picture, APngHoldsThePixelsOfTheImage) {
  for (const int width : {1, 2, 37, 200}) {
    const Image image = Colourful(width, 23);
    EXPECT_EQ(ReadPng(PngOf(image)).rgb, image.rgb) << width;
  }
}

TEST(Picture, AGifShowsThePicturesOneAfterTheOther) {
  constexpr int kWidth = 320, kHeight = 200;
  // Few colours are kept exactly; unchanged pixels stay the same.
  Image first(kWidth, kHeight, {0.2f, 0.4f, 0.6f, 1});
  first.Box(20, 30, 100, 50, {1, 0, 0, 1});
  Image second = first;
  second.Box(60, 10, 10, 120, {0, 1, 0, 1});
  GifMaker maker(kWidth, kHeight, 10);
  std::string file;
  for (const Image* image : {&first, &second, &second}) file += maker.Add(*image);
  file += GifMaker::End();
  const std::vector<Image> shown = ReadGif(file, kWidth, kHeight);
  ASSERT_EQ(shown.size(), 3u);
  EXPECT_EQ(FarthestApart(shown[0], first), 0);
  EXPECT_EQ(FarthestApart(shown[1], second), 0);
  EXPECT_EQ(FarthestApart(shown[2], second), 0);
}

TEST(Picture, AGifOfManyColoursStaysNearThemAndFillsTheTableOfCodesAgainAndAgain) {
  constexpr int kWidth = 320, kHeight = 200;
  Image smooth(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      smooth.Mix(x, y, {static_cast<float>(x) / kWidth, static_cast<float>(y) / kHeight, 0.5f, 1}, 1);
  const Image wild = Colourful(kWidth, kHeight);
  GifMaker maker(kWidth, kHeight, 10);
  std::string file;
  for (const Image* image : std::initializer_list<const Image*>{&smooth, &wild}) file += maker.Add(*image);
  const std::vector<Image> shown = ReadGif(file + GifMaker::End(), kWidth, kHeight);
  ASSERT_EQ(shown.size(), 2u);
  EXPECT_LT(FarthestApart(shown[0], smooth), 24);
  EXPECT_LT(FarthestApart(shown[1], wild), 128);
}

TEST(Picture, ADrawingIsWrittenAsSvgWhoseTextsAreTexts) {
  Drawing drawing;
  drawing.title = "a < b & \"c\"";
  drawing.Line(0, 0, 10, 20.5f, 1, {1, 0, 0, 0.5f});
  drawing.shapes.emplace_back(Drawing::Text{5, 6, 12, Drawing::Anchor::kEnd, {0, 0, 0, 1}, "<script>\x01"});
  const std::string svg = SvgOf(drawing);
  EXPECT_NE(svg.find("<title>a &lt; b &amp; &quot;c&quot;</title>"), std::string::npos) << svg;
  EXPECT_NE(svg.find("stroke=\"#ff0000\" stroke-width=\"1\" stroke-opacity=\"0.5\" points=\"0,0 10,20.5\""),
            std::string::npos)
      << svg;
  EXPECT_NE(svg.find("text-anchor=\"end\" fill=\"#000000\">&lt;script&gt;</text>"), std::string::npos) << svg;
}

TEST(Picture, ADrawingAsPixelsHasItsShapesWhereTheyAre) {
  Drawing drawing;
  drawing.width = 100;
  drawing.height = 50;
  drawing.shapes.emplace_back(Drawing::Box{10, 10, 20, 20, {0, 0, 1, 1}});
  drawing.shapes.emplace_back(Drawing::Disc{70, 25, 8, {1, 0, 0, 1}});
  const Image image = ImageOf(drawing, 2);
  ASSERT_EQ(image.width, 200);
  const auto is = [&](int x, int y, int r, int g, int b) {
    const std::uint8_t* const pixel = image.At(x, y);
    return pixel[0] == r && pixel[1] == g && pixel[2] == b;
  };
  EXPECT_TRUE(is(40, 40, 0, 0, 255));
  EXPECT_TRUE(is(5, 5, 255, 255, 255));
  EXPECT_TRUE(is(140, 50, 255, 0, 0));
  EXPECT_TRUE(is(160, 50, 255, 255, 255));
}

TEST(Picture, EachCharacterHasStrokesOfItsOwnWithinItsWidth) {
  std::vector<std::vector<std::uint8_t>> seen;
  for (char c = '!'; c <= '~'; ++c) {
    Image image(60, 60);
    const std::string text(1, c);
    WriteText(image, 10, 40, 20, text, {0, 0, 0, 1}, 2);
    int right = 0, dark = 0;
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 60; ++x) {
        if (image.At(x, y)[0] > 100) continue;
        ++dark;
        right = std::max(right, x);
        EXPECT_GE(x, 8) << c;
      }
    }
    EXPECT_GT(dark, 4) << c;
    EXPECT_LE(static_cast<float>(right), 12 + TextWidth(text, 20)) << c;
    EXPECT_EQ(std::ranges::find(seen, image.rgb), seen.end()) << c << " looks like another one";
    seen.push_back(image.rgb);
  }
}

TEST(Png, WhatIsWrittenReadsAsTheSamePixels) {
  Image image(5, 3, {0.2f, 0.4f, 0.6f, 1});
  image.At(4, 2)[0] = 255;
  const std::string file = PngOf(image);
  const PngRead read = picture::ReadPng(std::string_view(file));
  ASSERT_EQ(read.problem, "");
  ASSERT_EQ(read.pixels.width, 5);
  ASSERT_EQ(read.pixels.height, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x)
      for (std::size_t channel = 0; channel < 4; ++channel)
        EXPECT_EQ(read.pixels.rgba[4 * static_cast<std::size_t>(5 * y + x) + channel],
                  channel == 3 ? 255 : image.At(x, y)[channel]);
  for (std::size_t length = 0; length + 12 < file.size(); ++length)
    EXPECT_NE(picture::ReadPng(std::string_view(file).substr(0, length)).problem, "") << length;
}

TEST(Png, SaysWhyAFileIsNotRead) {
  std::string file = PngOf(Image(2, 2));
  EXPECT_EQ(picture::ReadPng(std::string_view()).problem, "this is not a PNG file");
  const auto with = [&](std::size_t at, char value) {
    std::string changed = file;
    changed[at] = value;
    return picture::ReadPng(std::string_view(changed)).problem;
  };
  EXPECT_EQ(with(24, 16), "16 bits per channel are not read: save it with 8");
  EXPECT_EQ(with(28, 1), "interlaced images are not read: save it without interlacing");
  EXPECT_EQ(with(16, 1), "an image has 1 to 4096 pixels on each side");
  EXPECT_EQ(with(19, 3), "its pixels are damaged");
  EXPECT_EQ(with(25, 7), "its colour type is unknown");
  EXPECT_EQ(with(25, 3), "it has no palette");
}

std::string JpegFile(const std::string& name) {
  std::ifstream in(std::string(SOARBOX_SOURCE_DIR) + "/tests/picture/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Another program wrote these files. Red increases to the right, green downwards, and blue is a wave.
TEST(Jpeg, ReadsBaselineProgressiveAndRestartedFiles) {
  for (const char* name : {"baseline.jpg", "progressive.jpg", "restarts.jpg"}) {
    const JpegRead read = ReadJpeg(JpegFile(name));
    ASSERT_EQ(read.problem, "") << name;
    ASSERT_EQ(read.pixels.width, 37);
    ASSERT_EQ(read.pixels.height, 21);
    for (int y = 0; y < 21; ++y) {
      for (int x = 0; x < 37; ++x) {
        const std::uint8_t* pixel = read.pixels.rgba.data() + 4 * (37 * y + x);
        // Two of the three components have a quarter of the samples.
        EXPECT_NEAR(pixel[0], x * 255 / 37, 16) << name << ' ' << x << ' ' << y;
        EXPECT_NEAR(pixel[1], y * 255 / 21, 16) << name << ' ' << x << ' ' << y;
        EXPECT_NEAR(pixel[2], 128 + 100 * std::sin(x * 0.2) * std::cos(y * 0.15), 24) << name << ' ' << x << ' ' << y;
        EXPECT_EQ(pixel[3], 255);
      }
    }
  }
  // All three files contain the same picture.
  EXPECT_EQ(ReadJpeg(JpegFile("baseline.jpg")).pixels.rgba, ReadJpeg(JpegFile("progressive.jpg")).pixels.rgba);
  EXPECT_EQ(ReadJpeg(JpegFile("baseline.jpg")).pixels.rgba, ReadJpeg(JpegFile("restarts.jpg")).pixels.rgba);
}

TEST(Jpeg, ReadsGrayFiles) {
  const JpegRead read = ReadJpeg(JpegFile("gray_progressive.jpg"));
  ASSERT_EQ(read.problem, "");
  ASSERT_EQ(read.pixels.rgba.size(), 4u * 50 * 60);
  for (std::size_t i = 0; i < read.pixels.rgba.size(); i += 4) {
    EXPECT_EQ(read.pixels.rgba[i], read.pixels.rgba[i + 1]);
    EXPECT_EQ(read.pixels.rgba[i], read.pixels.rgba[i + 2]);
  }
}

TEST(Jpeg, SaysWhyAFileIsNotRead) {
  const std::string file = JpegFile("baseline.jpg");
  EXPECT_EQ(ReadJpeg("").problem, "this is not a JPEG file");
  EXPECT_EQ(ReadJpeg(file.substr(0, 100)).problem, "the file ends within a segment");
  EXPECT_EQ(ReadJpeg(file.substr(0, 20)).problem, "the file ends before its picture");
  EXPECT_EQ(ReadJpeg(file.substr(0, file.size() - 150)).problem, "the file ends within its picture");
  const std::size_t frame = file.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  const auto with = [&](std::size_t at, char value) {
    std::string changed = file;
    changed[frame + at] = value;
    return ReadJpeg(changed).problem;
  };
  EXPECT_EQ(with(1, '\xc9'),
            "it is lossless or arithmetically coded, which is not read: save it as an ordinary JPEG or as PNG");
  EXPECT_EQ(with(4, 12), "it does not have 8 bits per channel");
  EXPECT_EQ(with(5, 99), "it has no pixels, or more than 8 million, or more than 4096 on a side");
  EXPECT_EQ(with(9, 4), "it is neither gray nor of three colours (CMYK is not read): save it as RGB");
}

}  // namespace
}  // namespace soarbox::picture
