// SPDX-License-Identifier: BSD-3-Clause
//
// The report in a browser, where one is installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "core/process/child_process.h"
#include "core/process/spawn.h"
#include "tests/apps/compare/trial.h"
#include "tests/temporary_folder.h"

namespace latchwork::compare {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string ReadFile(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

class BrowserTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (process::FindProgram("chromium").empty()) GTEST_SKIP() << "chromium is not installed";
  }

  /// Opens a page; what it prints on the standard output, with all that it logs in log().
  std::string Open(const std::string& page, const std::string& option) {
    folder_.Write("page.html", page);
    const std::string script =
        "cd '" + folder_.path().string() +
        "' && exec chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync "
        "--user-data-dir=profile --virtual-time-budget=2000 --enable-logging=stderr --v=0 " +
        option + " page.html 2>log";
    const std::atomic<bool> stop = false;
    const process::ChildResult result =
        process::RunChild("/bin/sh", {"-c", script}, {50, 1ULL << 40U}, stop);
    EXPECT_EQ(result.end, process::ChildResult::End::kExited) << result.errors << Log();
    EXPECT_EQ(result.code, 0) << Log();
    return result.output;
  }

  std::string Log() const { return ReadFile(folder_.path() / "log"); }

  /// How wide the page is, and how wide it asks to be, on a screen of 360 pixels. A window
  /// cannot be that narrow, a frame can.
  std::pair<int, int> WidthsOnATelephone(std::string report) {
    const std::string measure =
        "<script>addEventListener('load', () => parent.postMessage("
        "document.documentElement.clientWidth + ' ' + document.documentElement.scrollWidth, "
        "'*'))</script></body>";
    report.replace(report.rfind("</body>"), 7, measure);
    folder_.Write("report.html", report);
    const std::string dom = Open(
        "<!DOCTYPE html><body><script>addEventListener('message', "
        "event => document.title = `widths ${event.data}.`)</script>"
        "<iframe src=\"report.html\" style=\"width:360px;height:700px;border:0\"></iframe></body>",
        "--dump-dom");
    const std::size_t at = dom.find("widths ");
    int width = 0;
    int asked = 0;
    EXPECT_NE(at, std::string::npos) << dom;
    if (at == std::string::npos) return {};
    EXPECT_EQ(std::sscanf(dom.c_str() + at, "widths %d %d.", &width, &asked), 2) << dom;
    return {width, asked};
  }

  test::TemporaryFolder folder_;
};

TEST_F(BrowserTest, Page_OpensWithAllItsPictures) {
  const std::string dom = Open(Trial().Page(), "--dump-dom");
  EXPECT_THAT(Log(), Not(HasSubstr("CONSOLE")));
  EXPECT_EQ(Count(dom, "class=\"chart boxes\""), 1U);
  EXPECT_EQ(Count(dom, "class=\"chart curves\""), 1U);
  EXPECT_EQ(Count(dom, "class=\"chart ways\""), 4U);
  EXPECT_EQ(Count(dom, "class=\"box\""), 3U) << "bad has no times";
  EXPECT_EQ(Count(dom, "class=\"curve a"), 4U);
  EXPECT_EQ(Count(dom, "class=\"way a"), 48U);
}

TEST_F(BrowserTest, BrokenScript_IsNoticed) {
  Open("<!DOCTYPE html><script>nothing();</script>", "--dump-dom");
  EXPECT_THAT(Log(), HasSubstr("CONSOLE"));
}

TEST_F(BrowserTest, Page_FitsATelephone) {
  const auto [width, asked] = WidthsOnATelephone(Trial().Page());
  EXPECT_GT(width, 300);
  EXPECT_EQ(asked, width);
}

TEST_F(BrowserTest, PageThatIsTooWide_IsNoticed) {
  const auto [width, asked] = WidthsOnATelephone(
      "<!DOCTYPE html><body style=\"margin:0\"><div "
      "style=\"width:400px;height:900px\"></div></body>");
  EXPECT_LE(width, 360);
  EXPECT_EQ(asked, 400);
}

TEST_F(BrowserTest, Page_Prints) {
  Open(Trial().Page(), "--print-to-pdf=report.pdf");
  const std::string pdf = ReadFile(folder_.path() / "report.pdf");
  EXPECT_THAT(pdf.substr(0, 5), "%PDF-");
  EXPECT_GE(Count(pdf, "/Count "), 1U);
  EXPECT_THAT(pdf, Not(HasSubstr("/Count 0")));
}

}  // namespace
}  // namespace latchwork::compare
