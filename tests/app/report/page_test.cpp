// Tests the page as text: names and data must not break out of their places.
#include "app/cli/report/page.hpp"

#include <map>
#include <regex>
#include <span>
#include <stdexcept>

#include "support/json.hpp"
#include "support/sha256.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

constexpr std::string_view places =
    "<!--script-hashes--><!--style-hash--><!--style--><!--pictures--><!--beside--><!--strip-->"
    "<!--data--><!--libraries--><!--charts-->";

/// The source expression of a Content-Security-Policy for an element with this text.
std::string hash_of(std::string_view text) {
  const support::Sha256 digest = support::sha256(std::as_bytes(std::span(text)));
  return "'sha256-" + cli::base64(std::string(digest.begin(), digest.end())) + "'";
}

/// The sources that a directive of the page's policy allows, separated by spaces.
std::string allowed_by(const std::string& page, const std::string& directive) {
  std::smatch found;
  const std::regex policy("Content-Security-Policy\" content=\"[^\"]*\\b" + directive +
                          " ([^;\"]*)[;\"]");
  return std::regex_search(page, found, policy) ? found[1].str() : "no " + directive;
}

TEST(Page, EscapesHtml) {
  EXPECT_EQ(cli::escaped_html("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
}

// The test vectors of RFC 4648, section 10, and the two digits that are not alphanumeric.
TEST(Page, WritesBase64) {
  EXPECT_EQ(cli::base64(""), "");
  EXPECT_EQ(cli::base64("f"), "Zg==");
  EXPECT_EQ(cli::base64("fo"), "Zm8=");
  EXPECT_EQ(cli::base64("foo"), "Zm9v");
  EXPECT_EQ(cli::base64("foob"), "Zm9vYg==");
  EXPECT_EQ(cli::base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(cli::base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(cli::base64("\xFB\xFF\xBF"), "+/+/");
}

TEST(Page, DataCannotEndItsScript) {
  const support::Json json{{"name", "</script><!-- \"x\\"}, {"value", 0.25}};
  const std::string text = cli::script_json(json);
  EXPECT_EQ(text.find('<'), std::string::npos) << text;
  EXPECT_EQ(support::Json::parse(text), json);
}

TEST(Page, TakesNamesThatAreNoUtf8) {
  const std::string text = cli::script_json({{"name", "\xFF"}});
  // U+FFFD replaces invalid UTF-8.
  EXPECT_EQ(nlohmann::json::parse(text).at("name"), "\xEF\xBF\xBD");
}

TEST(Page, HasEverythingInItsPlace) {
  const std::string page =
      cli::assemble_page({places, "STYLE", "D3", "PLOT", "CHARTS"}, {{"n", 7}},
                         {{"a \"<b>\" scene", "foobar", "foo", "3 of <4>"}}, "<svg>STRIP</svg>");
  for (const char* part :
       {"<style>\nSTYLE\n</style>", "<script>\nD3\n</script>", "\nPLOT\n", "\nCHARTS\n",
        "<svg>STRIP</svg>", "{\"n\":7}", "alt=\"Animation: a &quot;&lt;b&gt;&quot; scene\"",
        "src=\"data:image/png;base64,Zm9vYmFy\"", "src=\"data:image/png;base64,Zm9v\"",
        "In all frames: 3 of &lt;4&gt;<"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
  }
  EXPECT_LT(page.find("D3"), page.find("PLOT"));
  EXPECT_LT(page.find("PLOT"), page.find("CHARTS"));
  EXPECT_EQ(page.find("<!--"), std::string::npos) << page;
}

TEST(Page, SaysThatNothingIsStepped) {
  const std::string page =
      cli::assemble_page({places, "", "", "", ""}, {}, {{"flat", "foobar", "", ""}}, "");
  EXPECT_NE(page.find("None of these scenes has stepped surfaces"), std::string::npos) << page;
  EXPECT_EQ(page.find("class=\"beside\""), std::string::npos) << page;
}

TEST(Page, RefusesPartsThatWouldBreakIt) {
  EXPECT_THROW(cli::assemble_page({places, "", "a</script>b", "", ""}, {}, {}, ""),
               std::logic_error);
  EXPECT_THROW(cli::assemble_page({places, "", "", "", "<!--"}, {}, {}, ""), std::logic_error);
  EXPECT_THROW(cli::assemble_page({places.substr(1), "", "", "", ""}, {}, {}, ""),
               std::logic_error);
}

// The page must not load anything from elsewhere.
TEST(Page, IsSelfContained) {
  const cli::PageParts parts = cli::page_parts();
  const std::string page = cli::assemble_page(parts, support::Json::object(), {}, "");
  for (const char* outside : {"src=\"http", "href=\"http", "@import", "url(http"}) {
    EXPECT_EQ(std::string(parts.page).find(outside), std::string::npos) << outside;
    EXPECT_EQ(std::string(parts.style).find(outside), std::string::npos) << outside;
    EXPECT_EQ(std::string(parts.charts).find(outside), std::string::npos) << outside;
  }
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

// The example of the specification, https://www.w3.org/TR/CSP3/#external-hash.
TEST(Page, HashesAsBrowsersDo) {
  EXPECT_EQ(hash_of("alert('Hello, world.');"),
            "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='");
}

TEST(Page, AllowsItsOwnScriptsAndStylesOnly) {
  const cli::PageParts parts = cli::page_parts();
  const std::string page = cli::assemble_page(parts, support::Json::object(), {}, "");
  // The elements as a browser sees them.
  std::map<std::string, std::string> hashes;
  for (const std::string name : {"style", "script"}) {
    const std::string begin = "<" + name + ">";
    for (std::size_t at = page.find(begin); at != std::string::npos;
         at = page.find(begin, at + 1)) {
      const std::size_t text = at + begin.size();
      hashes[name] += hash_of(page.substr(text, page.find("</" + name + ">", text) - text)) + " ";
    }
  }
  // Plot puts this style, with the class that it gives every chart, into every chart.
  const std::string_view mark = "append(\"style\").text(`:where(.${c}) {";
  const std::size_t begin = parts.plot.find(mark) + mark.find(':');
  ASSERT_LT(begin, parts.plot.size());
  std::string plot(parts.plot.substr(begin, parts.plot.find('`', begin) - begin));
  plot = std::regex_replace(plot, std::regex(R"(\$\{c\})"), "plot-d6a7b5");
  plot = std::regex_replace(plot, std::regex(R"(\\n)"), "\n");
  EXPECT_EQ(allowed_by(page, "script-src") + " ", hashes["script"]);
  EXPECT_EQ(allowed_by(page, "style-src"), hashes["style"] + hash_of(plot));
  EXPECT_EQ(page.find("unsafe-"), std::string::npos);
}

}  // namespace
