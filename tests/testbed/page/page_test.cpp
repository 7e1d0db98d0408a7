// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pages as text. Everything a caller gives is escaped, numbers read as people write them, and pictures are inside. What
// cannot become a page is refused before a file is written.

#include "testbed/page/page.h"
#include "testbed/base/errors.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <regex>
#include <set>
#include <span>
#include <stdexcept>

#include "testbed/jobs/snapshot/page.h"
#include "testbed/page/page_markup.h"
#include "testbed/picture/png.h"
#include "tests/testbed/page/sample_pages.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;

TEST(PageMarkup, EscapesWhatMarkupWouldRead) {
    EXPECT_EQ(EscapeHtml("a < b && c > \"d\""), "a &lt; b &amp;&amp; c &gt; &quot;d&quot;");
    EXPECT_EQ(MakeParagraphs("one `<x>` two\n\nthree"), "<p>one <code>&lt;x&gt;</code> two</p>\n<p>three</p>\n");
    EXPECT_EQ(MakeParagraphs("open `quote"), "<p>open <code>quote</code></p>\n");
    EXPECT_EQ(MakeParagraphs(""), "");
    EXPECT_EQ(ProtectJson(R"({"a":"</script><!--"})"), R"({"a":"\u003c/script>\u003c!--"})");
}

TEST(PageMarkup, EncodesBase64AsTheStandardSays) {
    // The vectors of RFC 4648, section 10.
    const std::array<std::pair<std::string, std::string>, 7> vectors = {{{"", ""},
                                                                         {"f", "Zg=="},
                                                                         {"fo", "Zm8="},
                                                                         {"foo", "Zm9v"},
                                                                         {"foob", "Zm9vYg=="},
                                                                         {"fooba", "Zm9vYmE="},
                                                                         {"foobar", "Zm9vYmFy"}}};
    for (const auto& [plain, encoded] : vectors) {
        EXPECT_EQ(EncodeBase64(std::vector<unsigned char>(plain.begin(), plain.end())), encoded);
    }
    EXPECT_EQ(EncodeBase64(std::vector<unsigned char>{0xfb, 0xff, 0xbf}), "+/+/");
}

TEST(PageMarkup, RefusesFilesThatItCannotEmbed) {
    const ScratchFolder scratch;
    EXPECT_THROW((void)MakeDataUri(scratch.GetPath() / "none.png"), FileError);
    EXPECT_THROW((void)MakeDataUri(scratch.GetPath() / "page.gif"), FileError);
}

TEST(PageCell, WritesNumbersAsPeopleReadThem) {
    EXPECT_EQ(PageCell::Number(1234567.891, 1).text, "1,234,567.9");
    EXPECT_EQ(PageCell::Number(-1234).text, "−1,234");
    EXPECT_EQ(PageCell::Number(999).text, "999");
    EXPECT_EQ(PageCell::Number(-0.04, 1).text, "0.0");  // no minus before a zero
    EXPECT_EQ(PageCell::Number(1e15).text, "1,000,000,000,000,000");
    EXPECT_EQ(PageCell::Number(0.1, 3).value, 0.1);
    for (const double none : {static_cast<double>(NAN), HUGE_VAL, -HUGE_VAL}) {
        EXPECT_EQ(PageCell::Number(none).text, "–");
        EXPECT_FALSE(PageCell::Number(none).value.has_value());
    }
}

