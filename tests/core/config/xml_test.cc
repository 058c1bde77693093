// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/config/xml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "latchwork/config/agent.h"

namespace latchwork::config {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

std::vector<std::string> Errors(std::string_view text) {
  std::vector<std::string> lines;
  for (const auto& d : ReadXmlText(text, "x", AgentSchema()).diagnostics) {
    std::string line = std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + ": ";
    line += d.message;
    if (!d.hint.empty()) line += " [" + d.hint + "]";
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string Agent(std::string_view content) {
  return "<agent format=\"1\" name=\"a\" duration=\"1s\">\n" + std::string(content) + "\n</agent>";
}

/// Where a sanitizer watches, this also tells whether what the threads share is shared well; the
/// first test, since what is shared is completed by the first texts.
TEST(XmlTest, AnyNumberOfThreadsReadAtTheSameTime) {
  const std::string text = Agent("<event at=\"1s\" fact=\"p\"/><event at=\"1s\"/><wrld/>");
  std::vector<std::vector<std::string>> errors(4);
  {
    std::vector<std::jthread> threads;
    for (auto& each : errors) threads.emplace_back([&each, &text] { each = Errors(text); });
  }
  EXPECT_THAT(errors.front(), Not(IsEmpty()));
  EXPECT_THAT(errors, Each(errors.front()));
}

TEST(XmlTest, KeepsPlacesOfElementsAndValues) {
  const XmlFile file = ReadXmlText(
      "<?xml version=\"1.0\"?>\r\n<!-- <a> -->\r\n<a>\r\n  <b c='é'\n d = \"2\"/>t</a>", "x", "");
  ASSERT_THAT(file.diagnostics, IsEmpty());
  EXPECT_TRUE(file.complete);
  EXPECT_EQ(file.root.text, "t");
  EXPECT_EQ(file.root.place.line, 3U);
  const Element& b = file.root.children.at(0);
  EXPECT_EQ(b.place.line, 4U);
  EXPECT_EQ(b.place.column, 3U);
  EXPECT_EQ(b.Find("c")->value, "é");
  EXPECT_EQ(b.Find("c")->place.column, 9U);
  EXPECT_EQ(b.Find("d")->name_place.column, 2U);
  EXPECT_EQ(b.Find("d")->place.column, 7U);
  EXPECT_EQ(b.Find("e"), nullptr);
}

TEST(XmlTest, UnknownElementIsReportedOnceWithTheNearestName) {
  EXPECT_THAT(Errors(Agent("<wier from=\"a.b\" foo=\"1\"><deep/></wier>")),
              ElementsAre("2:1: <wier> is not allowed in <agent> [did you mean 'wire'?]"));
}

TEST(XmlTest, MisplacedElementsAreAllReported) {
  EXPECT_THAT(
      Errors(Agent("<world plugin=\"w\"><fact port=\"p\"/><event at=\"1s\" fact=\"f\"/></world>")),
      ElementsAre("2:19: <fact> is not allowed in <world> [allowed: param]",
                  "2:35: <event> is not allowed in <world> [allowed: param]"));
}

TEST(XmlTest, UnknownAttributeIsNotAlsoMissing) {
  EXPECT_THAT(Errors(Agent("<event att=\"1s\" fact=\"f\"/>")),
              ElementsAre("2:8: <event> has no attribute 'att' [did you mean 'at'?]"));
}

TEST(XmlTest, MissingAttributeIsReportedWithWhatItIs) {
  EXPECT_THAT(Errors(Agent("<include/>")),
              ElementsAre("2:1: <include> lacks the attribute 'file' [it is the path of a file]"));
}

TEST(XmlTest, WrongValuesAreReportedWithWhatIsAllowed) {
  EXPECT_THAT(
      Errors(Agent("<event at=\"soon\" fact=\"f\"/><wire from=\"a\" to=\"b.c\"/>")),
      ElementsAre("2:12: 'soon' is not a duration (a number and us, ms, s, min or h, as in 100ms, "
                  "1.5s or 2min)",
                  "2:40: 'a' is not the address of a port: a part, a dot, a port, as in "
                  "world.sonar"));
}

TEST(XmlTest, TextWhereNoneBelongsIsReported) {
  EXPECT_THAT(Errors(Agent("hello")), ElementsAre("1:1: text is not allowed in <agent>"));
}

TEST(XmlTest, NamespaceIsReported) {
  EXPECT_THAT(Errors("<agent xmlns=\"n\"/>"),
              ElementsAre("1:1: the root of the file is <{n}agent>, which is not known [write it "
                          "without a namespace]"));
}

TEST(XmlTest, UnknownRootIsReported) {
  EXPECT_THAT(Errors("<agnet/>"), ElementsAre("1:1: the root of the file is <agnet>, which is not "
                                              "known [did you mean 'agent'?]"));
}

TEST(XmlTest, MalformedXmlIsReportedAfterWhatCameBefore) {
  EXPECT_THAT(Errors("<agent format=\"1\" name=\"a\" duration=\"x\">\n<wire></agent>"),
              ::testing::Contains("2:9: this is not well-formed XML: expected end of tag 'wire'"));
}

TEST(XmlTest, DocumentTypeIsRefused) {
  constexpr std::string_view kRefused =
      "2:1: a document type declaration (<!DOCTYPE ...>) is not allowed";
  EXPECT_THAT(Errors("<?xml version=\"1.0\"?>\n<!DOCTYPE a SYSTEM \"file:///etc/passwd\"><agent/>"),
              ElementsAre(kRefused));
  EXPECT_THAT(Errors("\n<!DOCTYPE a [<!ENTITY b \"c\">]><agent/>"), ElementsAre(kRefused));
}

TEST(XmlTest, SchemaLocationsAreNotFetched) {
  EXPECT_THAT(Errors("<agent format=\"1\" name=\"a\" duration=\"1s\" "
                     "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
                     "xsi:noNamespaceSchemaLocation=\"http://localhost:1/none.xsd\"/>"),
              IsEmpty());
}

TEST(XmlTest, TextsThatAreNoUtf8AreRefused) {
  using namespace std::string_view_literals;
  EXPECT_THAT(Errors(""), ElementsAre("0:0: the file is empty"));
  EXPECT_THAT(Errors("\xff\xfe<\0"sv), ElementsAre("0:0: the file is UTF-16 [save it as UTF-8]"));
  EXPECT_THAT(Errors("<a\n\0"sv), ElementsAre("2:1: a zero byte: this is a binary file, not text"));
  EXPECT_THAT(Errors("<a>\n\xc3("),
              ElementsAre("2:1: byte 0xc3 is not UTF-8 [save the file as UTF-8]"));
}

TEST(XmlTest, ByteOrderMarkIsSkipped) {
  EXPECT_THAT(Errors("\xef\xbb\xbf" + Agent("")), IsEmpty());
}

TEST(XmlTest, DepthIsLimited) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "<a>";
  const XmlFile file = ReadXmlText(text, "x", "");
  ASSERT_EQ(file.diagnostics.size(), 1U);
  EXPECT_EQ(file.diagnostics[0].message, "elements are nested more than 256 deep");
  EXPECT_FALSE(file.complete);
}

TEST(XmlTest, SizeAndNumberOfElementsAreLimited) {
  std::string text = "<a>";
  for (std::size_t i = 0; i < kMaxXmlElements; ++i) text += "<b/>";
  EXPECT_EQ(ReadXmlText(text, "x", "").diagnostics.at(0).message,
            "the file has more than 20000 elements");
  EXPECT_EQ(ReadXmlText(std::string(kMaxXmlBytes + 1, ' '), "x", "").diagnostics.at(0).message,
            "the file is larger than 16 MiB");
}

TEST(XmlTest, FilesThatAreNoneAreRefused) {
  EXPECT_EQ(ReadXml("/", AgentSchema()).diagnostics.at(0).message,
            "this is a directory, not a file");
  EXPECT_EQ(ReadXml("/dev/zero", AgentSchema()).diagnostics.at(0).message,
            "this is not a regular file");
}

}  // namespace
}  // namespace latchwork::config
