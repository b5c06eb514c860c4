// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include "sml/wire/framing.h"
#include "sml/wire/input_wme.h"
#include "sml/wire/message.h"
#include "sml/wire/xml_reader.h"
#include "sml/wire/xml_writer.h"

namespace soarbox::wire {
namespace {

TEST(Message, ACallIsWrittenByteForByteAsTheProtocolFixesIt) {
  Message call = MakeCall("version");
  call.id = "0";
  EXPECT_EQ(ToDocument(call),
            R"(<sml doctype="call" id="0" smlversion="9.6.3"><command name="version"></command></sml>)");
  EXPECT_EQ(Frame(ToDocument(call)).substr(0, 4), std::string("\0\0\0\x56", 4));

  Message response = MakeResponse("0");
  response.id = "0";
  AddRawResult(response, "9.6.3");
  EXPECT_EQ(ToDocument(response),
            R"(<sml ack="0" doctype="response" id="0" smlversion="9.6.3"><result output="raw">9.6.3</result></sml>)");
}

TEST(Message, AFailedCallGivesItsTextTwice) {
  Message response = MakeResponse("19");
  response.id = "19";
  AddError(response, "Command bogus is not recognized by the kernel");
  EXPECT_EQ(
      ToDocument(response),
      R"(<sml ack="19" doctype="response" id="19" smlversion="9.6.3"><result output="raw">Command bogus is not recognized by the kernel</result>)"
      R"(<error>Command bogus is not recognized by the kernel</error></sml>)");
}

TEST(XmlWriter, AttributesAreSortedAndFiveCharactersEscaped) {
  Element wme("wme");
  wme.Set("value", "a <b> & \"c\" 'd'").Set("action", "add").Set("tag", "-134217732").Set("id", "p7");
  EXPECT_EQ(
      ToXml(wme),
      R"(<wme action="add" id="p7" tag="-134217732" value="a &lt;b&gt; &amp; &quot;c&quot; &apos;d&apos;"></wme>)");
}

TEST(XmlReader, ReadsBackWhatTheWriterWrote) {
  Element element("a");
  element.Set("k", "\n\t<&>\"'");
  element.Add("b").text = "line 1\nline 2 ";
  element.Add("c");
  const Result<Element> read = ReadXml(ToXml(element));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(ToXml(read.value()), ToXml(element));
}

TEST(XmlReader, TakesHeadersCommentsSelfClosingTagsSpacesAndReferences) {
  const Result<Element> read =
      ReadXml("<?xml version='1.0'?>\n<!-- x -->\n<a  k = 'v' >\n <b/>\n <c>&#65;&#x42;<!-- y --></c>\n</a>\n");
  ASSERT_TRUE(read.ok()) << Format(read.error());
  EXPECT_EQ(ToXml(read.value()), R"(<a k="v"><b></b><c>AB</c></a>)");
}

TEST(XmlReader, KeepsTextThatIsOnlySpaceInAnElementWithoutChildren) {
  EXPECT_EQ(ReadXml("<a> </a>").value().text, " ");
  EXPECT_EQ(ReadXml("<a> <b></b> </a>").value().text, "");
}

TEST(XmlReader, RefusesEveryTruncationOfADocument) {
  const std::string document =
      R"(<?xml version="1.0"?><sml id="1"><!--c--><command name="x&amp;y"><arg param="p">t&lt;</arg></command></sml>)";
  for (std::size_t length = 0; length < document.size(); ++length) {
    EXPECT_FALSE(ReadXml(document.substr(0, length)).ok()) << document.substr(0, length);
  }
  EXPECT_TRUE(ReadXml(document).ok());
}

TEST(XmlReader, RefusesWhatIsMalformedAndSaysWhere) {
  for (const char* text : {"", "x", "<", "<>", "<a", "<a b>", "<a b=c></a>", "<a></b>", "<a>&bogus;</a>", "<a>&#0;</a>",
                           "<a>&#xD800;</a>", "<a>&#99999999;</a>", "<a></a><b></b>",
                           "<!DOCTYPE x [<!ENTITY y 'z'>]><a>&y;</a>", "<a><![CDATA[x</a>", "</a>", "<a b=\"1></a>"}) {
    EXPECT_FALSE(ReadXml(text).ok()) << text;
  }
  const Result<Element> read = ReadXml("<a>\n  <b>\n  </c>\n</a>");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().line, 3);
}

TEST(XmlReader, RefusesDeepNestingAndTooManyElements) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_FALSE(ReadXml(deep).ok());
  std::string wide = "<a>";
  for (int i = 0; i < 50; ++i) wide += "<b/>";
  wide += "</a>";
  EXPECT_TRUE(ReadXml(wide).ok());
  EXPECT_FALSE(ReadXml(wide, {.max_depth = 10, .max_elements = 20}).ok());
}

