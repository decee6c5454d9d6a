#include "app/cli/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "support/json.hpp"
#include "support/sha256.hpp"

namespace fixproof::cli {

namespace {

void put(std::string& page, std::string_view place, std::string_view contents) {
  const std::size_t at = page.find(place);
  if (at == std::string::npos || page.find(place, at + 1) != std::string::npos) {
    throw std::logic_error(fmt::format("the page must have {} exactly once", place));
  }
  page.replace(at, place.size(), contents);
}

/// An inline script or style, and the source expression that lets a Content-Security-Policy run it.
struct Inline {
  std::string element;
  std::string hash;
};

Inline inline_element(std::string_view name, std::string_view text) {
  const std::string content = fmt::format("\n{}\n", text);
  const support::Sha256 digest = support::sha256(std::as_bytes(std::span(content)));
  return {fmt::format("<{0}>{1}</{0}>", name, content),
          fmt::format("'sha256-{}'", base64(std::string(digest.begin(), digest.end())))};
}

Inline script(std::string_view code) {
  for (const std::string_view end : {"</script", "<!--"}) {
    if (code.find(end) != std::string_view::npos) {
      throw std::logic_error(fmt::format("a script of the page contains {}", end));
    }
  }
  return inline_element("script", code);
}

std::string figure_of(const PagePicture& picture) {
  return fmt::format(
      "<figure class=\"scene\"><img width=\"320\" height=\"240\" alt=\"Animation: {0}\" "
      "src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
      escaped_html(picture.name), base64(picture.png));
}

/// Shows the picture at full size in a scrolling box, because scaling would hide single pixels.
std::string beside_of(const PagePicture& picture) {
  if (picture.beside.empty()) return {};
  return fmt::format(
      "<figure class=\"beside\"><div class=\"scroll\" tabindex=\"0\" role=\"group\" "
      "aria-label=\"{0}: as stepped, exact, and where they differ\"><img alt=\"{0}: as stepped, "
      "exact, and where they differ\" src=\"data:image/png;base64,{1}\"></div><figcaption>{0}, the "
      "last frame. In all frames: {2}</figcaption></figure>\n",
      escaped_html(picture.name), base64(picture.beside), escaped_html(picture.beside_text));
}

}  // namespace

std::string escaped_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string script_json(const support::Json& json) {
  // In JSON, < occurs only in strings. dump() replaces invalid UTF-8, which file names may contain.
  std::string text;
  for (const char c : json.dump(-1, ' ', false, support::Json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group <<= 8U;
      if (k < have) group |= static_cast<std::uint8_t>(bytes[i + k]);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= have ? digits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

std::string assemble_page(const PageParts& parts, const support::Json& report,
                          const std::vector<PagePicture>& pictures, std::string_view strip) {
  std::string shown;
  std::string beside;
  for (const PagePicture& picture : pictures) {
    shown += figure_of(picture);
    beside += beside_of(picture);
  }
  std::string page(parts.page);
  // The project's own parts come first, so that put() finds no marker in scene texts or libraries.
  const Inline style = inline_element("style", parts.style);
  const Inline charts = script(parts.charts);
  const Inline d3 = script(parts.d3);
  const Inline plot = script(parts.plot);
  put(page, "<!--script-hashes-->", fmt::format("{} {} {}", d3.hash, plot.hash, charts.hash));
  put(page, "<!--style-hash-->", style.hash);
  put(page, "<!--style-->", style.element);
  put(page, "<!--pictures-->", shown);
  put(page, "<!--beside-->",
      beside.empty() ? "<p>None of these scenes has stepped surfaces.</p>" : beside);
  put(page, "<!--strip-->", strip);
  put(page, "<!--data-->",
      fmt::format("<script type=\"application/json\" id=\"data\">{}</script>",
                  script_json(report)));
  put(page, "<!--charts-->", charts.element);
  put(page, "<!--libraries-->", d3.element + '\n' + plot.element);
  return page;
}

}  // namespace fixproof::cli