TEST(Page, HoldsEveryBlockEscapedAndOnce) {
    const ScratchFolder scratch;
    const std::string whole = MakePage(MakeSamplePage(scratch.GetPath()));
    const std::string html = whole.substr(0, whole.rfind("<script>"));  // behind it stand a library and our scripts
    EXPECT_NE(whole.find("Chart.js"), std::string::npos) << "a figure with its data needs the library";
    EXPECT_EQ(MakePage(Page{.title = "x"}).find("Chart.js v"), std::string::npos) << "and no other page has it";
    EXPECT_NE(html.find("game \\u003c/script\\u003e"), std::string::npos);
    EXPECT_NE(html.find("<title>Sample &amp; &lt;report&gt;</title>"), std::string::npos);
    EXPECT_NE(html.find("&lt;none&gt; &amp; &quot;quoted&quot;"), std::string::npos);
    EXPECT_EQ(html.find("<none>"), std::string::npos);
    EXPECT_EQ(html.find("{{"), std::string::npos) << "a name of the frame was not filled in";
    EXPECT_NE(html.find("src=\"data:image/png;base64,"), std::string::npos);
    EXPECT_NE(html.find("src=\"data:image/svg+xml;base64,"), std::string::npos);
    EXPECT_EQ(html.find(scratch.GetPath().string()), std::string::npos) << "a path of this machine";

    static const std::regex id(" id=\"([^\"]*)\"");
    std::set<std::string> ids;
    for (auto it = std::sregex_iterator(html.begin(), html.end(), id); it != std::sregex_iterator(); ++it) {
        EXPECT_TRUE(ids.insert((*it)[1]).second) << "twice: " << (*it)[1];
    }
    EXPECT_TRUE(ids.contains("numbers") && ids.contains("numbers-2")) << "two sections of one title";
}

TEST(Page, RefusesWhatIsNoPageAndLeavesNoFile) {
    const ScratchFolder scratch;
    const fs::path path = scratch.GetPath() / "page.html";
    Page page{.title = "x"};
    PageTable table{.columns = {{.name = "a"}, {.name = "b"}}};
    table.rows = {{"only one"}};
    page.sections.push_back({.blocks = {table}});
    EXPECT_THROW(WritePage(path, page), std::invalid_argument);
    page.sections = {{.blocks = {PageFigures{.figures = {{.title = "nothing"}}}}}};
    EXPECT_THROW(WritePage(path, page), std::invalid_argument);
    page.sections = {{.blocks = {PageFigures{.figures = {{.file = scratch.GetPath() / "none.png"}}}}}};
    EXPECT_THROW(WritePage(path, page), FileError);
    page = {.title = "x", .script = "'</script>'"};
    EXPECT_THROW(WritePage(path, page), std::invalid_argument);
    EXPECT_TRUE(fs::is_empty(scratch.GetPath()));
    EXPECT_THROW(WritePage(scratch.GetPath() / "no" / "page.html", Page{.title = "x"}), FileError);
}

TEST(SnapshotPage, NamesEveryCaseAndNeedsItsFiles) {
    const ScratchFolder scratch;
    const SampleComparison sample = MakeSampleComparison(scratch.GetPath());
    const std::string html = MakePage(MakeSnapshotPage(scratch.GetPath(), sample.origin, sample.results));
    for (const SnapshotResult& result : sample.results) {
        EXPECT_NE(html.find("\"id\":\"" + result.id + "\""), std::string::npos) << result.id;
    }
    EXPECT_NE(html.find("<h1>Pictures: differences</h1>"), std::string::npos);
    const SnapshotResult equal = sample.results.front();
    EXPECT_NE(MakePage(MakeSnapshotPage(scratch.GetPath(), sample.origin, std::span(&equal, 1))).find("all equal</h1>"),
              std::string::npos);

    fs::remove(scratch.GetPath() / sample.results[1].difference);
    EXPECT_THROW((void)WriteSnapshotPage(scratch.GetPath(), sample.origin, sample.results), FileError);
    EXPECT_FALSE(scratch.Has("index.html"));
}

TEST(SnapshotPage, IsLeftByDiff) {
    const ScratchFolder scratch;
    Image image(32, 16, {40, 40, 40});
    WritePng(scratch.GetPath() / "first.png", image);
    image.At(3, 5) = {200, 0, 0};
    WritePng(scratch.GetPath() / "second.png", image);
    const ProgramResult result = scratch.Run("diff first.png second.png -o out");
    EXPECT_EQ(result.exitCode, 1) << result.output;
    EXPECT_NE(result.output.find("report: out/index.html"), std::string::npos) << result.output;
    const std::string html = scratch.Read("out/index.html");
    EXPECT_NE(html.find("\"id\":\"first\""), std::string::npos);
    EXPECT_NE(html.find("\"box\":[3,5,4,6]"), std::string::npos);
    EXPECT_NE(html.find("\"difference\":\"data:image/png;base64,"), std::string::npos);
}

}  // namespace
}  // namespace testbed