TEST(ReadMessage, NeedsAnSmlRootAndADoctype) {
  EXPECT_FALSE(ReadMessage("<xml doctype='call'></xml>").ok());
  EXPECT_FALSE(ReadMessage("<sml></sml>").ok());
  EXPECT_FALSE(ReadMessage("<sml doctype='letter'></sml>").ok());
  const Result<Message> message = ReadMessage("<sml doctype='response' ack='x7' id='y'/>");
  ASSERT_TRUE(message.ok());
  EXPECT_EQ(message.value().ack, "x7");
}

TEST(InputWme, IsWrittenByItsTypeAndReadsBack) {
  Element command("command");
  InputWme wme;
  wme.tag = -4;
  wme.id = "p2";
  wme.attribute = "distance";
  wme.type = InputWme::Type::kDouble;
  wme.real = 50.25;
  AddWme(command, wme);
  wme.type = InputWme::Type::kInt;
  wme.integer = -7;
  AddWme(command, wme);
  wme.type = InputWme::Type::kString;
  wme.text = "far";
  AddWme(command, wme);
  wme.type = InputWme::Type::kId;
  wme.text = "p3";
  AddWme(command, wme);
  wme.add = false;
  AddWme(command, wme);
  const std::string start = R"(<wme action="add" attr="distance" id="p2" tag="-4")";
  EXPECT_EQ(ToXml(command), "<command>" + start + R"( valtype="double" value="50.25"></wme>)" + start +
                                R"( valtype="int" value="-7"></wme>)" + start + R"( value="far"></wme>)" + start +
                                R"( valtype="id" value="p3"></wme><wme action="remove" tag="-4"></wme></command>)");

  Element again("command");
  for (const Element& element : command.children) AddWme(again, ReadWme(element));
  EXPECT_EQ(ToXml(again), ToXml(command));
}

TEST(FrameReader, CutsPiecesOfAnySizeIntoMessages) {
  const std::string stream = Frame("one") + Frame("") + Frame("two") + Frame(std::string(1000, 'x'));
  for (std::size_t piece : {std::size_t{1}, std::size_t{3}, std::size_t{7}, stream.size()}) {
    FrameReader reader;
    std::vector<std::string> messages;
    for (std::size_t i = 0; i < stream.size(); i += piece) EXPECT_TRUE(reader.Feed(stream.substr(i, piece), messages));
    ASSERT_EQ(messages.size(), 3u);
    EXPECT_EQ(messages[1], "two");
    EXPECT_EQ(messages[2].size(), 1000u);
    EXPECT_EQ(reader.pending(), 0u);
  }
}

TEST(FrameReader, GivesUpOnALengthAboveTheLimit) {
  FrameReader reader(1000);
  std::vector<std::string> messages;
  EXPECT_FALSE(reader.Feed(std::string("\xFF\xFF\xFF\xFF", 4), messages));
  EXPECT_FALSE(reader.Feed("more", messages));
}

TEST(ShortDouble, IsReadableAndReadsBack) {
  EXPECT_EQ(ShortDouble(0), "0");
  EXPECT_EQ(ShortDouble(100.0), "100");
  EXPECT_EQ(ShortDouble(50.25), "50.25");
  EXPECT_EQ(ShortDouble(1e-10), "1e-10");
  EXPECT_EQ(ShortDouble(123456789.1234567), "123456789.1234567");
  EXPECT_EQ(FixedDouble(2.5), "2.500000");
}

}  // namespace
}  // namespace soarbox::wire
